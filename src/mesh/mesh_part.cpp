// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh_part.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace packbed::mesh {
namespace {

using Kind = FaceSource::Kind;

template <class T>
void sort_unique(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Own cells [first, last) and their halo by number.
class Numbers {
 public:
  Numbers(std::int64_t first, std::int64_t last, std::vector<std::int64_t> halo)
      : first_(first), last_(last), halo_(std::move(halo)) {}
  [[nodiscard]] bool is_own(std::int64_t cell) const { return cell >= first_ && cell < last_; }
  /// Place in the part.
  [[nodiscard]] std::int32_t local(std::int64_t cell) const {
    if (is_own(cell)) return static_cast<std::int32_t>(cell - first_);
    const auto found = std::ranges::lower_bound(halo_, cell);
    return static_cast<std::int32_t>(last_ - first_ + (found - halo_.begin()));
  }
  [[nodiscard]] std::vector<std::int64_t> all() const {
    std::vector<std::int64_t> cells;
    for (auto c = first_; c < last_; ++c) cells.push_back(c);
    cells.insert(cells.end(), halo_.begin(), halo_.end());
    return cells;
  }

 private:
  std::int64_t first_;
  std::int64_t last_;
  std::vector<std::int64_t> halo_;
};

struct InnerFace {
  std::int64_t owner, neighbor;
  FaceSource source;
};

struct BorderFace {
  Patch patch;
  std::int64_t cell;
  FaceSource source;
};

std::vector<InnerFace> inner_faces(const ColumnMesh& mesh,
                                   const Numbers& numbers,
                                   std::int32_t first_layer,
                                   std::int32_t last_layer) {
  std::vector<InnerFace> faces;
  const auto n = mesh.cells_per_layer();
  const auto add = [&](std::int64_t owner, std::int64_t neighbor, const FaceSource& source) {
    if (numbers.is_own(owner) || numbers.is_own(neighbor))
      faces.push_back({owner, neighbor, source});
  };
  const auto& edges = mesh.section().inner;
  for (auto k = first_layer; k <= last_layer; ++k) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      add(k * n + edges[e].owner, k * n + edges[e].neighbor,
          {Kind::inner_edge, static_cast<std::int32_t>(e), k});
    }
  }
  for (auto k = std::max(first_layer, 1); k <= std::min(last_layer + 1, mesh.layers() - 1); ++k) {
    for (std::int32_t c = 0; c < n; ++c) add((k - 1) * n + c, k * n + c, {Kind::level, c, k});
  }
  if (mesh.is_periodic_in_z()) {
    for (std::int32_t c = 0; c < n; ++c) {
      add(c, (mesh.layers() - 1) * n + c, {Kind::level, c, 0});
    }
  }
  // Stable: where two cells meet twice, the face over the periodic side is the second.
  std::ranges::stable_sort(faces, [](const InnerFace& p, const InnerFace& q) {
    return std::tie(p.owner, p.neighbor) < std::tie(q.owner, q.neighbor);
  });
  return faces;
}

std::vector<BorderFace> border_faces(const ColumnMesh& mesh,
                                     const Numbers& numbers,
                                     std::int32_t first_layer,
                                     std::int32_t last_layer) {
  std::vector<BorderFace> faces;
  const auto n = mesh.cells_per_layer();
  const auto add = [&](Patch patch, std::int64_t cell, const FaceSource& source) {
    if (numbers.is_own(cell)) faces.push_back({patch, cell, source});
  };
  if (!mesh.is_periodic_in_z()) {
    const auto top = mesh.layers();
    for (std::int32_t c = 0; c < n; ++c) {
      add(Patch::inlet, (top - 1) * n + c, {Kind::level, c, top});
      add(Patch::outlet, c, {Kind::level, c, 0});
    }
  }
  const auto& edges = mesh.section().border;
  for (auto k = first_layer; k <= last_layer; ++k) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      add(edges[e].patch, k * n + edges[e].cell,
          {Kind::border_edge, static_cast<std::int32_t>(e), k});
    }
  }
  std::ranges::stable_sort(faces, [](const BorderFace& p, const BorderFace& q) {
    return std::tie(p.patch, p.cell) < std::tie(q.patch, q.cell);
  });
  return faces;
}

