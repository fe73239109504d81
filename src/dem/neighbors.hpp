// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Renewal of the order of the beads and of the list of pairs. Everything that changes the order of
/// sums happens here and nowhere else.

#include <cstdint>
#include <vector>

#include "dem/contact_list.hpp"
#include "dem/domain.hpp"
#include "dem/particles.hpp"

namespace packbed::dem {

/// Takes beads that crossed a periodic side back inside; returns how often each was moved.
std::vector<Image> wrap(Particles& particles, const Domain& domain);

/// Order of the beads by one global key: cell of a fixed grid (z-slab, y-row, x), then x, then id.
/// `cell` is the width of that grid [m]; it must not change during a run.
std::vector<std::int32_t> key_order(const Particles& particles, const Domain& domain, double cell);

/// All pairs with at least one own bead and a gap below `skin` [m], sorted by (i, j, image). Images are
/// partners of their own. Works for any ratio of sizes and any thickness of a periodic side down to the largest diameter.
std::vector<PairKey> find_pairs(const Particles& particles, const Domain& domain, double skin);

/// The pairs of an old list in the new order of the beads, sorted. `place` is the new place of each
/// old bead, `wraps` its move over periodic sides (old order).
std::vector<PairContact> carry_over(const std::vector<PairContact>& old_pairs,
                                    const std::vector<std::int32_t>& place,
                                    const std::vector<Image>& wraps);

}  // namespace packbed::dem
