// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/weights.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "core/error.hpp"
#include "coupling/kernel.hpp"

namespace packbed::coupling {
namespace {

SectionWeights::Options section_options(const mesh::CrossSection& section,
                                        const mesh::ColumnShape& shape,
                                        double reach) {
  SectionWeights::Options o{.reach = reach};
  const auto is_periodic = [](mesh::Boundary b) { return b == mesh::Boundary::periodic; };
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) o.periodic_y = slice->depth;
  if (const auto* box = std::get_if<mesh::Box>(&shape)) {
    if (is_periodic(box->boundaries[0])) o.periodic_x = box->size[0];
    if (is_periodic(box->boundaries[1])) o.periodic_y = box->size[1];
  }
  const auto low_sides = std::ranges::count_if(
      section.border, [](const auto& edge) { return edge.patch == mesh::Patch::y_low; });
  o.is_empty_y = o.periodic_y > 0.0 && low_sides == section.cell_count();
  return o;
}

}  // namespace

Weights::Weights(const mesh::ColumnMesh& mesh,
                 const mesh::ColumnShape& shape,
                 const WeightOptions& options)
    : section_(mesh.section(), section_options(mesh.section(), shape, options.reach)),
      is_empty_y_(section_options(mesh.section(), shape, options.reach).is_empty_y),
      reach_z_(options.reach_z),
      layers_(mesh.layers()),
      cells_per_layer_(mesh.cells_per_layer()),
      periodic_z_(mesh.is_periodic_in_z()) {
  if (!(reach_z_ > 0.0)) {
    throw ValueError(
        fmt::format("the averaging width along z is {} m; it must be positive", reach_z_));
  }
  if (periodic_z_ && 2.0 * reach_z_ > mesh.top()) {
    throw ValueError(
        fmt::format("the averaging width of {:.4g} mm along z is more than half of the periodic "
                    "height of {:.4g} mm",
                    1e3 * reach_z_, 1e3 * mesh.top()));
  }
}

std::int64_t Weights::reach_in_layers(const mesh::ColumnMesh& mesh) const {
  return static_cast<std::int64_t>(
             std::ceil(reach_z_ * static_cast<double>(layers_) / mesh.top())) +
         1;
}

// The kernel ends at the ends of the column. A bead beyond them by more than the reach is in the last layer.
void Weights::set_layers(const mesh::ColumnMesh& mesh, double z, std::size_t i) {
  const double thickness = mesh.top() / static_cast<double>(layers_);
  auto first = static_cast<std::int64_t>(std::floor((z - reach_z_) / thickness));
  double* weight = &layer_weight_[i * layers_per_row_];
  if (!periodic_z_) first = std::clamp<std::int64_t>(first, 0, layers_ - 1);
  const auto below = [&](std::int64_t layer) {  // share of the kernel below its lower end
    return kernel_integral((thickness * static_cast<double>(layer) - z) / reach_z_);
  };
  double total = 0.0;
  double low = below(first);
  for (std::size_t k = 0; k < layers_per_row_; ++k) {
    const auto layer = first + static_cast<std::int64_t>(k);
    const bool exists = periodic_z_ || layer < layers_;
    const double high = exists ? below(layer + 1) : low;
    weight[k] = high - low;
    total += weight[k];
    low = high;
  }
  if (total > 0.0) {
    for (std::size_t k = 0; k < layers_per_row_; ++k) weight[k] /= total;
  } else {
    first = z < 0.0 ? 0 : layers_ - 1;
    weight[0] = 1.0;
  }
  layer_first_[i] =
      static_cast<std::int32_t>(periodic_z_ ? (first % layers_ + layers_) % layers_ : first);
}

void Weights::set_rows(const mesh::ColumnMesh& mesh, std::span<const Vec3> centers) {
  layers_per_row_ = static_cast<std::size_t>(
                        std::ceil(2.0 * reach_z_ * static_cast<double>(layers_) / mesh.top())) +
                    1;
  layer_first_.resize(centers.size());
  layer_weight_.assign(centers.size() * layers_per_row_, 0.0);
  plane_first_.assign(1, 0);
  plane_.clear();
  std::vector<CellWeight> plane;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const Vec3& x = centers[i];
    section_.at({x.x, x.y}, plane);
    if (plane.empty()) plane.push_back({mesh.locator().cell_at({x.x, x.y}), 1.0});
    plane_.insert(plane_.end(), plane.begin(), plane.end());
    plane_first_.push_back(plane_.size());
    set_layers(mesh, x.z, i);
  }
}

}  // namespace packbed::coupling