void add_faces(const ColumnMesh& mesh, const Numbers& numbers, MeshPart& part) {
  const auto n = mesh.cells_per_layer();
  const auto first_layer = static_cast<std::int32_t>(part.cell.front() / n);
  const auto last_own = part.cell[static_cast<std::size_t>(part.own) - 1];
  const auto last_layer = static_cast<std::int32_t>(last_own / n);
  for (const auto& f : inner_faces(mesh, numbers, first_layer, last_layer)) {
    part.owner.push_back(numbers.local(f.owner));
    part.neighbor.push_back(numbers.local(f.neighbor));
    part.source.push_back(f.source);
  }
  part.inner = part.face_count();
  for (const auto& f : border_faces(mesh, numbers, first_layer, last_layer)) {
    if (part.patches.empty() || part.patches.back().patch != f.patch) {
      part.patches.push_back({.patch = f.patch, .first = part.face_count(), .count = 0});
    }
    ++part.patches.back().count;
    part.owner.push_back(numbers.local(f.cell));
    part.source.push_back(f.source);
  }
}

void add_points(const ColumnMesh& mesh, MeshPart& part) {
  const auto per_level = static_cast<std::int64_t>(mesh.section().points.size());
  const auto corner = [&](std::int64_t cell, std::size_t k) {
    const auto layer = cell / mesh.cells_per_layer() + (k < 4 ? 0 : 1);
    const auto column = static_cast<std::size_t>(cell % mesh.cells_per_layer());
    return layer * per_level + mesh.section().cells[column][k % 4];
  };
  for (const auto cell : part.cell) {
    for (std::size_t k = 0; k < 8; ++k) part.point.push_back(corner(cell, k));
  }
  sort_unique(part.point);
  for (const auto cell : part.cell) {
    auto& corners = part.corners.emplace_back();
    for (std::size_t k = 0; k < 8; ++k) {
      corners[k] = static_cast<std::int32_t>(std::ranges::lower_bound(part.point, corner(cell, k)) -
                                             part.point.begin());
    }
  }
}

MeshPart make_part(const ColumnMesh& mesh,
                   std::int64_t first,
                   std::int64_t last,
                   std::vector<std::int64_t> halo) {
  MeshPart part;
  part.own = static_cast<std::int32_t>(last - first);
  const Numbers numbers(first, last, std::move(halo));
  part.cell = numbers.all();
  if (part.own > 0) add_faces(mesh, numbers, part);
  add_points(mesh, part);
  update_metrics(mesh, part);
  return part;
}

/// Metrics of the face of an edge a -> b over a layer; the area vector points to the right of it.
struct SideFace {
  Vec3 area;
  Vec3 center;
};

SideFace side_face(const ColumnMesh& mesh, std::int32_t a, std::int32_t b, std::int32_t layer) {
  const auto& p = mesh.section().points[static_cast<std::size_t>(a)];
  const auto& q = mesh.section().points[static_cast<std::size_t>(b)];
  const double low = mesh.level(layer);
  const double high = mesh.level(layer + 1);
  return {.area = {(high - low) * (q.y - p.y), (high - low) * (p.x - q.x), 0.0},
          .center = {0.5 * (p.x + q.x), 0.5 * (p.y + q.y), 0.5 * (low + high)}};
}

// Level faces look up, to the neighbor above or out of the top; down out of the bottom, and to the
// topmost layer where z is periodic.
double direction(const FaceSource& source) { return source.layer == 0 ? -1.0 : 1.0; }

}  // namespace

