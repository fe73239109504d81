// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Sums that come out the same in any order and on any number of ranks.

#include <span>

#include "core/ranks.hpp"

namespace packbed {

/// Sum of all ranks' terms. Each term is rounded to 2^-60 of the largest one and added as an integer,
/// so nothing depends on the order. NaN if a term is not finite.
double order_independent_sum(std::span<const double> terms, const Ranks& ranks);

}  // namespace packbed
