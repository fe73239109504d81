// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "core/ranks.hpp"

namespace packbed {

/// Records of all ranks dealt out anew, each rank's sorted: rank after rank they stand in the order of their keys,
/// whoever had them before. `key` gives a tuple that begins with a whole number from 0 on, and is unique.
/// All ranks call it.
template <class T, class Key>
std::vector<T> sorted_shares(std::vector<T> mine, Key key, const Ranks& ranks) {
  if (ranks.size() > 1) {
    double largest = 0.0;
    for (const auto& record : mine) {
      largest = std::max(largest, static_cast<double>(std::get<0>(key(record))));
    }
    const auto keys = static_cast<std::int64_t>(ranks.max(largest)) + 1;
    const auto per_rank = (keys + ranks.size() - 1) / ranks.size();
    std::vector<std::vector<T>> to_each(static_cast<std::size_t>(ranks.size()));
    for (const auto& record : mine) {
      to_each[static_cast<std::size_t>(std::get<0>(key(record)) / per_rank)].push_back(record);
    }
    mine.clear();
    for (const auto& part : ranks.exchange(to_each)) {
      mine.insert(mine.end(), part.begin(), part.end());
    }
  }
  std::ranges::sort(mine, {}, key);
  return mine;
}

}  // namespace packbed
