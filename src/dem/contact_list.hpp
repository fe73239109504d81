// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Pairs of beads that touch or are about to, each with its springs, in blocks of 32 lanes.
/// Sorted by (i, j, image), i before j in the order of the beads.

#include <compare>
#include <cstdint>
#include <vector>

#include "core/aligned.hpp"
#include "dem/contact/contact.hpp"
#include "dem/contact/friction.hpp"
#include "dem/domain.hpp"

namespace packbed::dem {

/// Who is meant: bead i and the image of bead j at x_j + offset(image). The shift is stored, never
/// guessed from the nearest image, which would be wrong in a thin slice.
struct PairKey {
  std::int32_t i = 0;
  std::int32_t j = 0;
  Image image{};
  auto operator<=>(const PairKey&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

/// One pair.
struct PairContact : PairKey {
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

/// One lane of three rows.
inline void put(double (&rows)[3][lanes], int lane, const Vec3& a) {
  rows[0][lane] = a.x;
  rows[1][lane] = a.y;
  rows[2][lane] = a.z;
}

inline Vec3 get(const double (&rows)[3][lanes], int lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

/// The blocks of a list of pairs. Lanes left over hold the two dummies.
class ContactList {
 public:
  ContactList() = default;
  /// Empty. `dummy` is the first of the two dummies, the number of beads.
  ContactList(const Domain& domain, std::int32_t dummy)
      : box_(to_vec3(domain.size)), dummy_(dummy) {}
  /// `pairs` sorted.
  ContactList(const std::vector<PairContact>& pairs, const Domain& domain, std::int32_t dummy);

  /// Pairs come in their order.
  void push_back(const PairContact& p);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Lengths of the periodic box, by which images are shifted [m].
  [[nodiscard]] const Vec3& box() const { return box_; }
  [[nodiscard]] PairKey key(std::size_t k) const;
  [[nodiscard]] PairContact pair(std::size_t k) const;
  [[nodiscard]] std::vector<PairContact> pairs() const;
  void set_coefficients(std::size_t k, const Coefficients& c) {
    put(blocks[k / lanes].coefficient, static_cast<int>(k % lanes), {c.a, c.b, c.c});
  }

  /// The blocks [first, last) as a list of their own.
  [[nodiscard]] ContactList part(std::size_t first, std::size_t last) const;

  /// Room for `count` pairs, so that blocks are not moved while they come.
  void reserve(std::size_t count) { blocks.reserve((count + lanes - 1) / lanes); }

  AlignedVector<ContactBlock> blocks{};

 private:
  std::size_t size_ = 0;
  Vec3 box_;
  std::int32_t dummy_ = 0;
};

}  // namespace packbed::dem
