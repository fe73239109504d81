// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A list of contacts that is read for the last time, while a new one takes its springs over.

#include <cstdint>
#include <vector>

#include "dem/contact_list.hpp"
#include "dem/neighbors.hpp"

namespace packbed::dem {

/// Pairs are asked for in ascending order. What will not be asked for any more is given back to the system
/// on the way where the list is large, so that old and new list are never in memory as a whole.
class OldContacts {
 public:
  /// The order of the beads has not changed.
  explicit OldContacts(ContactList& list) : list_(list) {}
  /// It has: `known` tells how, sorted. Places from list.size() on are those of `arrived`.
  OldContacts(ContactList& list, std::vector<KnownPair> known, std::vector<PairContact> arrived);

  /// Whether the pair was listed; if so, `contact` becomes what it was.
  bool take(const PairKey& key, PairContact& contact);

 private:
  [[nodiscard]] std::size_t size() const { return in_order_ ? list_.size() : known_.size(); }
  [[nodiscard]] PairKey key(std::size_t n) const {
    return in_order_ ? list_.key(n) : static_cast<PairKey>(known_[n]);
  }
  [[nodiscard]] PairContact contact(std::size_t n) const;
  void give_back_before(std::size_t n);

  ContactList& list_;
  bool in_order_ = true;
  std::vector<KnownPair> known_{};
  std::vector<PairContact> arrived_{};
  std::vector<std::size_t> needed_from_{};  ///< place in the list, by portions of what is known
  std::size_t next_ = 0;
  void* given_back_ = nullptr;
};

}  // namespace packbed::dem
