// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/coupling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

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

// Places in the sums over the beads of a cell, and in what a cell does to beads.
enum BeadSum : std::size_t { solid, d, d_2, d_v, d_2_v = d_v + 3 };
enum Pull : std::size_t {
  slow_u,
  inertial_u = slow_u + 3,
  grad_p = inertial_u + 3,
  slow = grad_p + 3,
  inertial,
  rate_slow,
  rate_inertial,
  rate_flux
};

template <std::size_t n>
void add(std::array<double, n>& sum, double w, const std::array<double, n>& terms) {
  for (std::size_t k = 0; k < n; ++k) sum[k] += w * terms[k];
}

template <std::size_t n>
Vec3 vector_at(const std::array<double, n>& values, std::size_t k) {
  return {values[k], values[k + 1], values[k + 2]};
}

template <std::size_t n>
void put(std::array<double, n>& values, std::size_t k, const Vec3& v) {
  values[k] = v.x;
  values[k + 1] = v.y;
  values[k + 2] = v.z;
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
  const auto sums = sum_beads();
  set_laws(mesh, sums);

  BedFields fields;
  exchange_.assign(window_.size(), 0.0);
  for (std::size_t c = window_.own_first(); c < window_.own_last(); ++c) {
    const auto& s = sums[c];
    const auto& law = law_[c];
    const double k = law.slow * s[d] + law.inertial * s[d_2];
    const Vec3 kv = law.slow * vector_at(s, d_v) + law.inertial * vector_at(s, d_2_v);
    exchange_[c] = k / volume_[c];
    fields.eps.push_back(eps_[c]);
    fields.exchange.push_back(exchange_[c]);
    fields.u_solid.push_back(k > 0.0 ? (1.0 / k) * kv : Vec3{});
  }
  window_.fill_from_owners(exchange_, 1);
  if (options_.overlap == OverlapRule::merged && dt > 0.0) fields.source = expelled(dt);
  return fields;
}

// Water that beads gave away as their contacts took more of them, per volume and time of each own cell.
std::vector<double> Coupling::expelled(double dt) {
  std::vector<double> sums(window_.size());
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    weights_.for_each(
        i, [&](std::int64_t cell, double w) { sums[at(cell)] += w * grains_[i].expelled; });
  }
  window_.add_to_owners(sums, 1);
  std::vector<double> source;
  for (std::size_t c = window_.own_first(); c < window_.own_last(); ++c) {
    source.push_back(sums[c] / (volume_[c] * dt));
  }
  return source;
}

void Coupling::find_beads(const dem::Dem& dem, double dt) {
  const auto& p = dem.particles();
  const bool is_merged = options_.overlap == OverlapRule::merged;
  const auto lens = is_merged ? dem.lens_volumes() : std::vector<double>(p.size());
  grains_.clear();
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_own(i)) continue;
    const double d = p.properties[i].diameter;
    const double whole = std::numbers::pi / 6.0 * d * d * d;
    Grain g{.place = i,
            .volume = whole - lens[i],
            .share = 1.0 - lens[i] / whole,
            .diameter = d,
            .lens = lens[i],
            .v = {}};
    if (dt > 0.0) {
      g.expelled = g.lens - p.coupled_at[i].lens;
      g.v = (1.0 / dt) * displacement(p.motion[i].x, p.coupled_at[i].x, dem.options().domain);
    }
    grains_.push_back(g);
  }
}

std::vector<Coupling::BeadSums> Coupling::sum_beads() const {
  std::vector<BeadSums> sums(window_.size());
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const auto& g = grains_[i];
    const double a = g.share * g.diameter;
    const double b = a * g.diameter;
    const BeadSums terms = {g.volume,  a,         b,         a * g.v.x, a * g.v.y,
                            a * g.v.z, b * g.v.x, b * g.v.y, b * g.v.z};
    weights_.for_each(i, [&](std::int64_t cell, double w) { add(sums[at(cell)], w, terms); });
  }
  window_.add_to_owners({sums.data()->data(), bead_sums * sums.size()}, bead_sums);
  return sums;
}

// Void fraction of the cells, and the drag law in each of them.
void Coupling::set_laws(const mesh::ColumnMesh& mesh, const std::vector<BeadSums>& sums) {
  volume_.resize(window_.size());
  eps_.assign(window_.size(), 1.0);
  law_.assign(window_.size(), {});
  std::array<double, 2> largest{};  // solid fraction, Reynolds number
  const double mean_diameter = this->mean_diameter();
  for (std::size_t c = 0; c < window_.size(); ++c) {
    volume_[c] = mesh.volume(window_.first() + static_cast<std::int64_t>(c));
    if (c < window_.own_first() || c >= window_.own_last()) continue;
    const auto& s = sums[c];
    eps_[c] = 1.0 - s[solid] / volume_[c];
    if (eps_[c] < least_void_fraction) stop_at_full_cell(mesh, c);
    const Vec3 v = s[d] > 0.0 ? (1.0 / s[d]) * vector_at(s, d_v) : Vec3{};
    const double re = set_law(c, norm(u_[c] - v), mean_diameter);
    largest = {std::max(1.0 - eps_[c], largest[0]), std::max(re, largest[1])};
  }
  ranks_.max(largest);
  figures_ = {.largest_solid_fraction = largest[0], .largest_reynolds = largest[1]};
  window_.fill_from_owners(eps_, 1);
  static_assert(sizeof(CellLaw) == 2 * sizeof(double));
  window_.fill_from_owners({&law_.data()->slow, 2 * law_.size()}, 2);
}

