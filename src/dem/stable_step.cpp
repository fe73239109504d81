// SPDX-License-Identifier: BSD-3-Clause
#include "dem/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace packbed::dem {
namespace {

struct Sums {
  double k = 0.0;
  double gamma = 0.0;
  int contacts = 0;
  double single_step = std::numeric_limits<double>::infinity();  ///< of its most delicate contact
};

// A sticking contact by itself: sliding and rolling of both beads act on its tangential spring,
// (1/m + R^2/I) = 3.5 / m of each, 3.5 / m* together.
void add(const ContactLaw& law,
         double overlap,
         double r_eff,
         double inv_m_eff,
         const Coefficients& k,
         Sums& sums) {
  std::visit(
      [&](const auto& l) {
        const double at = std::max(overlap, touching_overlap * r_eff);
        const Response response = l(at, 0.0, k);
        const double stiffness = std::max(l.stiffness(at, k), response.k_t);
        const double damping = l.damping(at, k);
        sums.k += stiffness;
        sums.gamma += damping;
        ++sums.contacts;
        sums.single_step = std::min(
            sums.single_step, largest_step(3.5 * stiffness * inv_m_eff, 3.5 * damping * inv_m_eff));
      },
      law);
}

}  // namespace

double largest_step(double w2, double c) {
  if (w2 <= 0.0) return std::numeric_limits<double>::infinity();
  return (std::sqrt(c * c + 4.0 * w2) - c) / w2;
}

StableStep stable_step(const ContactModel& model,
                       const Particles& particles,
                       const ContactList& contacts,
                       const std::vector<Wall>& walls,
                       const std::vector<WallContacts>& wall_contacts) {
  std::vector<Sums> sums(particles.size());
  for (std::size_t q = 0; q < contacts.size(); ++q) {
    const auto p = contacts.pair(q);
    const auto i = static_cast<std::size_t>(p.i);
    const auto j = static_cast<std::size_t>(p.j);
    const Vec3 box = contacts.box();
    const Vec3 shift{box.x * p.image[0], box.y * p.image[1], box.z * p.image[2]};
    const double r_i = particles.radius(i);
    const double r_j = particles.radius(j);
    const double distance = norm(particles.motion[i].x - particles.motion[j].x - shift);
    const double overlap = r_i + r_j - distance;
    if (overlap <= 0.0) continue;
    const double inv_m = particles.motion[i].inv_mass + particles.motion[j].inv_mass;
    add(model.contact, overlap, effective(r_i, r_j), inv_m, p.coefficients, sums[i]);
    add(model.contact, overlap, effective(r_i, r_j), inv_m, p.coefficients, sums[j]);
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (const auto& contact : wall_contacts[w]) {
      const auto i = static_cast<std::size_t>(contact.bead);
      const double overlap =
          particles.radius(i) - distance_to(walls[w], particles.motion[i].x).distance;
      if (overlap > 0.0) {
        add(model.contact, overlap, particles.radius(i), particles.motion[i].inv_mass,
            contact.coefficients, sums[i]);
      }
    }
  }
  StableStep limit{.step = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double inv_mass = particles.motion[i].inv_mass;
    if (inv_mass == 0.0 || !particles.is_own(i)) continue;
    const auto id = particles.properties[i].id;
    const auto limits = [&](double step) {  // of equal beads the first by id is named
      return step < limit.step || (step == limit.step && limit.bead >= 0 && id < limit.bead);
    };
    if (limits(sums[i].single_step)) {
      limit = {sums[i].single_step, particles.properties[i].id, sums[i].contacts,
               particles.motion[i].x, false};
    }
    const double rotation = inv_mass / rotation_share;
    const double step = largest_step(sums[i].k * rotation, sums[i].gamma * rotation);
    if (limits(step)) {
      limit = {step, particles.properties[i].id, sums[i].contacts, particles.motion[i].x, true};
    }
  }
  return limit;
}

}  // namespace packbed::dem
