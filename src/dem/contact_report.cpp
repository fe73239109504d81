// SPDX-License-Identifier: BSD-3-Clause
#include "dem/contact_report.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "dem/dem.hpp"

namespace packbed::dem {
namespace {

/// Kinematics of a pair: the same equations as in the loop over lanes (dem/force_pass.cpp).
Kinematics pair_kinematics(const Particles& p, std::size_t i, std::size_t j, const Vec3& d) {
  const double r = norm(d);
  const double r_i = p.radius(i);
  const double r_j = p.radius(j);
  const double h = 0.5 * (r_i - r_j);
  return {.normal = (1.0 / r) * d,
          .overlap = r_i + r_j - r,
          .velocity = p.motion[i].v - p.motion[j].v,
          .surface = (0.5 * r + h) * p.spin[i].w + (0.5 * r - h) * p.spin[j].w,
          .spin = p.spin[i].w - p.spin[j].w,
          .r_eff = effective(r_i, r_j)};
}

ContactLoad load_of(const ContactModel& model,
                    double friction,
                    double dt,
                    const Kinematics& c,
                    const Coefficients& k,
                    History history) {
  return std::visit(
      [&](const auto& law, const auto& rolling) {
        return evaluate_contact(law, rolling, friction, dt, c, k, history);
      },
      model.contact, model.rolling);
}

}  // namespace

// A contact between two ranks is told by the rank of its first bead; the order is that of the ids.
std::vector<ContactReport> Dem::touching_contacts() const {
  std::vector<ContactReport> reports;
  reports.reserve(contacts_.size());  // more than there are, but memory only where they are
  const auto& p = particles_;
  for (std::size_t q = 0; q < contacts_.size(); ++q) {
    const auto pair = contacts_.pair(q);
    const auto i = static_cast<std::size_t>(pair.i);
    const auto j = static_cast<std::size_t>(pair.j);
    if (!p.is_own(i)) continue;
    const Vec3 d = p.motion[i].x - p.motion[j].x - offset(options_.domain, pair.image);
    const auto c = pair_kinematics(p, i, j, d);
    if (c.overlap <= 0.0) continue;
    const auto load = load_of(options_.model, options_.model.friction, spring_step(), c,
                              pair.coefficients, pair.history);
    ContactReport report{.id_i = p.properties[i].id,
                         .id_j = p.properties[j].id,
                         .x = p.motion[i].x,
                         .branch = -d,
                         .normal = load.normal,
                         .tangential = load.tangential,
                         .overlap = c.overlap};
    if (report.id_i > report.id_j) {  // told from the bead with the lower id
      std::swap(report.id_i, report.id_j);
      report.x -= d;
      report.branch = d;
      report.normal = -report.normal;
      report.tangential = -report.tangential;
    }
    reports.push_back(report);
  }
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (const auto& contact : wall_contacts_[w]) {
      const auto i = static_cast<std::size_t>(contact.bead);
      const auto c = wall_kinematics(walls_[w], p.motion[i], p.spin[i]);
      if (c.overlap <= 0.0) continue;
      const auto load = load_of(options_.model, walls_[w].friction, spring_step(), c,
                                contact.coefficients, contact.history);
      reports.push_back({.id_i = p.properties[i].id,
                         .id_j = -1 - static_cast<std::int64_t>(w),
                         .x = p.motion[i].x,
                         .branch = -(p.radius(i) - c.overlap) * c.normal,
                         .normal = load.normal,
                         .tangential = load.tangential,
                         .overlap = c.overlap});
    }
  }
  reports = ranks_.gather(std::move(reports));
  std::ranges::sort(reports, {}, [](const ContactReport& r) {
    return std::tuple(r.id_i, r.id_j, r.branch.x, r.branch.y, r.branch.z);
  });
  return reports;
}

}  // namespace packbed::dem
