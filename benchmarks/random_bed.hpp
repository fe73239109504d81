// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Dense beds of random beads without overlap, not yet settled.

#include <cstdint>
#include <vector>

#include "benchmarks/beds.hpp"

namespace packbed::benchmarks {

/// Diameters of `count` coarse grains, 3 normal(86.9, 16.6) um, cut to 3 (49.7 to 142.7) um [m].
std::vector<double> coarse_grains(std::size_t count, std::uint64_t seed);

/// Diameters with equal volume per logarithm of size, `mean` times ratio^(-1/2) to ratio^(1/2) [m].
std::vector<double> wide_sizes(std::size_t count, double mean, double ratio, std::uint64_t seed);

/// Beads at random places at a solid fraction of 0.58, pushed apart.
Bed random_bed(const std::vector<double>& diameters,
               double width_x,
               double width_y,
               bool walls_in_x,
               std::uint64_t seed);

}  // namespace packbed::benchmarks
