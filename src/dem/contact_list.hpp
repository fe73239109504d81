// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Pairs of beads that touch or are about to, each with its springs, in blocks of 32 lanes.
/// Sorted by (i, j, image), i before j in the order of the beads.

#include <cstdint>
#include <vector>

#include "core/aligned.hpp"
#include "dem/contact/contact.hpp"
#include "dem/contact/friction.hpp"
#include "dem/domain.hpp"

namespace packbed::dem {

/// One pair. It is bead i with the image of bead j at x_j + offset(image): the shift is stored,
/// never guessed from the nearest image, which would be wrong in a thin slice.
struct PairContact {
  std::int32_t i = 0;
  std::int32_t j = 0;
  Image image{};
  Coefficients coefficients;
  History history;
};

inline constexpr int lanes = 32;

struct alignas(64) ContactBlock {
  double spring[3][lanes];
  double angle[3][lanes];
  double coefficient[3][lanes];
  std::int32_t i[lanes];
  std::int32_t j[lanes];
  std::int8_t image[3][lanes];  ///< of j, one row per axis
};

/// The blocks of a list of pairs. Lanes left over hold the two dummies.
class ContactList {
 public:
  ContactList() = default;
  /// `pairs` sorted; `dummy` is the first of the two dummies, the number of beads.
  ContactList(const std::vector<PairContact>& pairs, const Domain& domain, std::int32_t dummy);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Lengths of the periodic box, by which images are shifted [m].
  [[nodiscard]] const Vec3& box() const { return box_; }
  [[nodiscard]] PairContact pair(std::size_t k) const;
  [[nodiscard]] std::vector<PairContact> pairs() const;

  AlignedVector<ContactBlock> blocks;

 private:
  std::size_t size_ = 0;
  Vec3 box_;
};

}  // namespace packbed::dem
