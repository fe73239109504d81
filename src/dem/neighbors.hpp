// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Renewal of the list of pairs. Everything that changes the order of sums happens here and in
/// dem/bead_order.hpp, and nowhere else.

#include <cstdint>
#include <vector>

#include "dem/bead_order.hpp"
#include "dem/contact_list.hpp"
#include "dem/domain.hpp"
#include "dem/particles.hpp"

namespace packbed::dem {

/// All pairs with at least one own bead and a gap below `skin` [m], sorted by (i, j, image). Images are
/// partners of their own. Works for any ratio of sizes and any thickness of a periodic side down to the largest diameter.
std::vector<PairKey> find_pairs(const Particles& particles, const Domain& domain, double skin);

/// A pair under its new name, and where the contact stands that it was.
struct KnownPair : PairKey {
  std::int32_t old =
      0;  ///< place in the old list; minus 1 minus it where i and j have changed sides
};

/// The pairs of an old list in the new order of the beads, not sorted; those that lack a bead are left out.
/// `place` is the new place of each old bead, or -1; `wraps` its move over periodic sides (old order).
std::vector<KnownPair> carry_over(const ContactList& old,
                                  const std::vector<std::int32_t>& place,
                                  const std::vector<Image>& wraps);

/// The pair of beads that are now i and j, whose image was `image` before they moved over periodic sides.
KnownPair renamed(std::int32_t i, std::int32_t j, const Image& image, std::int32_t old);

/// Sorts by (i, j, image), for `beads` beads.
void sort_pairs(std::vector<KnownPair>& pairs, std::size_t beads);

/// The contact as it is seen from the other end.
void turn_around(PairContact& p);

}  // namespace packbed::dem
