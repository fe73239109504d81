// SPDX-License-Identifier: BSD-3-Clause
#include "dem/contact_list.hpp"

#include <algorithm>

namespace packbed::dem {

ContactList::ContactList(const std::vector<PairContact>& pairs,
                         const Domain& domain,
                         std::int32_t dummy)
    : ContactList(domain, dummy) {
  reserve(pairs.size());
  for (const auto& p : pairs) push_back(p);
}

void ContactList::push_back(const PairContact& p) {
  const auto lane = static_cast<int>(size_ % lanes);
  if (lane == 0) {
    auto& block = blocks.emplace_back();
    std::fill_n(block.i, lanes, dummy_);
    std::fill_n(block.j, lanes, dummy_ + 1);
  }
  auto& block = blocks.back();
  block.i[lane] = p.i;
  block.j[lane] = p.j;
  for (std::size_t axis = 0; axis < 3; ++axis) block.image[axis][lane] = p.image[axis];
  put(block.spring, lane, p.history.spring);
  put(block.angle, lane, p.history.angle);
  put(block.coefficient, lane, {p.coefficients.a, p.coefficients.b, p.coefficients.c});
  ++size_;
}

PairKey ContactList::key(std::size_t k) const {
  const auto& block = blocks[k / lanes];
  const auto lane = static_cast<int>(k % lanes);
  return {.i = block.i[lane],
          .j = block.j[lane],
          .image = {block.image[0][lane], block.image[1][lane], block.image[2][lane]}};
}

PairContact ContactList::pair(std::size_t k) const {
  const auto& block = blocks[k / lanes];
  const auto lane = static_cast<int>(k % lanes);
  const Vec3 c = get(block.coefficient, lane);
  PairContact p{key(k), {}, {}};
  p.coefficients = {c.x, c.y, c.z};
  p.history = {get(block.spring, lane), get(block.angle, lane)};
  return p;
}

ContactList ContactList::part(std::size_t first, std::size_t last) const {
  ContactList list;
  list.box_ = box_;
  list.dummy_ = dummy_;
  list.size_ = std::min(last * lanes, size_) - std::min(first * lanes, size_);
  list.blocks.assign(blocks.begin() + static_cast<std::ptrdiff_t>(first),
                     blocks.begin() + static_cast<std::ptrdiff_t>(last));
  return list;
}

std::vector<PairContact> ContactList::pairs() const {
  std::vector<PairContact> all;
  all.reserve(size_);
  for (std::size_t k = 0; k < size_; ++k) all.push_back(pair(k));
  return all;
}

}  // namespace packbed::dem
