// SPDX-License-Identifier: BSD-3-Clause
#include "dem/dem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::dem {
namespace {

double largest_diameter(const std::vector<BeadStart>& beads) {
  double largest = 0.0;
  for (const auto& bead : beads) largest = std::max(largest, bead.properties.diameter);
  return largest;
}

std::string where(const BeadProperties& bead, const Vec3& x) {
  return fmt::format("bead {} at ({:.6g}, {:.6g}, {:.6g}) mm", bead.id, 1e3 * x.x, 1e3 * x.y,
                     1e3 * x.z);
}

/// What a rank starts with: as many as the others, wherever they are. The first renewal deals them out.
std::span<const BeadStart> share_of(std::span<const BeadStart> beads, const Ranks& ranks) {
  const auto count = beads.size();
  const auto rank = static_cast<std::size_t>(ranks.rank());
  const auto size = static_cast<std::size_t>(ranks.size());
  const std::size_t first = count * rank / size;
  return beads.subspan(first, count * (rank + 1) / size - first);
}

bool finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace

Dem::Dem(const DemOptions& options,
         const std::vector<BeadStart>& beads,
         std::vector<Wall> walls,
         const Ranks& ranks)
    : options_(options),
      particles_(make_particles(share_of(beads, ranks), options.inertia(), ranks.rank())),
      walls_(std::move(walls)),
      wall_contacts_(walls_.size()),
      ranks_(ranks),
      bead_count_(static_cast<std::int64_t>(beads.size())),
      largest_diameter_(largest_diameter(beads)),
      cell_(std::max(largest_diameter_, 1e-12)),
      partition_(options.domain, cell_, ranks, options.mesh) {
  constexpr double skin_of_diameter = 0.05;
  if (options_.skin <= 0.0) options_.skin = skin_of_diameter * cell_;
  near_skin_ = options_.skin / 16.0;
  renew();
  check_overlaps();
}

void Dem::run(std::int64_t count) {
  for (std::int64_t n = 0; n < count; ++n) step_once();
}

void Dem::step_once() {
  const double dt = options_.step;
  renew_if_needed();
  add_forces_of_walls();
  add_contact_forces_and_move(
      {.kick = 0.5 * (last_step_ + dt), .drift = dt, .damping = options_.background_damping});
  if (ranks_.size() > 1) halo_.refresh(particles_, ranks_);
  move_walls(dt);
  last_step_ = dt;
  ++steps_;
}

void Dem::add_forces_of_walls() {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    add_wall_forces(options_.model, walls_[w], wall_contacts_[w], particles_, spring_step());
  }
}

// Contacts are sorted by i, and j > i: once all contacts of lower beads are done, a bead occurs in no
// other, and is moved while it is still in the cache.
void Dem::add_contact_forces_and_move(const Leapfrog& step) {
  constexpr std::size_t chunk = 32;
  const std::size_t blocks = contacts_.blocks.size();
  std::size_t moved = 0;
  Vec3 largest;
  double spoiled = 0.0;  // a number that is none spoils it
  for (std::size_t first = 0; moved < particles_.size(); first += chunk) {
    const std::size_t last = std::min(first + chunk, blocks);
    add_contact_forces(options_.model, contacts_, first, last, particles_, spring_step());
    const std::size_t done =
        last < blocks ? static_cast<std::size_t>(contacts_.blocks[last].i[0]) : particles_.size();
    const Vec3 far = move_own(moved, done, step);
    largest = {std::max(far.x, largest.x), std::max(far.y, largest.y), std::max(far.z, largest.z)};
    spoiled += 0.0 * (far.x + far.y + far.z);
    moved = done;
  }
  // The norm of the largest components, of all ranks, bounds the largest displacement.
  std::array<double, 3> bound = {largest.x + spoiled, largest.y, largest.z};
  ranks_.max(bound);
  moved_ = norm(to_vec3(bound));
}

// Halo beads are moved by their owners; what was added to their loads here is not needed.
Vec3 Dem::move_own(std::size_t first, std::size_t last, const Leapfrog& step) {
  if (ranks_.size() == 1) return move_beads(particles_, first, last, step);
  Vec3 largest;
  std::size_t done = first;
  auto run = std::ranges::upper_bound(own_runs_, first, {}, &Run::last);
  for (; run != own_runs_.end() && run->first < last; ++run) {
    const std::size_t from = std::max(run->first, first);
    const std::size_t to = std::min(run->last, last);
    std::fill(particles_.load.begin() + static_cast<std::ptrdiff_t>(done),
              particles_.load.begin() + static_cast<std::ptrdiff_t>(from), Load{});
    const Vec3 far = move_beads(particles_, from, to, step);
    const auto worse = [](double a, double b) { return a > b || std::isnan(a) ? a : b; };
    largest = {worse(far.x, largest.x), worse(far.y, largest.y), worse(far.z, largest.z)};
    done = to;
  }
  std::fill(particles_.load.begin() + static_cast<std::ptrdiff_t>(done),
            particles_.load.begin() + static_cast<std::ptrdiff_t>(last), Load{});
  return largest;
}

