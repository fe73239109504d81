// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <fmt/format.h>

#include "tests/report/small_run.hpp"

namespace packbed::test {

/// What `packbed analyze` leaves, of a SmallRun: packing is over with stage 1, the flow is 2 mm/s after stage 2 and
/// 1 mm/s after stage 3. `spread` is S_mean after packing; each later stage adds a thousandth.
inline void add_analysis(const SmallRun& run, double spread, double width = 20.0) {
  std::string rows =
      "frame,time_s,stage,stage_name,ends_stage,packing_end,superficial_velocity_m_s,bed_height_m,"
      "S_mean,S_init,IPD_absolute_d,share_above_6,sigma_z2_m2_s2,velocity_variation,wall_share,"
      "coordination_without_rattlers,largest_overlap,granular_temperature_m2_s2,D_over_d_eff\n";
  const char* names[] = {"settle", "flow_ramp", "hold"};
  const double velocity[] = {0.0, 0.002, 0.001};
  for (int stage = 1; stage <= 3; ++stage) {
    const double more = 0.001 * (stage - 1);
    rows += fmt::format("{},{},{},{},1,1,{},0.008,{},{},0.9,0.002,{},0.4,0.1,5,0.03,0,{}\n", stage,
                        stage, stage, names[stage - 1], velocity[stage - 1], spread + more, more,
                        stage == 1 ? "" : fmt::format("{}", 1e-4 * stage * spread), width);
    run.write(fmt::format("analysis/forces_{:06}.csv", stage),
              "force_low,force_high,contacts,density\n0,0.5,10,1.5\n0.5,1,0,0\n1,1.5,2,0.5\n");
    run.write(
        fmt::format("analysis/angles_{:06}.csv", stage),
        "angle_low_deg,angle_high_deg,contacts,density,mean_force,largest_force,share_above_3\n"
        "0,45,5,1.1,0.9,3,0.02\n45,90,5,0.9,1.1,4,0.04\n");
    run.write(fmt::format("analysis/stress_{:06}.csv", stage),
              fmt::format("z_low_m,z_high_m,stress_zz_Pa,lateral_ratio\n0,0.004,{}00,0.5\n"
                          "0.004,0.008,10,\n",
                          stage));
  }
  run.write("analysis/analysis.csv", rows);
}

}  // namespace packbed::test
