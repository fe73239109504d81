// SPDX-License-Identifier: BSD-3-Clause
#include "analysis/profile.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/overlap.hpp"
#include "analysis/pieces.hpp"
#include "analysis/slots.hpp"
#include "core/error.hpp"

namespace packbed::analysis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Volumes of the slots of a horizontal axis.
std::vector<double> across(std::span<const Bead> beads,
                           const mesh::ColumnShape& shape,
                           Axis axis,
                           std::span<const double> edges,
                           const Range& z,
                           const Ranks& ranks) {
  const Side here = side(shape, axis);
  // A periodic axis has no outside: its images cover all of the bead.
  const Range reach = here.periodic ? here.range : Range{-infinity, infinity};
  Slots slots(edges, largest_bead_volume(beads, ranks));
  for_pieces(beads, side(shape, Axis::z), z, [&](const Bead& bead, const Piece& piece) {
    for_images(along(bead.x, axis), bead.radius, here, reach, [&](double shift) {
      const double x = along(bead.x, axis) + shift;
      slots.spread(x - bead.radius, x + bead.radius, piece.volume(),
                   [&](double edge) { return piece.below(edge - x); });
    });
  });
  auto totals = slots.totals(ranks);
  if (here.periodic) totals.front() = totals.back() = 0.0;
  return totals;
}

std::vector<double> rings(std::span<const Bead> beads,
                          std::span<const double> radii,
                          const Side& height,
                          const Range& z,
                          const Ranks& ranks) {
  Slots slots(radii, largest_bead_volume(beads, ranks));
  for_pieces(beads, height, z, [&](const Bead& bead, const Piece& piece) {
    const double s = std::hypot(bead.x.x, bead.x.y);
    slots.spread(std::max(0.0, s - bead.radius), s + bead.radius, piece.volume(),
                 [&](double r) { return piece.in_cylinder(s, r); });
  });
  return slots.totals(ranks);
}

Profile ring_profile(std::span<const Bead> beads,
                     const mesh::Cylinder& cylinder,
                     const ProfileBins& bins,
                     const Ranks& ranks) {
  const double radius = 0.5 * cylinder.inner_diameter;
  Profile p;
  p.edges = even_edges(0.0, radius, bins.width);
  const std::size_t count = p.edges.size() - 1;
  std::vector<double> radii(count + 1);
  for (std::size_t k = 0; k <= count; ++k) radii[count - k] = radius - p.edges[k];
  const Side height = side(mesh::ColumnShape{cylinder}, Axis::z);
  const auto slots = rings(beads, radii, height, bins.z, ranks);
  for (std::size_t k = 0; k < count; ++k) {
    const double outer = radii[count - k];
    const double inner = radii[count - k - 1];
    p.solid.push_back(slots[count - k]);
    p.volume.push_back(std::numbers::pi * (outer - inner) * (outer + inner) *
                       (bins.z.high - bins.z.low));
  }
  p.outside = slots.front() + slots.back();
  return p;
}

/// Bins from both walls across an axis, folded.
Profile folded_profile(std::span<const Bead> beads,
                       const mesh::ColumnShape& shape,
                       Axis axis,
                       const ProfileBins& bins,
                       const Ranks& ranks) {
  const Range range = side(shape, axis).range;
  const double half = 0.5 * (range.high - range.low);
  Profile p;
  p.edges = even_edges(0.0, half, bins.width);
  const std::size_t count = p.edges.size() - 1;
  std::vector<double> planes;
  for (const double y : p.edges) planes.push_back(range.low + y);
  for (std::size_t k = count; k-- > 0;) planes.push_back(range.high - p.edges[k]);
  const auto slots = across(beads, shape, axis, planes, bins.z, ranks);
  for (std::size_t k = 0; k < count; ++k) {
    p.solid.push_back(slots[k + 1] + slots[2 * count - k]);
    p.volume.push_back(mesh::cross_section(shape) * (p.edges[k + 1] - p.edges[k]) / half *
                       (bins.z.high - bins.z.low));
  }
  p.outside = slots.front() + slots.back();
  return p;
}

}  // namespace

std::vector<double> Profile::porosities() const {
  std::vector<double> eps(size());
  for (std::size_t k = 0; k < size(); ++k) eps[k] = porosity(k);
  return eps;
}

Profile bed_profile(std::span<const Bead> beads,
                    const mesh::ColumnShape& shape,
                    Axis axis,
                    const ProfileBins& bins,
                    const Ranks& ranks) {
  Profile p;
  std::vector<double> slots;
  if (axis == Axis::z) {
    p.edges = even_edges(bins.z.low, bins.z.high, bins.width);
    Slots layers(p.edges, largest_bead_volume(beads, ranks));
    for_pieces(beads, side(shape, Axis::z), bins.z, [&](const Bead& bead, const Piece& piece) {
      const double z = bins.z.low - piece.z.low;
      layers.spread(z - bead.radius, z + bead.radius, sphere_volume(bead.radius),
                    [&](double edge) { return volume_below(bead.radius, edge - z); });
    });
    slots = layers.totals(ranks);
    slots.front() = slots.back() = 0.0;
  } else {
    const Range range = side(shape, axis).range;
    p.edges = even_edges(range.low, range.high, bins.width);
    slots = across(beads, shape, axis, p.edges, bins.z, ranks);
  }
  p.outside = slots.front() + slots.back();
  for (std::size_t k = 1; k < p.edges.size(); ++k) {
    p.solid.push_back(slots[k]);
    p.volume.push_back(axis == Axis::z ? mesh::cross_section(shape) * (p.edges[k] - p.edges[k - 1])
                                       : (area_below(shape, axis, p.edges[k]) -
                                          area_below(shape, axis, p.edges[k - 1])) *
                                             (bins.z.high - bins.z.low));
  }
  return p;
}

Profile wall_profile(std::span<const Bead> beads,
                     const mesh::ColumnShape& shape,
                     const ProfileBins& bins,
                     const Ranks& ranks) {
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape)) {
    return ring_profile(beads, *cylinder, bins, ranks);
  }
  for (const Axis axis : {Axis::x, Axis::y}) {
    if (side(shape, axis).wall) return folded_profile(beads, shape, axis, bins, ranks);
  }
  throw ValueError(
      "a profile over the distance from the wall was asked for a box without walls in x and y; "
      "give "
      "the box walls, or take a profile along x, y or z");
}

}  // namespace packbed::analysis
