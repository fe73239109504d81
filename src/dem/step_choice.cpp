// SPDX-License-Identifier: BSD-3-Clause
#include "dem/step_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dem/stable_step.hpp"

namespace packbed::dem {
namespace {

constexpr double safety = 0.8;

struct Contact {
  double stiffness;  ///< [N/m]
  double damping;    ///< [kg/s]
  double m_eff;      ///< moving mass [kg]

  [[nodiscard]] double time() const { return std::numbers::pi * std::sqrt(m_eff / stiffness); }
};

Contact contact_of(const ContactLaw& law, const Pair& pair) {
  return std::visit(
      [&](const auto& l) {
        const auto k = l.coefficients(pair);
        const double overlap = touching_overlap * pair.r_eff;
        return Contact{.stiffness = std::max(l.stiffness(overlap, k), l(overlap, 0.0, k).k_t),
                       .damping = l.damping(overlap, k),
                       .m_eff = pair.m_scaled};
      },
      law);
}

Pair pair_of(const BeadProperties& i, double d_j, double m_j, const Material& j, double scale) {
  const double m_eff = effective(i.mass, m_j);
  return {.i = i.material,
          .j = j,
          .r_eff = effective(0.5 * i.diameter, 0.5 * d_j),
          .m_eff = m_eff,
          .m_scaled = scale * m_eff};
}

}  // namespace

StepChoice choose_step(const ContactLaw& law,
                       const std::vector<BeadProperties>& beads,
                       const std::vector<Material>& walls,
                       double inertia_scale) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double mean = 0.0;
  for (const auto& bead : beads) mean += bead.diameter / static_cast<double>(beads.size());

  StepChoice choice{.step = infinite,
                    .contact_time = infinite,
                    .contact_time_per_diameter = infinite,
                    .smallest_diameter = infinite,
                    .stable_in_a_bed = infinite};
  const auto watch = [&choice](double time, double diameter) {
    choice.contact_time = std::min(choice.contact_time, time);
    choice.contact_time_per_diameter = std::min(choice.contact_time_per_diameter, time / diameter);
  };
  for (const auto& bead : beads) {
    const auto alike =
        contact_of(law, pair_of(bead, bead.diameter, bead.mass, bead.material, inertia_scale));
    watch(alike.time(), bead.diameter);
    choice.smallest_diameter = std::min(choice.smallest_diameter, bead.diameter);
    for (const auto& wall : walls) {
      const Pair pair{.i = bead.material,
                      .j = wall,
                      .r_eff = 0.5 * bead.diameter,
                      .m_eff = bead.mass,
                      .m_scaled = inertia_scale * bead.mass};
      watch(contact_of(law, pair).time(), bead.diameter);
    }
    const double mean_mass = bead.mass * std::pow(mean / bead.diameter, 3);
    const auto in_bed =
        contact_of(law, pair_of(bead, mean, mean_mass, bead.material, inertia_scale));
    const double mode_mass = rotation_share * inertia_scale * bead.mass;
    const double w2 = bed_contacts * in_bed.stiffness / mode_mass;
    const double c = bed_contacts * in_bed.damping / mode_mass;
    choice.stable_in_a_bed = std::min(choice.stable_in_a_bed, largest_step(w2, c));
  }
  choice.step =
      std::min(safety * choice.stable_in_a_bed, choice.contact_time / fewest_steps_per_contact);
  return choice;
}

}  // namespace packbed::dem
