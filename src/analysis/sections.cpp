// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/sections.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "analysis/slots.hpp"
#include "core/error.hpp"
#include "core/exact_sum.hpp"

namespace packbed::analysis {
namespace {

constexpr std::int64_t fewest_tracers = 3;

/// The same list on all ranks, from each rank's part.
std::vector<Tracer> of_all_ranks(const std::vector<Tracer>& own, const Ranks& ranks) {
  const std::vector<std::vector<Tracer>> to_each(static_cast<std::size_t>(ranks.size()), own);
  std::vector<Tracer> all;
  for (const auto& part : ranks.exchange(to_each)) all.insert(all.end(), part.begin(), part.end());
  std::ranges::sort(all, {}, &Tracer::id);
  return all;
}

/// Sums of one boundary: displacement of its tracers against their offset in the reference state.
struct Fit {
  std::vector<double> offset, squared, moved, product;

  void add(double o, double displacement) {
    offset.push_back(o);
    squared.push_back(o * o);
    moved.push_back(displacement);
    product.push_back(o * displacement);
  }
};

/// Least squares displacement at offset 0.
double displacement_at_boundary(const Fit& fit, std::size_t boundary, const Ranks& ranks) {
  std::array<std::int64_t, 1> found = {static_cast<std::int64_t>(fit.offset.size())};
  ranks.sum(found);
  if (found[0] < fewest_tracers) {
    throw DivergenceError(fmt::format(
        "the boundary between sections {} and {} has lost its tracer beads: {} of them are left",
        boundary, boundary + 1, found[0]));
  }
  const double n = static_cast<double>(found[0]);
  const double o = order_independent_sum(fit.offset, ranks) / n;
  const double w = order_independent_sum(fit.moved, ranks) / n;
  const double variance = order_independent_sum(fit.squared, ranks) / n - o * o;
  const double covariance = order_independent_sum(fit.product, ranks) / n - o * w;
  // All tracers in one plane: they move as a whole. 1e-12: rounding of the squares.
  const double mean_square = variance + o * o;
  return variance > 1e-12 * mean_square ? w - covariance / variance * o : w;
}

std::vector<double> boundaries_now(const SectionReference& reference,
                                   std::span<const Bead> beads,
                                   double height,
                                   const Ranks& ranks) {
  const auto& before = reference.boundaries;
  const auto& tracers = reference.tracers;
  std::vector<Fit> fits(before.size());
  for (const auto& bead : beads) {
    const auto found = std::ranges::lower_bound(tracers, bead.id, {}, &Tracer::id);
    if (found == tracers.end() || found->id != bead.id) continue;
    const auto k = static_cast<std::size_t>(found->boundary);
    fits[k].add(found->offset, bead.x.z - before[k] - found->offset);
  }
  std::vector<double> now = before;
  now.front() = height;
  for (std::size_t k = 1; k + 1 < before.size(); ++k) {
    now[k] += displacement_at_boundary(fits[k], k, ranks);
  }
  return now;
}

double solid_in(std::span<const Bead> beads, double low, double high, const Ranks& ranks) {
  const std::array<double, 2> heights = {low, high};
  return high > low ? solid_between(beads, heights, ranks)[0] : 0.0;
}

}  // namespace

SectionReference section_reference(std::span<const Bead> beads,
                                   double height,
                                   const SectionOptions& options,
                                   const Ranks& ranks) {
  if (options.count < 1) {
    throw ValueError(
        fmt::format("{} sections were asked for; at least 1 is needed", options.count));
  }
  SectionReference reference;
  const double each = height / options.count;
  for (int k = 0; k <= options.count; ++k) {
    reference.boundaries.push_back(height - k * each);
  }
  reference.boundaries.back() = 0.0;
  const double reach = std::min(options.reach, 0.5 * each);
  std::vector<Tracer> own;
  for (const auto& bead : beads) {
    const double nearest = std::round((height - bead.x.z) / each);
    if (!(nearest >= 1.0 && nearest <= options.count - 1.0)) continue;
    const double offset = bead.x.z - reference.boundaries[static_cast<std::size_t>(nearest)];
    if (std::abs(offset) > reach) continue;
    own.push_back({bead.id, static_cast<std::int32_t>(nearest), offset});
  }
  reference.tracers = of_all_ranks(own, ranks);

  for (int k = 1; k < options.count; ++k) {
    const auto found = std::ranges::count(reference.tracers, k, &Tracer::boundary);
    if (found < fewest_tracers) {
      throw ValueError(fmt::format(
          "{} sections are too many for a bed of {:.4g} mm: only {} beads lie within {:.4g} mm "
          "of the boundary between sections {} and {}, {} are needed; ask for fewer sections",
          options.count, 1e3 * height, found, 1e3 * reach, k, k + 1, fewest_tracers));
    }
  }
  return reference;
}

std::vector<Section> sections(const SectionReference& reference,
                              std::span<const Bead> beads,
                              double height,
                              double cross_section,
                              const Ranks& ranks) {
  const auto& before = reference.boundaries;
  const auto now = boundaries_now(reference, beads, height, ranks);
  std::vector<Section> all;
  for (std::size_t k = 0; k + 1 < now.size(); ++k) {
    Section s{.section = static_cast<int>(k) + 1, .z_top = now[k], .z_bottom = now[k + 1]};
    s.height = s.z_top - s.z_bottom;
    s.compression = 1.0 - s.height / (before[k] - before[k + 1]);
    const double solid = solid_in(beads, s.z_bottom, s.z_top, ranks);
    s.packing_density = s.height > 0.0 ? solid / (cross_section * s.height) : 0.0;
    all.push_back(s);
  }
  return all;
}

double density_spread(std::span<const Section> sections) {
  assert(!sections.empty());
  const auto n = static_cast<double>(sections.size());
  double mean = 0.0;
  for (const auto& s : sections) mean += s.packing_density / n;
  double square = 0.0;
  for (const auto& s : sections) square += std::pow(s.packing_density - mean, 2) / n;
  return std::sqrt(square);
}

double density_change(std::span<const Section> sections, std::span<const Section> initial) {
  assert(!sections.empty() && sections.size() == initial.size());
  const auto n = static_cast<double>(sections.size());
  double square = 0.0;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    square += std::pow(sections[k].packing_density - initial[k].packing_density, 2) / n;
  }
  return std::sqrt(square);
}

}  // namespace packbed::analysis
