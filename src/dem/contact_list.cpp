// SPDX-License-Identifier: BSD-3-Clause
#include "dem/contact_list.hpp"

namespace packbed::dem {
namespace {

void put(double (&rows)[3][lanes], std::size_t lane, const Vec3& a) {
  rows[0][lane] = a.x;
  rows[1][lane] = a.y;
  rows[2][lane] = a.z;
}

Vec3 get(const double (&rows)[3][lanes], std::size_t lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

}  // namespace

ContactList::ContactList(const std::vector<PairContact>& pairs,
                         const Domain& domain,
                         std::int32_t dummy)
    : blocks((pairs.size() + lanes - 1) / lanes),
      size_(pairs.size()),
      box_(to_vec3(domain.size)) {
  PairContact none;
  none.i = dummy;
  none.j = dummy + 1;
  for (std::size_t k = 0; k < blocks.size() * lanes; ++k) {
    const auto& p = k < pairs.size() ? pairs[k] : none;
    auto& block = blocks[k / lanes];
    const auto lane = k % lanes;
    block.i[lane] = p.i;
    block.j[lane] = p.j;
    for (std::size_t axis = 0; axis < 3; ++axis) block.image[axis][lane] = p.image[axis];
    put(block.spring, lane, p.history.spring);
    put(block.angle, lane, p.history.angle);
    put(block.coefficient, lane, {p.coefficients.a, p.coefficients.b, p.coefficients.c});
  }
}

PairContact ContactList::pair(std::size_t k) const {
  const auto& block = blocks[k / lanes];
  const auto lane = k % lanes;
  const Vec3 c = get(block.coefficient, lane);
  return {.i = block.i[lane],
          .j = block.j[lane],
          .image = {block.image[0][lane], block.image[1][lane], block.image[2][lane]},
          .coefficients = {c.x, c.y, c.z},
          .history = {get(block.spring, lane), get(block.angle, lane)}};
}

std::vector<PairContact> ContactList::pairs() const {
  std::vector<PairContact> all;
  all.reserve(size_);
  for (std::size_t k = 0; k < size_; ++k) all.push_back(pair(k));
  return all;
}

}  // namespace packbed::dem
