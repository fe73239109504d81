// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh_quality.hpp"

#include <algorithm>
#include <cmath>

namespace packbed::mesh {
namespace {

struct EdgeQuality {
  double angle;  // [rad]
  double skewness;
};

EdgeQuality edge_quality(const CrossSection& section, const InnerEdge& edge) {
  const auto& a = section.points[static_cast<std::size_t>(edge.a)];
  const auto& b = section.points[static_cast<std::size_t>(edge.b)];
  const auto& p = section.center[static_cast<std::size_t>(edge.owner)];
  const auto& q = section.center[static_cast<std::size_t>(edge.neighbor)];
  const Point delta = {q.x + edge.shift.x - p.x, q.y + edge.shift.y - p.y};
  const Point normal = {b.y - a.y, a.x - b.x};
  const Point to_face = {0.5 * (a.x + b.x) - p.x, 0.5 * (a.y + b.y) - p.y};
  const double along = delta.x * normal.x + delta.y * normal.y;
  const double across = delta.x * normal.y - delta.y * normal.x;
  const double cut = (to_face.x * normal.x + to_face.y * normal.y) / along;
  const double miss = std::hypot(to_face.x - cut * delta.x, to_face.y - cut * delta.y);
  return {.angle = std::atan2(std::abs(across), along),
          .skewness = miss / std::hypot(delta.x, delta.y)};
}

double aspect(const ColumnMesh& mesh, const std::array<std::int32_t, 4>& corners) {
  double shortest = mesh.level(1) - mesh.level(0);
  double longest = shortest;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& a = mesh.section().points[static_cast<std::size_t>(corners[k])];
    const auto& b = mesh.section().points[static_cast<std::size_t>(corners[(k + 1) % 4])];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return longest / shortest;
}

}  // namespace

MeshQuality quality(const ColumnMesh& mesh) {
  const auto& section = mesh.section();
  MeshQuality q{};
  for (const auto& edge : section.inner) {
    const auto [angle, skewness] = edge_quality(section, edge);
    q.largest_non_orthogonality = std::max(q.largest_non_orthogonality, angle);
    q.mean_non_orthogonality += angle / static_cast<double>(section.inner.size());
    q.largest_skewness = std::max(q.largest_skewness, skewness);
  }
  for (const auto& corners : section.cells) {
    q.largest_aspect = std::max(q.largest_aspect, aspect(mesh, corners));
  }
  const auto [smallest, largest] = std::ranges::minmax(section.area);
  q.largest_over_smallest = largest / smallest;
  return q;
}

}  // namespace packbed::mesh
