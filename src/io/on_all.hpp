// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Failing together: what one rank cannot do stops all of them, with one message, so that none waits
/// for the others for ever.

#include <exception>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/ranks.hpp"

namespace packbed::io {

/// The first text of any rank that is not empty, in the order of ranks, on all of them.
inline std::string first_said(const Ranks& ranks, const std::string& text) {
  const std::vector<std::vector<char>> to_each(static_cast<std::size_t>(ranks.size()),
                                               {text.begin(), text.end()});
  for (const auto& said : ranks.exchange(to_each)) {
    if (!said.empty()) return {said.begin(), said.end()};
  }
  return "";
}

/// Collective: calls act() on every rank. If it throws on any, all ranks throw a DataError with the
/// message of the first of those.
template <class Action>
void on_all(const Ranks& ranks, Action act) {
  std::string problem;
  try {
    act();
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (const auto first = first_said(ranks, problem); !first.empty()) throw DataError(first);
}

/// The same for an act of rank 0 alone.
template <class Action>
void on_first(const Ranks& ranks, Action act) {
  on_all(ranks, [&] {
    if (ranks.is_first()) act();
  });
}

}  // namespace packbed::io
