// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/stress_profile.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::analysis {
namespace {

void check(std::size_t contacts,
           std::size_t tangential,
           std::span<const double> edges,
           double area) {
  if (edges.size() < 2 || !std::ranges::is_sorted(edges, std::ranges::less_equal{})) {
    throw ValueError("a stress profile needs at least two edges, each higher than the one before");
  }
  if (!(area > 0.0)) {
    throw ValueError(fmt::format("a stress profile needs a cross-section above 0, not {}", area));
  }
  if (tangential != 0 && tangential != contacts) {
    throw ValueError(fmt::format("{} tangential forces for {} contacts: give one of each, or none",
                                 tangential, contacts));
  }
}

/// Calls visit(slab, part) for the slabs in which a line between two heights lies.
template <class Visit>
void for_slabs(double from, double to, std::span<const double> edges, const Visit& visit) {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  auto k = std::ranges::upper_bound(edges, low) - edges.begin();
  if (low == high) {
    if (k > 0 && k < std::ssize(edges)) visit(static_cast<std::size_t>(k) - 1, 1.0);
    return;
  }
  for (k = std::max<std::ptrdiff_t>(k, 1); k < std::ssize(edges); ++k) {
    const auto upper = static_cast<std::size_t>(k);
    if (edges[upper - 1] >= high) break;
    const double within = std::min(high, edges[upper]) - std::max(low, edges[upper - 1]);
    visit(upper - 1, within / (high - low));
  }
}

}  // namespace

std::vector<StressBin> stress_profile(std::span<const ContactForce> contacts,
                                      std::span<const Vec3> tangential,
                                      std::span<const double> edges,
                                      double area) {
  check(contacts.size(), tangential.size(), edges, area);
  std::vector<StressBin> bins;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    bins.push_back({.z = {edges[k], edges[k + 1]}, .stress = {}});
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& c = contacts[k];
    Vec3 on_j = c.normal * contact_normal(c);
    if (!tangential.empty()) on_j -= tangential[k];
    const auto moment = symmetric_product(on_j, c.branch);
    for_slabs(c.x.z, c.x.z + c.branch.z, edges,
              [&](std::size_t slab, double part) { bins[slab].stress += part * moment; });
  }
  for (auto& bin : bins) bin.stress = (1.0 / (area * (bin.z.high - bin.z.low))) * bin.stress;
  return bins;
}

}  // namespace packbed::analysis
