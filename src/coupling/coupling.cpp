// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/coupling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::coupling {
namespace {

std::vector<std::int64_t> cuts_of(const mesh::CellPartition& partition) {
  std::vector<std::int64_t> cuts = {0};
  for (int r = 0; r < partition.ranks(); ++r) cuts.push_back(partition.last(r));
  return cuts;
}

/// a - b in a box with periodic sides, for displacements far shorter than the box.
Vec3 displacement(const Vec3& a, const Vec3& b, const dem::Domain& domain) {
  Vec3 d = a - b;
  double* c[3] = {&d.x, &d.y, &d.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (domain.periodic[axis])
      *c[axis] -= domain.size[axis] * std::round(*c[axis] / domain.size[axis]);
  }
  return d;
}

/// Three numbers of each cell as one row of doubles.
std::span<double> flat(std::vector<Vec3>& field) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {&field.data()->x, 3 * field.size()};
}

}  // namespace

Coupling::Coupling(const mesh::ColumnMesh& mesh,
                   const mesh::ColumnShape& shape,
                   const mesh::CellPartition& partition,
                   const CouplingOptions& options,
                   const Ranks& ranks)
    : options_(options),
      ranks_(ranks),
      weights_(mesh, shape, options.widths),
      window_(cuts_of(partition),
              weights_.reach_in_layers(mesh) * mesh.cells_per_layer(),
              mesh.is_periodic_in_z(),
              ranks),
      is_empty_y_(weights_.is_empty_y()),
      u_(window_.size()) {}

BedFields Coupling::bed(const dem::Dem& dem, const mesh::ColumnMesh& mesh, double dt) {
  find_beads(dem, dt);
  std::vector<Vec3> centers;
  centers.reserve(grains_.size());
  for (const auto& g : grains_) centers.push_back(dem.particles().motion[g.place].x);
  weights_.set_rows(mesh, centers);
  sum_volumes(mesh);
  find_coefficients();

  // K and K v of the beads of each cell.
  std::vector<std::array<double, 4>> sums(window_.size());
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const auto& g = grains_[i];
    const std::array<double, 4> terms = {g.k, g.k * g.v.x, g.k * g.v.y, g.k * g.v.z};
    weights_.for_each(i, [&](std::int64_t cell, double w) {
      auto& sum = sums[static_cast<std::size_t>(cell - window_.first())];
      for (std::size_t n = 0; n < 4; ++n) sum[n] += w * terms[n];
    });
  }
  window_.add_to_owners({sums.data()->data(), 4 * sums.size()}, 4);

  BedFields fields;
  exchange_.assign(window_.size(), 0.0);
  for (std::size_t c = window_.own_first(); c < window_.own_last(); ++c) {
    const auto& s = sums[c];
    exchange_[c] = s[0] / volume_[c];
    fields.eps.push_back(eps_[c]);
    fields.exchange.push_back(exchange_[c]);
    fields.u_solid.push_back(s[0] > 0.0 ? (1.0 / s[0]) * Vec3{s[1], s[2], s[3]} : Vec3{});
  }
  window_.fill_from_owners(exchange_, 1);
  return fields;
}

void Coupling::find_beads(const dem::Dem& dem, double dt) {
  const auto& p = dem.particles();
  grains_.clear();
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_own(i)) continue;
    const double d = p.properties[i].diameter;
    Grain g{.place = i, .volume = std::numbers::pi / 6.0 * d * d * d, .diameter = d, .v = {}};
    if (dt > 0.0) {
      g.v = (1.0 / dt) * displacement(p.motion[i].x, p.coupled_at[i], dem.options().domain);
    }
    grains_.push_back(g);
  }
}

