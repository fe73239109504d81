// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/bed_rules.hpp"

#include <algorithm>
#include <cmath>

#include "column/protocol/bed_look.hpp"

namespace packbed::column {

std::optional<BedState> bed_state(const DriveOptions& options, const dem::Dem& dem) {
  const auto& g = options.grains;
  const auto bed = look_at_bed(dem, options.area);
  const auto rest = rest_of(dem);
  if (bed.height <= 0.0 || rest.coordination <= 0.0) return std::nullopt;
  const double phi = 1.0 - bed.porosity;
  return BedState{
      .height = bed.height,
      .modulus = dem::estimated_modulus(rest.coordination, phi, g.stiffness, g.diameter),
      .bulk_density = phi * g.density,
      .solid_fraction = phi};
}

dem::DraggedBed dragged_bed(const BedState& bed,
                            const GrainProperties& grains,
                            bool presses,
                            double flow_step) {
  const double drag_rate = dem::kozeny_carman_drag_rate(bed.solid_fraction, grains.viscosity,
                                                        grains.bead_diameter, grains.density);
  const double alone =
      grains.density * grains.bead_diameter * grains.bead_diameter / (18.0 * grains.viscosity);
  return {.drag_rate = drag_rate,
          .height = bed.height,
          .modulus = bed.modulus,
          .bulk_density = bed.bulk_density,
          .loose_drag_time = presses ? 1.0 / drag_rate : alone,
          .flow_step = flow_step};
}

void scale_inertia(const DriveOptions& options, double scale, dem::Dem& dem) {
  const double diameter = options.inertia_by_size ? options.grains.inertia_diameter : 0.0;
  dem.set_inertia({.scale = scale, .diameter = diameter});
}

double longest_step(const DriveOptions& options, const dem::InertiaScale& inertia) {
  const double shortest = options.stepping.longest_step;
  if (inertia.diameter <= 0.0 || inertia.scale <= 1.0) return shortest * std::sqrt(inertia.scale);
  const double between = 0.5 * inertia.diameter * (options.smallest_diameter + inertia.diameter);
  return std::hypot(shortest,
                    options.longest_step_per_diameter * std::sqrt((inertia.scale - 1.0) * between));
}

void choose_step(const DriveOptions& options, dem::Dem& dem) {
  auto stepping = options.stepping;
  stepping.longest_step = longest_step(options, dem.options().inertia());
  choose_step(stepping, dem);
}

std::int64_t cut_into_steps(double interval, dem::Dem& dem) {
  constexpr double rounding = 1e-9;
  const auto count = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(interval / dem.options().step - rounding)));
  dem.set_step(interval / static_cast<double>(count));
  return count;
}

}  // namespace packbed::column
