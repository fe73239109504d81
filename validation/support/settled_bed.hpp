// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A bed that validations settle from a cloud as `packbed run` does it.

#include <cstdint>
#include <string>

#include "dem/dem.hpp"
#include "setup/case.hpp"

namespace packbed::validation {

struct Settled {
  setup::Case c;
  dem::Dem dem;
  std::int64_t steps;  ///< of time, from the cloud to rest
};

/// Carries out the first step, "settle", of a case file's text without its title, on one rank.
Settled settle(const std::string& text);

/// Height of the bed as it is now [m].
double height_of(const Settled& bed);

/// Share of the weight that neither floor nor walls carry.
double budget_error(const Settled& bed);

}  // namespace packbed::validation
