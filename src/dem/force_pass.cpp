// SPDX-License-Identifier: BSD-3-Clause
#include "dem/force_pass.hpp"

#include <algorithm>

#include "dem/lanes.hpp"

namespace packbed::dem {
namespace {

/// What the parts of a pass leave for each other, one lane for each contact.
struct alignas(64) Workspace {
  Relative relative;
  double normal[3][lanes];
  double distance[lanes];
  double r_eff[lanes];
  double slip[3][lanes];
  double f_n[lanes];
  double k_t[lanes];
  double gamma_t[lanes];
  double f_elastic[lanes];
  Forces forces;
};

// A pass over a block is done in four loops. Each lane is a long chain of operations that wait for each
// other, with roots and divisions; in short loops the processor works on several lanes at once.

void find_normals(Workspace& __restrict w) {
#pragma GCC ivdep
  for (int lane = 0; lane < lanes; ++lane) {
    const Vec3 d = get(w.relative.x, lane);
    const double r = std::sqrt(dot(d, d));
    const double s = w.relative.mean_r[lane];
    const double h = w.relative.half_diff_r[lane];
    put(w.normal, lane, (1.0 / r) * d);
    w.distance[lane] = r;
    w.r_eff[lane] = (s * s - h * h) / (2.0 * s);
  }
}

// With the arms c_i, c_j = r / 2 +- (R_i - R_j) / 2, which add up to the distance r:
// c_i w_i + c_j w_j = r / 2 (w_i + w_j) + (R_i - R_j) / 2 (w_i - w_j).
[[gnu::always_inline]] inline Kinematics kinematics(const Workspace& w, int lane) {
  const double r = w.distance[lane];
  const Vec3 diff_w = get(w.relative.diff_w, lane);
  return {.normal = get(w.normal, lane),
          .overlap = 2.0 * w.relative.mean_r[lane] - r,
          .velocity = get(w.relative.v, lane),
          .surface = 0.5 * r * get(w.relative.sum_w, lane) + w.relative.half_diff_r[lane] * diff_w,
          .spin = diff_w,
          .r_eff = w.r_eff[lane]};
}

template <class Law>
void press_contacts(Law law, double dt, Workspace& __restrict w, ContactBlock& __restrict block) {
#pragma GCC ivdep
  for (int lane = 0; lane < lanes; ++lane) {
    Vec3 spring = get(block.spring, lane);
    Vec3 slip;
    const Kinematics c = kinematics(w, lane);
    const Coefficients k{block.coefficient[0][lane], block.coefficient[1][lane],
                         block.coefficient[2][lane]};
    const Response r = press(law, dt, c, k, spring, slip);
    put(block.spring, lane, spring);
    put(w.slip, lane, slip);
    w.f_n[lane] = r.f_n;
    w.k_t[lane] = r.k_t;
    w.gamma_t[lane] = r.gamma_t;
    w.f_elastic[lane] = law(c.overlap, 0.0, k).f_n;
  }
}

[[gnu::always_inline]] inline bool touches(const Workspace& w, int lane) {
  return 2.0 * w.relative.mean_r[lane] - w.distance[lane] > 0.0;
}

[[gnu::always_inline]] inline Response response(const Workspace& w, int lane) {
  return {.f_n = w.f_n[lane], .k_t = w.k_t[lane], .gamma_t = w.gamma_t[lane]};
}

void hold_contacts(double mu, Workspace& __restrict w, ContactBlock& __restrict block) {
#pragma GCC ivdep
  for (int lane = 0; lane < lanes; ++lane) {
    const double r = w.distance[lane];
    const double h = w.relative.half_diff_r[lane];
    const Vec3 n = get(w.normal, lane);
    Vec3 spring = get(block.spring, lane);
    const Vec3 tangential =
        hold(response(w, lane), mu, touches(w, lane), get(w.slip, lane), spring);
    put(block.spring, lane, spring);
    const Vec3 lever = cross(n, tangential);  // arm -c_i n on i, c_j n on j
    put(w.forces.force, lane, w.f_n[lane] * n + tangential);
    put(w.forces.torque_i, lane, -(0.5 * r + h) * lever);
    put(w.forces.torque_j, lane, -(0.5 * r - h) * lever);
  }
}

template <class Rolling>
void roll_contacts(Rolling rolling,
                   double dt,
                   Workspace& __restrict w,
                   ContactBlock& __restrict block) {
#pragma GCC ivdep
  for (int lane = 0; lane < lanes; ++lane) {
    Vec3 angle = get(block.angle, lane);
    const RollingContact c{.r_eff = w.r_eff[lane],
                           .f_n = std::abs(w.f_n[lane]),
                           .f_elastic = w.f_elastic[lane],
                           .k_t = w.k_t[lane],
                           .dt = dt};
    const Vec3 torque = roll(rolling, c, touches(w, lane), get(w.normal, lane),
                             get(w.relative.diff_w, lane), angle);
    put(block.angle, lane, angle);
    put(w.forces.torque_i, lane, get(w.forces.torque_i, lane) + torque);
    put(w.forces.torque_j, lane, get(w.forces.torque_j, lane) - torque);
  }
}

// Beads beyond the second-level cache are asked for ahead of time, and blocks of contacts further
// ahead, since the places of the beads stand in them. Not all at once: the queue to memory is short, and what
// waits for a place in it holds up the rest.
constexpr std::size_t beads_in_cache = 10'000;
constexpr std::size_t bead_lead = 1;
constexpr std::size_t block_lead = 4;

template <class Law, class Rolling>
// NOLINTNEXTLINE(readability-function-size): what a pass takes
void add_forces(const Law& law,
                const Rolling& rolling,
                double mu,
                double dt,
                ContactList& contacts,
                std::size_t first,
                std::size_t last,
                Particles& particles) {
  Workspace w;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled before it is read
  const std::size_t ahead =  // blocks up to here have others far enough behind them
      particles.size() > beads_in_cache ? std::max(contacts.blocks.size(), block_lead) - block_lead
                                        : 0;
  for (std::size_t b = first; b < last; ++b) {
    const bool asks = b < ahead;
    const auto& soon = contacts.blocks[asks ? b + bead_lead : b];
    const auto& later = contacts.blocks[asks ? b + block_lead : b];
    auto& block = contacts.blocks[b];
    gather(block, particles, contacts.box(), w.relative);
    if (asks) prefetch_records<0>(soon, particles.motion);
    find_normals(w);
    if (asks) prefetch_records<0>(soon, particles.spin);
    if (asks) prefetch_half(later, 0);
    press_contacts(law, dt, w, block);
    if (asks) prefetch_half(later, 1);
    hold_contacts(mu, w, block);
    if (asks) prefetch_records<1>(soon, particles.load);
    roll_contacts(rolling, dt, w, block);
    scatter(block, w.forces, particles);
  }
}

template <class Law, class Rolling>
Vec3 add_wall_forces(const Law& law,
                     const Rolling& rolling,
                     double dt,
                     const Wall& wall,
                     WallContacts& contacts,
                     Particles& particles) {
  Vec3 on_wall;
  for (auto& contact : contacts) {
    const auto i = static_cast<std::size_t>(contact.bead);
    const auto c = wall_kinematics(wall, particles.motion[i], particles.spin[i]);
    const auto load =
        evaluate_contact(law, rolling, wall.friction, dt, c, contact.coefficients, contact.history);
    const double arm = c.r_eff - c.overlap;
    const Vec3 force = load.normal + load.tangential;
    particles.load[i].force += force;
    particles.load[i].torque += load.rolling - arm * cross(c.normal, load.tangential);
    on_wall -= force;
  }
  return on_wall;
}

}  // namespace

void add_contact_forces(const ContactModel& model,
                        ContactList& contacts,
                        std::size_t first,
                        std::size_t last,
                        Particles& particles,
                        double dt) {
  std::visit(
      [&](const auto& law, const auto& rolling) {
        add_forces(law, rolling, model.friction, dt, contacts, first, last, particles);
      },
      model.contact, model.rolling);
}

Vec3 add_wall_forces(const ContactModel& model,
                     const Wall& wall,
                     WallContacts& contacts,
                     Particles& particles,
                     double dt) {
  return std::visit(
      [&](const auto& law, const auto& rolling) {
        return add_wall_forces(law, rolling, dt, wall, contacts, particles);
      },
      model.contact, model.rolling);
}

}  // namespace packbed::dem