void Dem::move_walls(double drift) {
  double fastest = 0.0;
  for (auto& wall : walls_) {
    if (auto* plane = std::get_if<Plane>(&wall.surface)) plane->point += drift * wall.velocity;
    if (auto* disc = std::get_if<Disc>(&wall.surface)) disc->center += drift * wall.velocity;
    fastest = std::max(fastest, norm(wall.velocity));
  }
  walls_moved_ += drift * fastest;
}

void Dem::check_finite() const {
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const auto& m = particles_.motion[i];
    if (finite(m.x) && finite(m.v) && finite(particles_.spin[i].w)) continue;
    throw DivergenceError(fmt::format(
        "step {}, time {:.6g} s: {} has a position, velocity or spin that is not a number; "
        "take a smaller step",
        steps_, time(), where(particles_.properties[i], m.x)));
  }
}

double Dem::overlap(const PairKey& p) const {
  const auto i = static_cast<std::size_t>(p.i);
  const auto j = static_cast<std::size_t>(p.j);
  const Vec3 d = particles_.motion[i].x - particles_.motion[j].x - offset(options_.domain, p.image);
  return particles_.radius(i) + particles_.radius(j) - norm(d);
}

void Dem::check_overlaps() const {
  check_finite();
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const auto& contact : wall_contacts_[w]) {
      const auto i = static_cast<std::size_t>(contact.bead);
      const double diameter = 2.0 * particles_.radius(i);
      const double depth = 0.5 * diameter - distance_to(walls_[w], particles_.motion[i].x).distance;
      if (depth <= options_.overlap_limit * diameter) continue;
      throw DivergenceError(fmt::format(
          "step {}, time {:.6g} s: {} is {:.3g} um, {:.3g} of its diameter, inside the wall "
          "\"{}\"; the "
          "limit is {:.3g}. Take a smaller step or softer loads, or start with beads away from it",
          steps_, time(), where(particles_.properties[i], particles_.motion[i].x), 1e6 * depth,
          depth / diameter, walls_[w].name, options_.overlap_limit));
    }
  }
  // Asked after every interval of a coupled bed: squares, until one is too near.
  const auto is_too_near = [&](const ContactBlock& block, std::size_t lane) {
    const auto i = static_cast<std::size_t>(block.i[lane]);
    const auto j = static_cast<std::size_t>(block.j[lane]);
    const Image image = {block.image[0][lane], block.image[1][lane], block.image[2][lane]};
    const Vec3 d = particles_.motion[i].x - particles_.motion[j].x - offset(options_.domain, image);
    const double ri = particles_.radius(i);
    const double rj = particles_.radius(j);
    const double least = ri + rj - 2.0 * options_.overlap_limit * std::min(ri, rj);
    return least > 0.0 && dot(d, d) < least * least;
  };
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (!is_too_near(contacts_.blocks[k / lanes], k % lanes)) continue;
    const auto p = contacts_.key(k);
    const auto i = static_cast<std::size_t>(p.i);
    const auto j = static_cast<std::size_t>(p.j);
    const double smaller = 2.0 * std::min(particles_.radius(i), particles_.radius(j));
    const double depth = overlap(p);
    throw DivergenceError(fmt::format(
        "step {}, time {:.6g} s: {} overlaps bead {} by {:.3g} um, {:.3g} of the smaller diameter; "
        "the limit is {:.3g}. Take a smaller step, softer loads or stiffer beads, or start with "
        "beads "
        "apart",
        steps_, time(), where(particles_.properties[i], particles_.motion[i].x),
        particles_.properties[j].id, 1e6 * depth, depth / smaller, options_.overlap_limit));
  }
}

StableStep Dem::stable() const {
  const auto here = stable_step(options_.model, particles_, contacts_, walls_, wall_contacts_);
  const auto count = static_cast<std::size_t>(ranks_.size());
  StableStep limit = here;
  for (const auto& part : ranks_.exchange(std::vector<std::vector<StableStep>>(count, {here}))) {
    const auto& other = part[0];
    if (std::pair(other.step, other.bead) < std::pair(limit.step, limit.bead)) limit = other;
  }
  return limit;
}

}  // namespace packbed::dem
