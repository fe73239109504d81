// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The liquid in a column: volume-averaged Navier-Stokes on this rank's part of the mesh.
///
///   d(eps)/dt + div(eps u) = s
///   rho [d(eps u)/dt + div(eps u u)] = -eps grad p + div(eps tau) + eps rho g - exchange (u - u_s) + rho s u_s + f
///   tau = mu (grad u + grad u^T - 2/3 div u)
///
/// Form A (van Buijtenen et al. 2011, thesis eqs 4.1 to 4.3). Text: docs/theory/liquid.md.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fluid/balance.hpp"
#include "fluid/bed.hpp"
#include "fluid/border.hpp"
#include "fluid/domain.hpp"
#include "fluid/fluid_state.hpp"
#include "fluid/forces.hpp"
#include "fluid/linear_solver.hpp"
#include "fluid/options.hpp"
#include "fluid/pressure.hpp"

namespace packbed::fluid {

/// What a step took and left. Residuals are worked out by `Fluid` itself.
struct StepReport {
  SolveReport momentum{};               ///< sums of three components
  std::vector<SolveReport> pressure{};  ///< one per corrector [m3/s]
  std::vector<double> residual{};       ///< of the pressure equation after each corrector [m3/s]
  double continuity_error = 0.0;  ///< 2-norm of that of the cells, over that of what passes them
  double largest_error = 0.0;     ///< of a cell, over the largest that passes one
  double courant = 0.0;           ///< largest dt / (2 eps V) sum_f |flux|
};

class Fluid {
 public:
  /// At rest, void fraction 1, time 0. All ranks make theirs at once. Throws ValueError for options out of range.
  Fluid(const FluidOptions& options,
        const mesh::ColumnMesh& mesh,
        const mesh::CellPartition& partition,
        const Ranks& ranks);

  /// Sets the state: a bed, a velocity (interstitial, one per own cell) and a time. Fluxes are made from it.
  void start(const Bed& bed, std::span<const Vec3> u, double time);

  /// One step of dt [s]; `bed` at its end. `top`: z of the upper end of the mesh then, if it moves.
  StepReport step(double dt, const Bed& bed, std::optional<double> top = {});

  /// Velocity at the inlet from now on. The inlet must be an Inlet.
  void set_inlet(const FlowProgram& superficial) {
    std::get<Inlet>(options_.boundaries.inlet).superficial = superficial;
  }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const Domain& domain() const { return domain_; }
  [[nodiscard]] const Border& border() const { return border_; }
  [[nodiscard]] const FluidOptions& options() const { return options_; }

  // --- fields; cells: own ones first, then halo
  [[nodiscard]] const std::vector<double>& eps() const { return eps_; }
  [[nodiscard]] const std::vector<Vec3>& u() const { return u_; }  ///< interstitial [m/s]
  /// Pressure without its hydrostatic part, p - rho g.x [Pa].
  [[nodiscard]] const std::vector<double>& dynamic_pressure() const { return p_; }
  [[nodiscard]] double pressure(std::size_t cell) const;  ///< [Pa]
  /// Of the dynamic pressure, from the balance of momentum of each cell [Pa/m].
  [[nodiscard]] const std::vector<Vec3>& pressure_gradient() const { return grad_p_; }
  /// Convective and viscous force per volume, own cells [N/m3].
  [[nodiscard]] const std::vector<Vec3>& force() const { return force_; }
  /// Dynamic pressure at border faces, on the side of the column where there is a frit [Pa].
  [[nodiscard]] const std::vector<double>& border_pressure() const { return border_p_; }
  /// Pressure drop of the frit at a border face over the superficial velocity through it [Pa s/m].
  [[nodiscard]] double frit_slope(std::size_t border_face) const {
    return options_.mu_f * border_.frit_resistance[border_face];
  }
  /// Force of the liquid on the wall at a border face, along it; 0 where there is no wall [N].
  [[nodiscard]] Vec3 wall_shear(std::size_t border_face) const {
    return fluid::wall_shear(domain_, border_, options_, flow(), face_eps_, border_face);
  }
  /// Normal superficial velocity (eps u).n of faces [m/s].
  [[nodiscard]] const std::vector<double>& q() const { return q_; }
  /// Volume flux relative to the face: |S| (q - eps_f w) on faces that move with w [m3/s].
  [[nodiscard]] const std::vector<double>& flux() const { return flux_; }

  /// All that a run needs to go on, of own cells and the faces that they own (fluid_state.hpp).
  [[nodiscard]] FluidState save() const;
  /// Takes a state that has at least the cells of this part (with halo) and their faces, in any order. Throws
  /// DataError if something is missing. On as many ranks as it was saved the run goes on with the same bits.
  void load(const FluidState& state);
  /// Same liquid, cells owned anew; all ranks at once.
  void repartition(const mesh::CellPartition& before, const mesh::CellPartition& after);

 private:
  struct Step;

  [[nodiscard]] Flow flow() const { return {.u = u_, .q = q_, .flux = flux_, .eps = eps_}; }
  void set_flux();
  void begin(Step& s, const Bed& bed, std::optional<double> top);
  [[nodiscard]] std::vector<Vec3> predicted(Step& s, const std::vector<Vec3>& force);
  void correct(Step& s, const std::vector<Vec3>& force);
  [[nodiscard]] std::vector<double> pattern();
  void damp(Step& s, const std::vector<double>& pattern_now);
  void solve_pressure(Step& s);
  void set_face_velocity(const Step& s);
  void finish(Step& s);
  void set_balance(Step& s);
  void put_frits_in_series(std::vector<double>& conductance) const;
  void set_velocity(Step& s);
  [[nodiscard]] std::vector<Tensor> superficial_gradient();
  [[nodiscard]] std::vector<double> displaced(const Step& s) const;
  [[nodiscard]] std::vector<double> continuity_errors(const Step& s) const;
  void report(Step& s) const;

  FluidOptions options_;
  Domain domain_;
  Border border_;
  PressureSolver pressure_solver_;
  LinearSolver momentum_solver_;
  double time_ = 0.0;
  std::vector<double> eps_, p_, q_, flux_, mesh_speed_, border_p_;
  std::vector<Vec3> u_, grad_p_, force_, drag_;
  std::vector<double> face_eps_;
};

}  // namespace packbed::fluid
