// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads found by their ids.

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::analysis {

/// Records with a member `id`, in the order of their ids. ValueError if an id is there twice.
template <class T>
std::vector<T> sorted_by_id(std::span<const T> records) {
  std::vector<T> sorted(records.begin(), records.end());
  std::ranges::sort(sorted, {}, &T::id);
  const auto twice = std::ranges::adjacent_find(sorted, {}, &T::id);
  if (twice != sorted.end()) {
    throw ValueError(fmt::format("two beads have the id {}; ids must be unique", twice->id));
  }
  return sorted;
}

/// Place of an id in records that are sorted by it; their number if it is not there.
template <class T>
std::size_t place_of(std::span<const T> sorted, std::int64_t id) {
  const auto found = std::ranges::lower_bound(sorted, id, {}, &T::id);
  if (found == sorted.end() || found->id != id) return sorted.size();
  return static_cast<std::size_t>(found - sorted.begin());
}

}  // namespace packbed::analysis
