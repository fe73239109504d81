// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/fluid_state.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "fluid/fluid.hpp"

namespace packbed::fluid {
namespace {

/// Records sorted by number, for look-ups.
template <class Record>
class ByNumber {
 public:
  ByNumber(std::vector<Record> records, std::int64_t Record::*number, const char* what)
      : records_(std::move(records)), number_(number), what_(what) {
    std::ranges::sort(records_, {}, number);
  }
  const Record& at(std::int64_t number) const {
    const auto found = std::ranges::lower_bound(records_, number, {}, number_);
    if (found == records_.end() || (*found).*number_ != number) {
      throw DataError(fmt::format(
          "the saved liquid lacks {} {}; it belongs to another mesh, or to a part of it", what_,
          number));
    }
    return *found;
  }

 private:
  std::vector<Record> records_;
  std::int64_t Record::*number_;
  const char* what_;
};

}  // namespace

FluidState Fluid::save() const {
  FluidState state;
  state.time = time_;
  state.top = domain_.mesh.top();
  if (const auto* in = std::get_if<Inlet>(&options_.boundaries.inlet)) {
    state.inlet = in->superficial.at(time_);
  }
  const auto& solver = pressure_solver_.state();
  state.per_decade = solver.per_decade;
  for (std::size_t c = 0; c < domain_.own(); ++c) {
    state.cells.push_back({.cell = domain_.part.cell[c],
                           .eps = eps_[c],
                           .p = p_[c],
                           .u = u_[c],
                           .grad_p = grad_p_[c],
                           .force = force_[c],
                           .drag = drag_[c]});
  }
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    if (!domain_.is_own(domain_.owner(f))) continue;
    state.faces.push_back(
        {.face = domain_.face_number(f),
         .owner = domain_.part.cell[domain_.owner(f)],
         .q = q_[f],
         .flux = flux_[f],
         .pressure = f < domain_.inner() ? 0.0 : border_p_[f - domain_.inner()],
         .conductance = solver.conductance.empty() ? 0.0 : solver.conductance[f]});
  }
  return state;
}

void Fluid::load(const FluidState& state) {
  const ByNumber cells(state.cells, &CellRecord::cell, "cell");
  const ByNumber faces(state.faces, &FaceRecord::face, "face");
  domain_.move_top(state.top, 1.0);
  std::ranges::fill(mesh_speed_, 0.0);
  time_ = state.time;
  for (std::size_t c = 0; c < domain_.cells(); ++c) {
    const auto& r = cells.at(domain_.part.cell[c]);
    eps_[c] = r.eps;
    p_[c] = r.p;
    u_[c] = r.u;
    grad_p_[c] = r.grad_p;
    if (!domain_.is_own(c)) continue;
    force_[c] = r.force;
    drag_[c] = r.drag;
  }
  PreconditionerState solver{.conductance = {}, .per_decade = state.per_decade};
  double lacking = 0.0;
  for (std::size_t f = 0; f < domain_.faces(); ++f) {
    const auto& r = faces.at(domain_.face_number(f));
    q_[f] = r.q;
    flux_[f] = r.flux;
    if (f >= domain_.inner()) border_p_[f - domain_.inner()] = r.pressure;
    solver.conductance.push_back(r.conductance);
    if (!(r.conductance > 0.0)) lacking = 1.0;
  }
  if (domain_.ranks.max(lacking) > 0.0) solver.conductance.clear();
  face_eps_ = viscous_eps(domain_, border_, eps_);
  update(border_, options_.boundaries, domain_, time_, options_.rho_f * options_.gravity);
  pressure_solver_.restore(domain_, border_, std::move(solver));
}

namespace {

/// Records of numbers in `wanted`, each asked from the rank in `from`.
template <class Record>
std::vector<Record> fetch(const std::vector<std::vector<std::int64_t>>& wanted,
                          const ByNumber<Record>& here,
                          const Ranks& ranks) {
  const auto asked = ranks.exchange(wanted);
  std::vector<std::vector<Record>> answers(asked.size());
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const auto number : asked[r]) answers[r].push_back(here.at(number));
  }
  std::vector<Record> all;
  for (const auto& part : ranks.exchange(answers)) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

void Fluid::repartition(const mesh::CellPartition& before, const mesh::CellPartition& after) {
  const auto old = save();
  const auto ranks = domain_.ranks;
  const ByNumber cells(old.cells, &CellRecord::cell, "cell");
  const ByNumber faces(old.faces, &FaceRecord::face, "face");
  Fluid renewed(options_, domain_.mesh, after, ranks);
  const auto n = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<std::int64_t>> want_cells(n);
  std::vector<std::vector<std::int64_t>> want_faces(n);
  const auto& domain = renewed.domain_;
  for (const auto cell : domain.part.cell) {
    want_cells[static_cast<std::size_t>(before.owner(cell))].push_back(cell);
  }
  for (std::size_t f = 0; f < domain.faces(); ++f) {
    const auto owner = before.owner(domain.part.cell[domain.owner(f)]);
    want_faces[static_cast<std::size_t>(owner)].push_back(domain.face_number(f));
  }
  FluidState state{
      .time = old.time, .top = old.top, .inlet = old.inlet, .per_decade = old.per_decade};
  state.cells = fetch(want_cells, cells, ranks);
  state.faces = fetch(want_faces, faces, ranks);
  renewed.load(state);
  *this = std::move(renewed);
}

}  // namespace packbed::fluid
