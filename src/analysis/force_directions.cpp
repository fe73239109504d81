// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/force_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/slots.hpp"
#include "core/error.hpp"

namespace packbed::analysis {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

double angle_to_plane(const Vec3& n) {
  return std::atan2(std::abs(n.z), std::hypot(n.x, n.y)) / degree;
}

}  // namespace

std::vector<DirectionBin> force_directions(std::span<const ContactForce> contacts,
                                           const DirectionOptions& options) {
  if (!(options.width > 0.0)) throw ValueError("bins of angles need a width above 0");
  const double mean = mean_force(contacts);
  const auto edges = even_edges(0.0, 90.0, options.width);
  std::vector<DirectionBin> bins(edges.size() - 1);
  double total = 0.0;
  for (const auto& c : contacts) {
    if (!pushes(c)) continue;
    const auto above = std::ranges::upper_bound(edges, angle_to_plane(c.branch)) - edges.begin();
    auto& bin =
        bins[std::min(static_cast<std::size_t>(above), bins.size()) - 1];  // 90: in the last
    const double f = c.normal / mean;
    total += 1.0;
    ++bin.contacts;
    bin.mean_force += f;
    bin.largest_force = std::max(bin.largest_force, f);
    bin.above_share += f > options.multiple ? 1.0 : 0.0;
  }
  for (std::size_t k = 0; k < bins.size(); ++k) {
    auto& bin = bins[k];
    bin.low = edges[k];
    bin.high = edges[k + 1];
    if (bin.contacts == 0) continue;
    const auto n = static_cast<double>(bin.contacts);
    bin.density = n / total / (std::sin(bin.high * degree) - std::sin(bin.low * degree));
    bin.mean_force /= n;
    bin.above_share /= n;
  }
  return bins;
}

double Fabric::axial_to_lateral() const {
  const double lateral = 0.5 * (forces.xx + forces.yy);
  return lateral > 0.0 ? forces.zz / lateral : 0.0;
}

Fabric fabric(std::span<const ContactForce> contacts) {
  Fabric f;
  double count = 0.0;
  double load = 0.0;
  for (const auto& c : contacts) {
    if (!pushes(c)) continue;
    const Vec3 n = contact_normal(c);
    const auto nn = symmetric_product(n, n);
    f.contacts += nn;
    f.forces += c.normal * nn;
    count += 1.0;
    load += c.normal;
  }
  if (!(count > 0.0)) return {};
  return {.contacts = (1.0 / count) * f.contacts, .forces = (1.0 / load) * f.forces};
}

double axial_excess(const Symmetric& fabric) { return fabric.zz - fabric.trace() / 3.0; }

double anisotropy(const Symmetric& fabric) {
  const double mean = fabric.trace() / 3.0;
  const double diagonal =
      std::pow(fabric.xx - mean, 2) + std::pow(fabric.yy - mean, 2) + std::pow(fabric.zz - mean, 2);
  const double rest =
      2.0 * (std::pow(fabric.xy, 2) + std::pow(fabric.xz, 2) + std::pow(fabric.yz, 2));
  return std::sqrt(1.5 * (diagonal + rest));
}

}  // namespace packbed::analysis
