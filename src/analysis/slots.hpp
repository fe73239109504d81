// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Sums over the intervals that a row of edges makes: below the first, between two, above the last.

#include <algorithm>
#include <span>
#include <vector>

#include "analysis/bead.hpp"
#include "core/exact_sum.hpp"

namespace packbed::analysis {

class Slots {
 public:
  /// At least two `edges`, ascending; no term may be larger than `largest`.
  Slots(std::span<const double> edges, double largest)
      : edges_(edges.begin(), edges.end()),
        sums_(edges.size() + 1, largest),
        per_length_(static_cast<double>(edges.size() - 1) / (edges.back() - edges.front())) {}

  /// Adds `total`, spread over low..high of the coordinate; `below(edge)` is the part of it below an
  /// edge in between.
  template <class Below>
  void spread(double low, double high, double total, const Below& below) {
    std::size_t slot = slot_of(low);
    double before = 0.0;
    for (; slot < edges_.size() && edges_[slot] < high; ++slot) {
      const double now = below(edges_[slot]);
      sums_.add(slot, now - before);
      before = now;
    }
    sums_.add(slot, total - before);
  }

  /// Of all ranks: below the first edge, between edges, above the last.
  [[nodiscard]] std::vector<double> totals(const Ranks& ranks) const { return sums_.totals(ranks); }

 private:
  /// Edges are about evenly spaced: a guess is nearly right, and faster than a search.
  [[nodiscard]] std::size_t slot_of(double x) const {
    const double guess = (x - edges_.front()) * per_length_;
    auto slot =
        static_cast<std::size_t>(std::clamp(guess + 1.0, 0.0, static_cast<double>(edges_.size())));
    while (slot > 0 && edges_[slot - 1] > x) --slot;
    while (slot < edges_.size() && edges_[slot] <= x) ++slot;
    return slot;
  }

  std::vector<double> edges_;
  ExactSums sums_;
  double per_length_;  ///< edges per length [1/m]
};

/// low, low + width, ..., high. The last bin takes what is left.
std::vector<double> even_edges(double low, double high, double width);

/// Volume of beads between consecutive heights, ascending [m3]; one less than `heights`.
std::vector<double> solid_between(std::span<const Bead> beads,
                                  std::span<const double> heights,
                                  const Ranks& ranks);

}  // namespace packbed::analysis
