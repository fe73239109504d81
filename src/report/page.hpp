// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/quantity.hpp"
#include "report/run_data.hpp"

namespace packbed::report {

/// One HTML page that needs nothing but itself: of one run, or of several side by side. Runs with equal
/// titles are told apart by their folders.
std::string page(std::vector<RunData> runs, const UnitSystem& units);

}  // namespace packbed::report