// Solid volume of the cells, their void fraction, and that around each bead.
void Coupling::sum_volumes(const mesh::ColumnMesh& mesh) {
  std::vector<double> solid(window_.size(), 0.0);
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    weights_.for_each(i, [&](std::int64_t cell, double w) {
      solid[static_cast<std::size_t>(cell - window_.first())] += w * grains_[i].volume;
    });
  }
  window_.add_to_owners(solid, 1);
  volume_.resize(window_.size());
  eps_.assign(window_.size(), 1.0);
  double fullest = 0.0;
  for (std::size_t c = 0; c < window_.size(); ++c) {
    volume_[c] = mesh.volume(window_.first() + static_cast<std::int64_t>(c));
    if (c < window_.own_first() || c >= window_.own_last()) continue;
    eps_[c] = 1.0 - solid[c] / volume_[c];
    fullest = std::max(fullest, 1.0 - eps_[c]);
    if (eps_[c] > 0.0) continue;
    const auto cell = window_.first() + static_cast<std::int64_t>(c);
    const Vec3 x = mesh.center(cell);
    throw DivergenceError(fmt::format(
        "beads fill the cell at x = {:.4g}, y = {:.4g}, z = {:.4g} mm: solid fraction {:.4g} with "
        "every bead at its full volume; the bed is compressed beyond what the model can tell",
        1e3 * x.x, 1e3 * x.y, 1e3 * x.z, 1.0 - eps_[c]));
  }
  window_.fill_from_owners(eps_, 1);
  figures_.largest_solid_fraction = ranks_.max(fullest);
  for (std::size_t i = 0; i < grains_.size(); ++i) grains_[i].eps = gather(i, eps_);
}

void Coupling::find_coefficients() {
  double largest = 0.0;
  std::visit(
      [&](const auto& law) {
        for (std::size_t i = 0; i < grains_.size(); ++i) {
          auto& g = grains_[i];
          const double d = g.diameter / options_.coarse_grain;
          const double eps = std::max(g.eps, options_.min_void_fraction.value_or(0.0));
          const double slip = norm(gather(i, u_) - g.v);
          const double re = bead_reynolds(options_.rho_f, options_.mu_f, d, eps, slip);
          largest = std::max(largest, re);
          g.k = grain_coefficient(law(1.0 - eps, re), options_.mu_f, g.diameter,
                                  options_.coarse_grain, eps);
        }
      },
      options_.drag);
  figures_.largest_reynolds = ranks_.max(largest);
}

double Coupling::gather(std::size_t row, const std::vector<double>& field) const {
  double sum = 0.0;
  weights_.for_each(row, [&](std::int64_t cell, double w) {
    sum += w * field[static_cast<std::size_t>(cell - window_.first())];
  });
  return sum;
}

Vec3 Coupling::gather(std::size_t row, const std::vector<Vec3>& field) const {
  Vec3 sum;
  weights_.for_each(row, [&](std::int64_t cell, double w) {
    sum += w * field[static_cast<std::size_t>(cell - window_.first())];
  });
  return sum;
}

void Coupling::set_velocity(std::span<const Vec3> u) {
  std::ranges::copy(u, u_.begin() + static_cast<std::ptrdiff_t>(window_.own_first()));
  window_.fill_from_owners(flat(u_), 3);
}

// The force at the instant is K (u - v) - V grad p, with u and grad p averaged by the weights, so that each
// bead and cell exchange the same. A bead that moves otherwise than in the past interval feels
// -rate (v' - v) more: with the flux frozen, the liquid that it displaces must flow back, which costs
// K / eps + V B / eps^2 (design section 4); with the velocity frozen, K.
void Coupling::pull(const LiquidFields& liquid, dem::Dem& dem) {
  set_velocity(liquid.u);
  std::vector<Vec3> grad_p(window_.size());
  std::ranges::copy(liquid.grad_p,
                    grad_p.begin() + static_cast<std::ptrdiff_t>(window_.own_first()));
  window_.fill_from_owners(flat(grad_p), 3);
  auto drag = dem.drag();
  auto coupled_at = dem.coupled_at();
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const auto& g = grains_[i];
    const Vec3 force = g.k * (gather(i, u_) - g.v) - g.volume * gather(i, grad_p);
    const double rate = options_.scheme == Scheme::frozen_flux
                            ? g.k / g.eps + g.volume * gather(i, exchange_) / (g.eps * g.eps)
                            : g.k;
    Vec3 target = g.v + (1.0 / rate) * force;
    if (is_empty_y_) target.y = 0.0;  // nothing flows there
    drag[g.place] = {target, rate};
    coupled_at[g.place] = dem.particles().motion[g.place].x;
  }
}

}  // namespace packbed::coupling
