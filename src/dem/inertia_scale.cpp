// SPDX-License-Identifier: BSD-3-Clause
#include "dem/inertia_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::dem {
namespace {

using Named = std::pair<const char*, double>;

template <std::size_t n>
void require_positive(const std::array<Named, n>& values) {
  for (const auto& [name, value] : values) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw ValueError(
        fmt::format("the rule for the inertia scale needs a positive {}, not {}", name, value));
  }
}

/// The smaller of two limits, at least 1.
InertiaChoice smaller(const InertiaChoice& a, const InertiaChoice& b) {
  const auto& least = a.scale <= b.scale ? a : b;
  if (least.scale >= 1.0) return least;
  return {.scale = 1.0,
          .reason = "inertia is not scaled: even 1 is above the limit of " + least.reason};
}

/// Rounded down to one digit.
double one_digit(double a) {
  const double power = std::pow(10.0, std::floor(std::log10(a)));
  return std::floor(a / power * (1.0 + 1e-12)) * power;
}

/// a / b; 0 where both are.
double share(double a, double b) { return a > 0.0 ? a / b : 0.0; }

}  // namespace

double estimated_modulus(double coordination,
                         double solid_fraction,
                         double stiffness,
                         double diameter) {
  return 3.0 * coordination * solid_fraction * stiffness / (5.0 * std::numbers::pi * diameter);
}

InertiaChoice free_inertia_scale() { return {.scale = 1.0, .reason = "beads move freely"}; }

InertiaChoice driven_inertia_scale(const DrivenBed& bed) {
  require_positive(std::array{Named{"speed", bed.speed}, Named{"modulus", bed.modulus},
                              Named{"bulk density", bed.bulk_density},
                              Named{"strain", bed.strain}});
  const double mach = bed.speed / std::sqrt(bed.modulus / bed.bulk_density);  // at s = 1
  const double by_speed = std::pow(most_speed_ratio / mach, 2);
  const double by_energy = 3.0 * most_kinetic_share * std::pow(bed.strain / mach, 2);
  return smaller({.scale = by_speed,
                  .reason = fmt::format("plunger speed / wave speed at most {}", most_speed_ratio)},
                 {.scale = by_energy,
                  .reason = fmt::format("kinetic / elastic energy at most {} at a strain of {:.3g}",
                                        most_kinetic_share, bed.strain)});
}

double kozeny_carman_drag_rate(double solid_fraction,
                               double viscosity,
                               double diameter,
                               double density) {
  const double eps = 1.0 - solid_fraction;
  return 180.0 * viscosity * solid_fraction / (eps * eps * eps * diameter * diameter * density);
}

double damping_ratio_of_bed(const DraggedBed& bed, double scale) {
  const double w =
      0.5 * std::numbers::pi / bed.height * std::sqrt(bed.modulus / (bed.bulk_density * scale));
  return bed.drag_rate / (2.0 * scale * w);
}

double consolidation_time(const DraggedBed& bed) {
  const double length = 2.0 * bed.height / std::numbers::pi;
  return bed.drag_rate * bed.bulk_density * length * length / bed.modulus;
}

InertiaChoice dragged_inertia_scale(const DraggedBed& bed) {
  require_positive(std::array{
      Named{"drag rate", bed.drag_rate}, Named{"height", bed.height}, Named{"modulus", bed.modulus},
      Named{"bulk density", bed.bulk_density},
      Named{"drag time of loose beads", bed.loose_drag_time}, Named{"flow step", bed.flow_step}});
  return smaller(
      {.scale = std::pow(damping_ratio_of_bed(bed, 1.0) / least_damping_ratio, 2),
       .reason = fmt::format("damping ratio of the bed at least {}", least_damping_ratio)},
      {.scale = bed.flow_step / bed.loose_drag_time,
       .reason = fmt::format("drag time of loose beads at most the flow step of {:.3g} s",
                             bed.flow_step)});
}

std::optional<std::string> inertia_warning(std::string_view stage,
                                           double scale,
                                           const Sums& s,
                                           BedMedium medium) {
  const double kinetic = share(s.kinetic_energy, s.elastic_energy);
  const double unbalanced = share(s.mean_unbalanced_force, s.mean_contact_force);
  const bool is_dry = medium == BedMedium::dry;
  const double excess =
      std::max(is_dry ? kinetic / most_kinetic_share : 0.0, unbalanced / most_unbalanced_share);
  if (excess <= 1.0) return std::nullopt;
  auto figures = fmt::format("unbalanced/contact force {:.2g} (limit {:.0e})", unbalanced,
                             most_unbalanced_share);
  if (is_dry) {
    figures = fmt::format("kinetic/elastic energy {:.2g} (limit {:.0e}), {}", kinetic,
                          most_kinetic_share, figures);
  }
  const double fine = scale / excess;
  if (scale <= 1.0 || fine < 1.0) {
    return fmt::format(
        "{}: the bed was not at rest with inertia scale {:.3g}: {}; move more slowly or wait "
        "longer",
        stage, scale, figures);
  }
  return fmt::format("{}: inertia scale {:.3g} was too large: {}; {:.0e} would have been fine",
                     stage, scale, figures, one_digit(fine));
}

}  // namespace packbed::dem
