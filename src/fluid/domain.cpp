// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/domain.hpp"

namespace packbed::fluid {

Domain::Domain(const mesh::ColumnMesh& of, const mesh::CellPartition& partition, const Ranks& all)
    : mesh(of),
      part(mesh::mesh_part(of, partition.first(all.rank()), partition.last(all.rank()))),
      geometry(fluid::geometry(part)),
      ranks(all),
      halo(part, partition, all) {}

std::vector<double> Domain::move_top(double z, double dt) {
  if (z == mesh.top()) return std::vector<double>(faces(), 0.0);
  auto speed = mesh::swept_volumes(mesh, part, mesh.top(), z);
  mesh.set_top(z);
  mesh::update_metrics(mesh, part);
  geometry = fluid::geometry(part);
  for (std::size_t f = 0; f < speed.size(); ++f) speed[f] /= geometry.area[f] * dt;
  return speed;
}

std::int64_t Domain::face_number(std::size_t f) const {
  using Kind = mesh::FaceSource::Kind;
  const auto& source = part.source[f];
  const auto& section = mesh.section();
  const std::int64_t level_faces = (mesh.layers() + std::int64_t{1}) * mesh.cells_per_layer();
  const auto inner_edges = static_cast<std::int64_t>(section.inner.size());
  const auto border_edges = static_cast<std::int64_t>(section.border.size());
  if (source.kind == Kind::level) return source.layer * mesh.cells_per_layer() + source.index;
  if (source.kind == Kind::inner_edge) {
    return level_faces + source.layer * inner_edges + source.index;
  }
  return level_faces + mesh.layers() * inner_edges + source.layer * border_edges + source.index;
}

std::vector<double> throughflow(const Domain& domain, std::span<const double> flux) {
  std::vector<double> all(domain.cells(), 0.0);
  for (std::size_t f = 0; f < domain.faces(); ++f) {
    const double half = 0.5 * std::abs(flux[f]);
    all[domain.owner(f)] += half;
    if (f < domain.inner()) all[domain.neighbor(f)] += half;
  }
  all.resize(domain.own());
  return all;
}

}  // namespace packbed::fluid
