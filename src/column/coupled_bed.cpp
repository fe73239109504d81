// SPDX-License-Identifier: BSD-3-Clause
#include "column/coupled_bed.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

#include "column/plunger.hpp"
#include "core/exact_sum.hpp"
#include "fluid/figures.hpp"

namespace packbed::column {
namespace {

fluid::Bed to_bed(coupling::BedFields fields) {
  fluid::Bed bed;
  bed.eps = std::move(fields.eps);
  bed.exchange = std::move(fields.exchange);
  bed.u_solid = std::move(fields.u_solid);
  bed.source = std::move(fields.source);
  return bed;
}

}  // namespace

CoupledBed::CoupledBed(const mesh::ColumnMesh& mesh,
                       const mesh::ColumnShape& shape,
                       const CoupledOptions& options,
                       const Ranks& ranks)
    : mesh_(mesh),
      shape_(shape),
      options_(options),
      ranks_(ranks),
      partition_(mesh.cell_count(), ranks.size()),
      fluid_(options.fluid, mesh, partition_, ranks) {
  share_anew();
}

void CoupledBed::share_anew() {
  coupling_.emplace(mesh_, shape_, partition_, options_.coupling, ranks_);
  reach_in_layers_ = coupling_->reach_in_layers(mesh_);
}

// Beads and cells belong to the same ranks: the liquid follows when beads are shared anew.
void CoupledBed::share_like(const dem::Dem& dem) {
  if (ranks_.size() == 1 || dem.partition() == partition_) return;
  fluid_.repartition(partition_, dem.partition());
  partition_ = dem.partition();
  share_anew();
  coupling_->set_velocity(fields().u);
}

// Layers that become thinner are more of them within reach of a bead.
std::optional<double> CoupledBed::follow_plunger(const dem::Dem& dem) {
  const auto top = plunger_position(dem.walls());
  if (!top || *top == mesh_.top()) return std::nullopt;
  mesh_.set_top(*top);
  if (dem.options().mesh) dem.options().mesh->set_top(*top);
  if (coupling_->reach_in_layers(mesh_) <= reach_in_layers_) return top;
  share_anew();
  coupling_->set_velocity(fields().u);
  return top;
}

coupling::LiquidFields CoupledBed::fields() const {
  const auto own = fluid_.domain().own();
  return {.u = std::span(fluid_.u()).first(own),
          .grad_p = std::span(fluid_.pressure_gradient()).first(own)};
}

void CoupledBed::start(dem::Dem& dem) {
  const auto top = plunger_position(dem.walls());
  if (top && *top != mesh::height(shape_)) {  // beads belong to ranks by cells where they are now
    if (dem.options().mesh) dem.options().mesh->set_top(*top);
    place_plunger(*top, dem);
  }
  dem.set_in_liquid(true);
  share_like(dem);
  const std::vector<Vec3> rest(fluid_.domain().own());
  fluid_.start(to_bed(coupling_->bed(dem, mesh_, 0.0)), rest, fluid_.time());
  coupling_->pull(fields(), dem);
}

void CoupledBed::advance(dem::Dem& dem, std::int64_t count) {
  const double dt = static_cast<double>(count) * dem.options().step;
  dem.run(count);
  std::optional<double> top;
  const double top_before = mesh_.top();
  const auto bed = coupling_time_.time([&] {
    share_like(dem);
    top = follow_plunger(dem);
    return to_bed(coupling_->bed(dem, mesh_, dt));
  });
  plunger_speed_ = top ? (*top - top_before) / dt : 0.0;
  report_ = liquid_time_.time([&] { return fluid_.step(dt, bed, top); });
  coupling_time_.time([&] { coupling_->pull(fields(), dem); });
}

double CoupledBed::flow() const {
  return std::get<fluid::Inlet>(fluid_.options().boundaries.inlet).superficial.at(time());
}

double CoupledBed::interval_within_limit(double wanted, double coming) const {
  const double rate = fluid::courant_rate(fluid_, coming);
  return rate * wanted > largest_courant ? largest_courant / rate : wanted;
}

void CoupledBed::load(const fluid::FluidState& state, const dem::Dem& dem) {
  assert(state.top == mesh_.top());
  share_like(dem);
  fluid_.load(state);
  fluid_.set_inlet(fluid::FlowProgram::steady(state.inlet));  // until a stage says more
  coupling_->set_velocity(fields().u);
}

LiquidFigures CoupledBed::figures() const {
  const auto& d = fluid_.domain();
  const auto& border = fluid_.border();
  // Area, p A, flux, and frit's pressure drop times A at the inlet, the same at the outlet; shear of the walls.
  std::array<std::vector<double>, 9> terms;
  for (std::size_t b = 0; b < border.size(); ++b) {
    const std::size_t f = d.inner() + b;
    if (!d.is_own(d.owner(f))) continue;
    const double area = d.geometry.area[f];
    if (border.kind[b] == fluid::BorderKind::wall) {
      terms[8].push_back(-fluid_.wall_shear(b).z);
      continue;
    }
    const bool is_inlet = border.patch[b] == mesh::Patch::inlet;
    if (!is_inlet && border.patch[b] != mesh::Patch::outlet) continue;
    const std::size_t first = is_inlet ? 0 : 4;
    terms[first].push_back(area);
    terms[first + 1].push_back(area * fluid_.border_pressure()[b]);
    terms[first + 2].push_back(fluid_.flux()[f]);
    terms[first + 3].push_back((is_inlet ? -1.0 : 1.0) * fluid_.frit_slope(b) * fluid_.flux()[f]);
  }
  std::array<double, 9> sums{};
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = order_independent_sum(terms[k], ranks_);
  const auto mean = [](double sum, double area) { return area > 0.0 ? sum / area : 0.0; };
  const double through = 0.0 - mean(sums[2], sums[0]);  // no "-0"
  return {.superficial_velocity = through - plunger_speed_,
          .plunger_moves = plunger_speed_ != 0.0,
          .pressure_drop = mean(sums[1], sums[0]) - mean(sums[5], sums[4]),
          .frit_pressure_drop = mean(sums[3], sums[0]) + mean(sums[7], sums[4]),
          .pressure_force = sums[1] - sums[5],
          .wall_shear = sums[8],
          .continuity_error = report_.continuity_error,
          .courant = report_.courant,
          .largest_solid_fraction = coupling_->figures().largest_solid_fraction,
          .largest_reynolds = coupling_->figures().largest_reynolds};
}

}  // namespace packbed::column
