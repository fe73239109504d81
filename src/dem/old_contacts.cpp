// SPDX-License-Identifier: BSD-3-Clause
#include "dem/old_contacts.hpp"

#include <algorithm>
#include <utility>

namespace packbed::dem {
namespace {

constexpr std::size_t portion = 1 << 14;  // pairs, after which memory is given back
constexpr std::size_t large = 8U << 20U;  // bytes, below which it is not worth while

std::size_t old_place(const KnownPair& p) {
  return static_cast<std::size_t>(p.old >= 0 ? p.old : -1 - p.old);
}

}  // namespace

OldContacts::OldContacts(ContactList& list,
                         std::vector<KnownPair> known,
                         std::vector<PairContact> arrived)
    : list_(list), in_order_(false), known_(std::move(known)), arrived_(std::move(arrived)) {
  needed_from_.assign(known_.size() / portion + 1, list_.size());
  for (std::size_t n = known_.size(); n-- > 0;) {
    auto& from = needed_from_[n / portion];
    if ((n + 1) % portion == 0 && n + 1 < known_.size()) from = needed_from_[n / portion + 1];
    from = std::min(from, old_place(known_[n]));
  }
}

bool OldContacts::take(const PairKey& wanted, PairContact& found) {
  while (next_ < size() && key(next_) < wanted) {
    ++next_;
    if (next_ % portion == 0) give_back_before(next_);
  }
  if (next_ == size() || key(next_) != wanted) return false;
  found = contact(next_);
  return true;
}

PairContact OldContacts::contact(std::size_t n) const {
  if (in_order_) return list_.pair(n);
  const std::size_t k = old_place(known_[n]);
  PairContact c = k < list_.size() ? list_.pair(k) : arrived_[k - list_.size()];
  if (known_[n].old < 0) turn_around(c);
  static_cast<PairKey&>(c) = known_[n];
  return c;
}

void OldContacts::give_back_before(std::size_t n) {
  if (list_.blocks.size() * sizeof(ContactBlock) < large) return;
  const std::size_t k = in_order_ ? n : needed_from_[n / portion];
  if (given_back_ == nullptr) given_back_ = list_.blocks.data();
  given_back_ = give_back(given_back_, list_.blocks.data() + k / lanes);
}

}  // namespace packbed::dem