std::vector<std::int64_t> halo_cells(const ColumnMesh& mesh,
                                     std::int64_t first,
                                     std::int64_t last,
                                     int rings) {
  std::vector<std::int64_t> halo;
  std::vector<std::int64_t> rim;
  // The layers between the first two and the last two have no foreign neighbors.
  const auto n = mesh.cells_per_layer();
  const auto inside = std::max(first, (first / n + 2) * n);
  const auto inside_end = (last - 1) / n - 1 > first / n + 2 ? ((last - 1) / n - 1) * n : inside;
  for (auto c = first; c < std::min(inside, last); ++c) rim.push_back(c);
  for (auto c = inside_end; c < last; ++c) rim.push_back(c);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::int64_t> next;
    for (const auto c : rim) {
      for (const auto near : mesh.vertex_neighbors(c)) {
        if (near < first || near >= last) next.push_back(near);
      }
    }
    sort_unique(next);
    rim.clear();
    std::ranges::set_difference(next, halo, std::back_inserter(rim));
    halo.insert(halo.end(), rim.begin(), rim.end());
    std::ranges::sort(halo);
  }
  return halo;
}

MeshPart mesh_part(const ColumnMesh& mesh, std::int64_t first, std::int64_t last) {
  return make_part(mesh, first, last, halo_cells(mesh, first, last));
}

MeshPart whole(const ColumnMesh& mesh) { return make_part(mesh, 0, mesh.cell_count(), {}); }

void update_metrics(const ColumnMesh& mesh, MeshPart& part) {
  const auto cells = part.cell.size();
  part.center.resize(cells);
  part.volume.resize(cells);
  for (std::size_t c = 0; c < cells; ++c) {
    part.center[c] = mesh.center(part.cell[c]);
    part.volume[c] = mesh.volume(part.cell[c]);
  }
  const auto per_level = static_cast<std::int64_t>(mesh.section().points.size());
  part.points.resize(part.point.size());
  for (std::size_t p = 0; p < part.points.size(); ++p) {
    const auto& at = mesh.section().points[static_cast<std::size_t>(part.point[p] % per_level)];
    part.points[p] = {at.x, at.y, mesh.level(static_cast<std::int32_t>(part.point[p] / per_level))};
  }
  const auto faces = part.owner.size();
  part.area.resize(faces);
  part.face_center.resize(faces);
  part.delta.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto& source = part.source[f];
    const auto index = static_cast<std::size_t>(source.index);
    Vec3 shift{};
    if (source.kind == Kind::level) {
      const auto& p = mesh.section().center[index];
      part.area[f] = {0.0, 0.0, direction(source) * mesh.section().area[index]};
      part.face_center[f] = {p.x, p.y, mesh.level(source.layer)};
      if (source.layer == 0) shift.z = -mesh.top();
    } else if (source.kind == Kind::inner_edge) {
      const auto& e = mesh.section().inner[index];
      const auto side = side_face(mesh, e.a, e.b, source.layer);
      part.area[f] = side.area;
      part.face_center[f] = side.center;
      shift = {e.shift.x, e.shift.y, 0.0};
    } else {
      const auto& e = mesh.section().border[index];
      const auto side = side_face(mesh, e.a, e.b, source.layer);
      part.area[f] = side.area;
      part.face_center[f] = side.center;
    }
    const auto owner = part.center[static_cast<std::size_t>(part.owner[f])];
    part.delta[f] = f < part.neighbor.size()
                        ? part.center[static_cast<std::size_t>(part.neighbor[f])] + shift - owner
                        : part.face_center[f] - owner;
  }
}

std::vector<double> swept_volumes(const ColumnMesh& mesh,
                                  const MeshPart& part,
                                  double before,
                                  double after) {
  std::vector<double> swept(part.owner.size(), 0.0);
  for (std::size_t f = 0; f < swept.size(); ++f) {
    const auto& source = part.source[f];
    if (source.kind != Kind::level) continue;
    const double area = mesh.section().area[static_cast<std::size_t>(source.index)];
    swept[f] = direction(source) * area *
               (mesh.level(source.layer, after) - mesh.level(source.layer, before));
  }
  return swept;
}

}  // namespace packbed::mesh
