// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What one step of the liquid works with; internal to Fluid.

#include <vector>

#include "fluid/fluid.hpp"

namespace packbed::fluid {

struct Fluid::Step {
  double dt = 0.0;
  double end = 1.0;  ///< weight of the forces at the end of the step
  Bed bed{};         ///< with all fields filled in

  // --- start of the step
  std::vector<double> eps_old{};      ///< all cells
  std::vector<double> volume_old{};   ///< all cells [m3]
  std::vector<Vec3> u_old{};          ///< all cells
  std::vector<double> q_old{};        ///< faces
  std::vector<double> pattern_old{};  ///< inner faces, of q_old

  // --- coefficients, fixed within the step
  std::vector<CellBalance> balance{};  ///< all cells
  std::vector<double> inertia{};       ///< rho (eps V) / (V dt), own cells [kg/(m3 s)]
  std::vector<double>
      implicit_drag{};  ///< weight x exchange, and inflow of source; own cells [kg/(m3 s)]
  std::vector<Vec3> fixed_force{};  ///< all that does not change with the iterate; own cells [N/m3]
  FaceMatrix matrix{};              ///< of a change of velocity [kg/s]
  std::vector<double> conductance{};
  std::vector<double> damping{};  ///< inner faces

  // --- last iterate
  std::vector<Vec3> fitted{};      ///< eps u of cells, and the q that it fits
  std::vector<double> fitted_q{};  ///< faces
  std::vector<double> push{};      ///< of the last corrector [Pa]

  StepReport report{};
};

}  // namespace packbed::fluid
