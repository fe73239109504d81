// SPDX-License-Identifier: BSD-3-Clause
#include "column/liquid_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/exact_sum.hpp"

namespace packbed::column {
namespace {

/// Sums of terms per bin that come out the same in any order.
class BinSums {
 public:
  void add(std::size_t bin, double term) {
    terms_.push_back({bin, term});
    largest_ = std::max(largest_, std::abs(term));
  }
  [[nodiscard]] std::vector<double> totals(std::size_t bins, const Ranks& ranks) const {
    const double largest = ranks.max(largest_);
    if (!(largest > 0.0)) return std::vector<double>(bins, 0.0);
    ExactSums sums(bins, largest);
    for (const auto& t : terms_) sums.add(t.bin, t.value);
    return sums.totals(ranks);
  }

 private:
  struct Term {
    std::size_t bin;
    double value;
  };
  std::vector<Term> terms_;
  double largest_ = 0.0;
};

/// What cells give to bins.
struct Sums {
  BinSums volume, liquid, flow, pressure;

  void add(std::size_t bin, double part, const fluid::Fluid& f, std::size_t c) {
    volume.add(bin, part);
    liquid.add(bin, part * f.eps()[c]);
    flow.add(bin, -part * f.eps()[c] * f.u()[c].z);
    pressure.add(bin, part * f.dynamic_pressure()[c]);
  }
  [[nodiscard]] std::vector<LiquidBin> means(const std::vector<double>& edges,
                                             const Ranks& ranks) const {
    const std::size_t bins = edges.size() - 1;
    const auto v = volume.totals(bins, ranks);
    const auto l = liquid.totals(bins, ranks);
    const auto q = flow.totals(bins, ranks);
    const auto p = pressure.totals(bins, ranks);
    std::vector<LiquidBin> means;
    for (std::size_t k = 0; k < bins; ++k) {
      means.push_back({edges[k], edges[k + 1], l[k] / v[k], q[k] / v[k], p[k] / v[k]});
    }
    return means;
  }
};

/// Where the cells of the cross-section stand in the bins.
struct Sharing {
  struct Part {
    std::size_t bin;
    double area;  ///< [m2]
  };
  std::vector<double> edges;             ///< of the bins [m]
  std::vector<std::vector<Part>> parts;  ///< one list per cell
};

std::array<mesh::Point, 4> corners(const mesh::CrossSection& section, std::size_t cell) {
  std::array<mesh::Point, 4> p;
  for (std::size_t k = 0; k < 4; ++k) {
    p[k] = section.points[static_cast<std::size_t>(section.cells[cell][k])];
  }
  return p;
}

// Cells of a rectangle stand in columns: those with the same low side are one bin.
Sharing columns_of(const mesh::CrossSection& section) {
  Sharing sharing;
  std::vector<double> low;
  for (const auto& p : section.points) sharing.edges.push_back(p.x);
  std::ranges::sort(sharing.edges);
  const auto same = [](double a, double b) { return a == b; };
  sharing.edges.erase(std::unique(sharing.edges.begin(), sharing.edges.end(), same),
                      sharing.edges.end());
  for (std::size_t c = 0; c < section.cells.size(); ++c) {
    const auto p = corners(section, c);
    const double x = std::ranges::min(p, {}, &mesh::Point::x).x;
    const auto bin = std::ranges::lower_bound(sharing.edges, x) - sharing.edges.begin();
    sharing.parts.push_back({{static_cast<std::size_t>(bin), section.area[c]}});
  }
  return sharing;
}

mesh::Point between(const mesh::Point& a, const mesh::Point& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// A cell is cut into small pieces, each of which belongs to the ring of its center.
constexpr int pieces_per_side = 16;

mesh::AreaAndCenter piece_of(const std::array<mesh::Point, 4>& p, int i, int j) {
  const double s = (i + 0.5) / pieces_per_side;
  const double t = (j + 0.5) / pieces_per_side;
  const auto left = between(p[0], p[3], t);
  const auto right = between(p[1], p[2], t);
  const auto below = between(p[0], p[1], s);
  const auto above = between(p[3], p[2], s);
  const double jacobian =
      (right.x - left.x) * (above.y - below.y) - (right.y - left.y) * (above.x - below.x);
  return {.area = jacobian / (pieces_per_side * pieces_per_side),
          .center = between(left, right, s)};
}

Sharing rings_of(const mesh::CrossSection& section, double radius) {
  double area = 0.0;
  for (const double a : section.area) area += a;
  const double cell = std::sqrt(area / static_cast<double>(section.cells.size()));
  const auto rings = static_cast<std::size_t>(std::ceil(radius / cell));
  Sharing sharing;
  for (std::size_t k = 0; k <= rings; ++k) {
    sharing.edges.push_back(radius * static_cast<double>(k) / static_cast<double>(rings));
  }
  for (std::size_t c = 0; c < section.cells.size(); ++c) {
    std::vector<double> in_ring(rings, 0.0);
    for (int k = 0; k < pieces_per_side * pieces_per_side; ++k) {
      const auto piece = piece_of(corners(section, c), k % pieces_per_side, k / pieces_per_side);
      const double share = std::hypot(piece.center.x, piece.center.y) / radius;
      const auto ring = static_cast<std::size_t>(share * static_cast<double>(rings));
      in_ring[std::min(ring, rings - 1)] += piece.area;
    }
    auto& parts = sharing.parts.emplace_back();
    for (std::size_t k = 0; k < rings; ++k) {
      if (in_ring[k] > 0.0) parts.push_back({k, in_ring[k]});
    }
  }
  return sharing;
}

Sharing sharing_of(const mesh::CrossSection& section, const mesh::ColumnShape& shape) {
  const auto* cylinder = std::get_if<mesh::Cylinder>(&shape);
  return cylinder != nullptr ? rings_of(section, 0.5 * cylinder->inner_diameter)
                             : columns_of(section);
}

}  // namespace

std::vector<LiquidBin> layer_profile(const fluid::Fluid& fluid) {
  const auto& d = fluid.domain();
  std::vector<double> edges;
  for (std::int32_t k = 0; k <= d.mesh.layers(); ++k) edges.push_back(d.mesh.level(k));
  Sums sums;
  for (std::size_t c = 0; c < d.own(); ++c) {
    const auto layer = static_cast<std::size_t>(d.part.cell[c] / d.mesh.cells_per_layer());
    sums.add(layer, d.part.volume[c], fluid, c);
  }
  return sums.means(edges, d.ranks);
}

std::vector<LiquidBin> cross_profile(const fluid::Fluid& fluid,
                                     const mesh::ColumnShape& shape,
                                     const analysis::Range& z) {
  const auto& d = fluid.domain();
  const auto sharing = sharing_of(d.mesh.section(), shape);
  Sums sums;
  for (std::size_t c = 0; c < d.own(); ++c) {
    const auto layer = static_cast<std::int32_t>(d.part.cell[c] / d.mesh.cells_per_layer());
    const double length =
        std::min(z.high, d.mesh.level(layer + 1)) - std::max(z.low, d.mesh.level(layer));
    if (length <= 0.0) continue;
    const auto column = static_cast<std::size_t>(d.part.cell[c] % d.mesh.cells_per_layer());
    for (const auto& part : sharing.parts[column]) sums.add(part.bin, length * part.area, fluid, c);
  }
  return sums.means(sharing.edges, d.ranks);
}

}  // namespace packbed::column
