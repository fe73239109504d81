// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/quantity.hpp"

namespace packbed::app {

/// Writes report.html of the run in `folder` there, and returns its path. Throws DataError.
std::filesystem::path write_report(const std::filesystem::path& folder, const UnitSystem& units);

}  // namespace packbed::app
