// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/bed_look.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/bed_height.hpp"
#include "core/exact_sum.hpp"

namespace packbed::column {

BedLook look_at_bed(const dem::Dem& dem, double area) {
  const auto beads = analysis::own_beads(dem.particles());
  const auto figures = analysis::bed_figures(beads, area, dem.ranks());
  BedLook look{.height = figures.height, .porosity = figures.middle_porosity};
  std::vector<double> diameters;
  for (const auto& bead : beads) {
    diameters.push_back(2.0 * bead.radius);
    look.top = std::max(look.top, bead.x.z + bead.radius);
  }
  look.top = dem.ranks().max(look.top);
  look.mean_diameter = order_independent_sum(diameters, dem.ranks()) /
                       static_cast<double>(std::max<std::int64_t>(dem.bead_count(), 1));
  return look;
}

double middle_porosity(const dem::Dem& dem, double area) {
  const auto beads = analysis::own_beads(dem.particles());
  const double height = analysis::bed_height(beads, dem.ranks());
  return analysis::mean_porosity(beads, area, analysis::middle_half(height), dem.ranks());
}

Rest rest_of(const dem::Dem& dem) {
  const auto s = dem.sums();
  const auto& p = dem.particles();
  double fastest = 0.0;
  double speed = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!p.is_own(i)) continue;
    fastest = std::max(fastest, std::abs(p.motion[i].v.z));
    if (p.motion[i].inv_mass > 0.0) speed = std::max(speed, norm(p.motion[i].v));
  }
  const double contact = s.mean_contact_force;
  return {.unbalanced = contact > 0.0 ? s.mean_unbalanced_force / contact : 1.0,
          .fastest = dem.ranks().max(fastest),
          .speed = dem.ranks().max(speed),
          .coordination = s.coordination_number,
          .max_overlap = s.max_overlap_ratio};
}

bool is_steady(double height, double height_before, double mean_diameter) {
  return std::abs(height - height_before) < 1e-4 * mean_diameter;
}

double falling_time(double mean_diameter, double gravity, const dem::Dem& dem) {
  return std::sqrt(dem.options().inertia_scale * mean_diameter / gravity);
}

}  // namespace packbed::column
