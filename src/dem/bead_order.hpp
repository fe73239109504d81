// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Places of beads in the periodic box, and their order.

#include <cstdint>
#include <vector>

#include "dem/domain.hpp"
#include "dem/particles.hpp"

namespace packbed::dem {

/// Takes beads that crossed a periodic side back inside; returns how often each was moved.
std::vector<Image> wrap(Particles& particles, const Domain& domain);

/// Order of the beads by one global key: cell of a fixed grid (strip of y-rows, z-slab,
/// y-row, x), then x, then id.
/// `cell` is the width of that grid [m]; it must not change during a run.
std::vector<std::int32_t> key_order(const Particles& particles, const Domain& domain, double cell);

/// Where each of `beads` beads went: the place of bead order[k] is k; -1 for beads not named.
std::vector<std::int32_t> places(const std::vector<std::int32_t>& order, std::size_t beads);

}  // namespace packbed::dem
