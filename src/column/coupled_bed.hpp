// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A bed in the liquid that flows through it: beads and liquid stepped side by side, with an exchange at the
/// end of every interval. Text: docs/theory/coupling.md.

#include <cstdint>
#include <optional>

#include "core/stopwatch.hpp"
#include "coupling/coupling.hpp"
#include "dem/dem.hpp"
#include "fluid/fluid.hpp"
#include "mesh/column_mesh.hpp"

namespace packbed::column {

struct CoupledOptions {
  fluid::FluidOptions fluid{};
  coupling::CouplingOptions coupling{};
};

/// Figures of the liquid at the end of an interval, of all ranks.
struct LiquidFigures {
  /// Downwards: through the inlet, and what a plunger that moves displaces [m/s].
  double superficial_velocity = 0.0;
  bool plunger_moves = false;       ///< in the past interval
  double pressure_drop = 0.0;       ///< inlet less outlet, without the hydrostatic part [Pa]
  double frit_pressure_drop = 0.0;  ///< of both frits, on top of that [Pa]
  double pressure_force = 0.0;  ///< on the whole content, downwards: sum of p n over both ends [N]
  double wall_shear = 0.0;      ///< of the liquid on the walls, downwards [N]
  double continuity_error = 0.0;
  double courant = 0.0;
  double largest_solid_fraction = 0.0;  ///< of a cell
  double largest_reynolds = 0.0;        ///< of a bead
};

/// Of the liquid between two exchanges; the scheme is stable beyond.
inline constexpr double largest_courant = 1.0;

class CoupledBed {
 public:
  /// The liquid at rest; no bead feels it yet. The mesh ends at the plunger. All ranks make theirs at once.
  CoupledBed(const mesh::ColumnMesh& mesh,
             const mesh::ColumnShape& shape,
             const CoupledOptions& options,
             const Ranks& ranks);

  /// Puts the beads in, at rest like the liquid. All ranks call it.
  void start(dem::Dem& dem);
  /// The velocity at the inlet from now on; times are those of time(). It is what passes the plunger: one that
  /// moves displaces liquid besides.
  void set_flow(const fluid::FlowProgram& flow) { fluid_.set_inlet(flow); }

  [[nodiscard]] double flow() const;  ///< at the inlet now, as set [m/s]

  /// As much of `wanted` [s] as keeps the Courant number of the liquid below `largest_courant`: with its present
  /// velocities, and with a superficial velocity of `coming` in space [m/s]. All ranks call it.
  [[nodiscard]] double interval_within_limit(double wanted, double coming) const;

  /// An interval: `count` time steps of the beads, as long a step of the liquid, and the exchange. The upper
  /// end of the mesh goes with the plunger.
  void advance(dem::Dem& dem, std::int64_t count);

  [[nodiscard]] double time() const { return fluid_.time(); }  ///< of the liquid [s]
  [[nodiscard]] LiquidFigures figures() const;
  [[nodiscard]] const fluid::Fluid& fluid() const { return fluid_; }
  [[nodiscard]] const CoupledOptions& options() const { return options_; }
  [[nodiscard]] const mesh::ColumnShape& shape() const { return shape_; }

  /// Wall time of this process for weights, fields of the beads and drag, and for steps of the liquid [s].
  [[nodiscard]] double coupling_seconds() const { return coupling_time_.seconds(); }
  [[nodiscard]] double liquid_seconds() const { return liquid_time_.seconds(); }

  [[nodiscard]] fluid::FluidState save() const { return fluid_.save(); }
  /// For a resumed run; the beads have their drag from their own state.
  void load(const fluid::FluidState& state, const dem::Dem& dem);

 private:
  void share_like(const dem::Dem& dem);
  void share_anew();
  std::optional<double> follow_plunger(const dem::Dem& dem);
  [[nodiscard]] coupling::LiquidFields fields() const;

  mesh::ColumnMesh mesh_;
  mesh::ColumnShape shape_;
  CoupledOptions options_;
  Ranks ranks_;
  mesh::CellPartition partition_;
  fluid::Fluid fluid_;
  std::optional<coupling::Coupling> coupling_;  ///< of the present partition
  std::int64_t reach_in_layers_ = 0;            ///< that it was made for
  double plunger_speed_ = 0.0;                  ///< of the past interval, upwards [m/s]
  fluid::StepReport report_{};
  Stopwatch coupling_time_;
  Stopwatch liquid_time_;
};

}  // namespace packbed::column
