// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "resin/resin.hpp"
#include "resin/size_distribution.hpp"
#include "setup/section.hpp"

namespace packbed::setup {

/// Reads [resin.sizes]; what it leaves out of a normal distribution comes from `resin`, which may
/// be null.
resin::SizeDistribution read_sizes(Section section,
                                   const UnitSystem& units,
                                   const resin::Resin* resin);

/// "library: thesis, table 6.1", the origin of a value in the echo.
std::string library_origin(const resin::Property& property);

}  // namespace packbed::setup
