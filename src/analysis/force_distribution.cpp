// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/force_distribution.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/slots.hpp"
#include "core/error.hpp"

namespace packbed::analysis {
namespace {

double ratio(double a, double b) { return b > 0.0 ? a / b : 0.0; }
double ratio(std::int64_t a, std::int64_t b) {
  return ratio(static_cast<double>(a), static_cast<double>(b));
}

/// Forces over their mean.
std::vector<double> reduced_forces(std::span<const ContactForce> contacts) {
  const double mean = mean_force(contacts);
  std::vector<double> f;
  for (const auto& c : contacts) {
    if (pushes(c)) f.push_back(c.normal / mean);
  }
  return f;
}

std::int64_t count_of(const std::vector<double>& f) { return static_cast<std::int64_t>(f.size()); }

}  // namespace

ForceDistribution force_distribution(std::span<const ContactForce> contacts,
                                     const ForceBins& bins) {
  if (!(bins.width > 0.0 && bins.high > 0.0)) {
    throw ValueError("bins of forces need a width and an end above 0");
  }
  const auto f = reduced_forces(contacts);
  ForceDistribution d;
  d.contacts = count_of(f);
  d.mean = mean_force(contacts);
  d.not_pushing = std::ranges::count_if(
      contacts, [](const ContactForce& c) { return !c.with_wall() && !pushes(c); });
  d.edges = even_edges(0.0, bins.high, bins.width);
  d.counts.assign(d.edges.size() - 1, 0);
  for (const double each : f) {
    d.largest = std::max(d.largest, each);
    const auto above = std::ranges::upper_bound(d.edges, each) - d.edges.begin();
    if (above == std::ssize(d.edges)) {
      ++d.beyond;
    } else {
      ++d.counts[static_cast<std::size_t>(above) - 1];
    }
  }
  for (std::size_t k = 0; k < d.counts.size(); ++k) {
    d.density.push_back(ratio(d.counts[k], d.contacts) / (d.edges[k + 1] - d.edges[k]));
  }
  return d;
}

double share_above(std::span<const ContactForce> contacts, double multiple) {
  const auto f = reduced_forces(contacts);
  return ratio(std::ranges::count_if(f, [&](double each) { return each > multiple; }), count_of(f));
}

ForceTail force_tail(std::span<const ContactForce> contacts) {
  ForceTail tail;
  double excess = 0.0;
  for (const double f : reduced_forces(contacts)) {
    if (!(f > 1.0)) continue;
    excess += f - 1.0;
    ++tail.contacts;
  }
  const auto n = static_cast<double>(tail.contacts);
  tail.slope = ratio(n, excess);
  tail.error = ratio(tail.slope, std::sqrt(n));
  return tail;
}

ForceNetworks force_networks(std::span<const ContactForce> contacts) {
  const double mean = mean_force(contacts);
  std::vector<std::int64_t> beads;
  std::int64_t strong = 0;
  std::int64_t weak = 0;
  double strong_load = 0.0;
  double weak_load = 0.0;
  ForceNetworks n;
  for (const auto& c : contacts) {
    if (!pushes(c)) continue;
    const bool is_strong = c.normal > mean;
    (is_strong ? strong : weak) += 1;
    (is_strong ? strong_load : weak_load) += c.normal;
    (is_strong ? n.strong_mobilized : n.weak_mobilized) += c.tangential / c.normal;
    if (is_strong) beads.insert(beads.end(), {c.i, c.j});
  }
  std::ranges::sort(beads);
  beads.erase(std::unique(beads.begin(), beads.end()), beads.end());
  n.strong_share = ratio(strong, strong + weak);
  n.strong_load = ratio(strong_load, strong_load + weak_load);
  n.strong_beads = std::ssize(beads);
  n.strong_coordination = ratio(2 * strong, n.strong_beads);
  n.strong_mobilized = ratio(n.strong_mobilized, static_cast<double>(strong));
  n.weak_mobilized = ratio(n.weak_mobilized, static_cast<double>(weak));
  return n;
}

}  // namespace packbed::analysis
