// SPDX-License-Identifier: BSD-3-Clause
#include "dem/force_pass.hpp"

#include <algorithm>

#include "dem/lanes.hpp"

namespace packbed::dem {
namespace {

// With the arms c_i, c_j = r / 2 +- (R_i - R_j) / 2, which add up to the distance r:
// c_i w_i + c_j w_j = r / 2 (w_i + w_j) + (R_i - R_j) / 2 (w_i - w_j).
template <class Law, class Rolling>
void evaluate(Law law,
              Rolling rolling,
              double mu,
              double dt,
              const Relative& __restrict relative,
              ContactBlock& __restrict block,
              Forces& __restrict out) {
#pragma GCC ivdep
  for (int lane = 0; lane < lanes; ++lane) {
    const Vec3 d = get(relative.x, lane);
    const double r = std::sqrt(dot(d, d));
    const Vec3 n = (1.0 / r) * d;
    const double s = relative.mean_r[lane];
    const double h = relative.half_diff_r[lane];
    const Vec3 diff_w = get(relative.diff_w, lane);
    const Kinematics c{.normal = n,
                       .overlap = 2.0 * s - r,
                       .velocity = get(relative.v, lane),
                       .surface = 0.5 * r * get(relative.sum_w, lane) + h * diff_w,
                       .spin = diff_w,
                       .r_eff = (s * s - h * h) / (2.0 * s)};
    const Coefficients k{block.coefficient[0][lane], block.coefficient[1][lane],
                         block.coefficient[2][lane]};
    History history{get(block.spring, lane), get(block.angle, lane)};
    const ContactLoad load = evaluate_contact(law, rolling, mu, dt, c, k, history);
    put(block.spring, lane, history.spring);
    put(block.angle, lane, history.angle);
    const Vec3 lever = cross(n, load.tangential);  // arm -c_i n on i, c_j n on j
    put(out.force, lane, load.normal + load.tangential);
    put(out.torque_i, lane, -(0.5 * r + h) * lever + load.rolling);
    put(out.torque_j, lane, -(0.5 * r - h) * lever - load.rolling);
  }
}

// Beads beyond the second-level cache are asked for ahead of time, and blocks of contacts further
// ahead, since the places of the beads stand in them.
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
  Relative relative;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled before it is read
  Forces forces;      // NOLINT(cppcoreguidelines-pro-type-member-init)
  const std::size_t ahead =  // blocks up to here have others far enough behind them
      particles.size() > beads_in_cache ? std::max(contacts.blocks.size(), block_lead) - block_lead
                                        : 0;
  for (std::size_t b = first; b < last; ++b) {
    if (b < ahead) {
      prefetch_block(contacts.blocks[b + block_lead]);
      prefetch_beads(contacts.blocks[b + bead_lead], particles);
    }
    auto& block = contacts.blocks[b];
    gather(block, particles, contacts.box(), relative);
    evaluate(law, rolling, mu, dt, relative, block, forces);
    scatter(block, forces, particles);
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