void Coupling::stop_at_full_cell(const mesh::ColumnMesh& mesh, std::size_t c) const {
  const Vec3 x = mesh.center(window_.first() + static_cast<std::int64_t>(c));
  throw DivergenceError(fmt::format(
      "beads fill the cell at x = {:.4g}, y = {:.4g}, z = {:.4g} mm: solid fraction {:.4g} with "
      "every bead at its full volume; the bed is compressed beyond what the model can tell: take a "
      "lower flow or "
      "compression, a lower or looser bed, or stiffer beads",
      1e3 * x.x, 1e3 * x.y, 1e3 * x.z, 1.0 - eps_[c]));
}

/// Of the beads of all ranks [m].
double Coupling::mean_diameter() const {
  std::array<std::int64_t, 2> sums = {static_cast<std::int64_t>(grains_.size()), 0};
  for (const auto& g : grains_) sums[1] += std::llround(1e12 * g.diameter);  // pm
  ranks_.sum(sums);
  return sums[0] > 0 ? 1e-12 * static_cast<double>(sums[1]) / static_cast<double>(sums[0]) : 1.0;
}

// F is taken at Re = 0 and at the Reynolds number of a bead of mean size, and as a straight line through both
// for the others: exact for Koch and Hill. Returns that Reynolds number.
double Coupling::set_law(std::size_t c, double slip, double mean_diameter) {
  const double eps = std::max(eps_[c], options_.min_void_fraction.value_or(0.0));
  const double d = mean_diameter / options_.coarse_grain;
  const double re = bead_reynolds(options_.rho_f, options_.mu_f, d, eps, slip);
  const auto [slow, fast] = std::visit(
      [&](const auto& law) { return std::pair(law(1.0 - eps, 0.0), law(1.0 - eps, re)); },
      options_.drag);
  const auto per_diameter = [&](double factor) {
    return grain_coefficient(factor, options_.mu_f, 1.0, options_.coarse_grain, eps);
  };
  law_[c] = {per_diameter(slow), per_diameter(fast - slow) / mean_diameter};
  return re;
}

void Coupling::set_velocity(std::span<const Vec3> u) {
  std::ranges::copy(u, u_.begin() + static_cast<std::ptrdiff_t>(window_.own_first()));
  window_.fill_from_owners(flat(u_), 3);
}

// What cells do to beads, so that a bead only adds up numbers of its cells.
std::vector<Coupling::CellPull> Coupling::pulls_of_cells(const LiquidFields& liquid) const {
  std::vector<Vec3> gradient(window_.size());
  std::ranges::copy(liquid.grad_p,
                    gradient.begin() + static_cast<std::ptrdiff_t>(window_.own_first()));
  window_.fill_from_owners(flat(gradient), 3);
  const bool frozen_flux = options_.scheme == Scheme::frozen_flux;
  std::vector<CellPull> pulls(window_.size());
  for (std::size_t c = 0; c < pulls.size(); ++c) {
    const auto& law = law_[c];
    const double back = frozen_flux ? 1.0 / eps_[c] : 1.0;
    auto& p = pulls[c];
    put(p, slow_u, law.slow * u_[c]);
    put(p, inertial_u, law.inertial * u_[c]);
    put(p, grad_p, gradient[c]);
    p[slow] = law.slow;
    p[inertial] = law.inertial;
    p[rate_slow] = back * law.slow;
    p[rate_inertial] = back * law.inertial;
    p[rate_flux] = frozen_flux ? back * back * exchange_[c] : 0.0;
  }
  return pulls;
}

// The force at the instant is sum w [K_c (u_c - v) - V (grad p)_c], so that each bead and cell exchange the same.
// A bead that moves otherwise than in the past interval feels -rate (v' - v) more: with the flux frozen, the
// liquid that it displaces must flow back, which costs K / eps + V B / eps^2 (design section 4); with the velocity
// frozen, K.
void Coupling::pull(const LiquidFields& liquid, dem::Dem& dem) {
  set_velocity(liquid.u);
  const auto pulls = pulls_of_cells(liquid);
  auto drag = dem.drag();
  auto coupled_at = dem.coupled_at();
  for (std::size_t i = 0; i < grains_.size(); ++i) {
    const auto& g = grains_[i];
    CellPull p{};
    weights_.for_each(i, [&](std::int64_t cell, double w) { add(p, w, pulls[at(cell)]); });
    const double a = g.share * g.diameter;
    const double b = a * g.diameter;
    const Vec3 force = a * (vector_at(p, slow_u) - p[slow] * g.v) +
                       b * (vector_at(p, inertial_u) - p[inertial] * g.v) -
                       g.volume * vector_at(p, grad_p);
    const double rate = a * p[rate_slow] + b * p[rate_inertial] + g.volume * p[rate_flux];
    Vec3 target = g.v + (1.0 / rate) * force;
    if (is_empty_y_) target.y = 0.0;  // nothing flows there
    drag[g.place] = {target, rate};
    coupled_at[g.place] = {.x = dem.particles().motion[g.place].x, .lens = g.lens};
  }
}

}  // namespace packbed::coupling
