// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A case as the program uses it: every value checked, filled in and in SI. Keys and meaning are
/// in docs/manual/case-file.md; one struct per section of the file.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/bead_csv.hpp"
#include "mesh/cell_counts.hpp"
#include "mesh/column_shape.hpp"
#include "resin/size_distribution.hpp"
#include "setup/echo.hpp"
#include "setup/read_measured.hpp"

namespace packbed::setup {

struct Material {
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;
  bool operator==(const Material&) const = default;
};

struct ColumnOptions {
  mesh::ColumnShape shape;
  Material wall;                          ///< of the tube, or of all walls of a box
  Material frit;                          ///< of both ends
  double inlet_resistance = 0.0;          ///< of the frit there, thickness / permeability [1/m]
  double outlet_resistance = 0.0;         ///< likewise [1/m]
  std::optional<mesh::MeshOptions> mesh;  ///< for the liquid; none when dry
  /// Superficial velocity of a relative hydrodynamic load (RHL) of 1 [m/s].
  std::optional<double> full_load{};
  bool operator==(const ColumnOptions&) const = default;
};

enum class ContactLawName { hooke, hertz };
enum class RollingLawName { none, cdt, epsd };

struct ResinOptions {
  std::string name;                              ///< of the library, or the user's own
  std::optional<resin::SizeDistribution> sizes;  ///< of real beads; none if a bead file has them
  // Properties of beads. Those that a bead file gives for each bead may be absent here.
  std::optional<double> density;         ///< wet [kg/m3]
  std::optional<double> youngs_modulus;  ///< of the contact law chosen [Pa]
  std::optional<double> poisson_ratio;
  double restitution = 0.0;
  double friction = 0.0;  ///< bead on bead, Coulomb
  double wall_friction = 0.0;
  double rolling_friction = 0.0;
  ContactLawName contact = ContactLawName::hooke;
  std::optional<double> characteristic_velocity;  ///< of the Hooke law, thesis eq. 4.21 [m/s]
  RollingLawName rolling = RollingLawName::epsd;
  bool viscous = false;          ///< restitution falls with the impact Stokes number
  double restitution_max = 0.0;  ///< of viscous restitution
  double critical_stokes = 0.0;  ///< of viscous restitution
  bool tension = false;          ///< whether the damped normal force may pull
  double coarse_grain = 1.0;     ///< diameter of a grain / diameter of a bead
  bool operator==(const ResinOptions&) const = default;
};

struct LiquidOptions {
  std::string name;
  double density;                              ///< [kg/m3]
  double viscosity;                            ///< [Pa s]
  std::optional<double> temperature;           ///< [K]; none where density and viscosity were given
  std::optional<double> wall_void_fraction{};  ///< at walls, in their shear; none: that of the cell
  bool operator==(const LiquidOptions&) const = default;
};

enum class DragLawName { koch_hill, ergun, gidaspow, di_felice, beetstra };

/// Of the liquid on the beads.
struct DragOptions {
  DragLawName law = DragLawName::koch_hill;
  std::optional<double> min_void_fraction{};  ///< the law sees no smaller one; none: as it is
  bool operator==(const DragOptions&) const = default;
};

enum class OverlapRuleName { full, merged };
enum class CouplingSchemeName { frozen_flux, frozen_velocity };

/// How beads and liquid exchange what they give each other.
struct CouplingOptions {
  OverlapRuleName overlap = OverlapRuleName::full;
  CouplingSchemeName scheme = CouplingSchemeName::frozen_flux;
  std::optional<double>
      averaging_width{};             ///< reach of the kernel [m]; none: chosen by the program
  std::optional<double> interval{};  ///< longest between exchanges [s]; none: chosen likewise
  bool operator==(const CouplingOptions&) const = default;
};

struct BeadOptions {
  std::optional<std::filesystem::path> csv;
  io::BeadTable table;                       ///< of `csv`; empty otherwise
  std::optional<std::int64_t> count;         ///< grains to make, where a number is asked for
  std::optional<std::filesystem::path> run;  ///< folder of the run whose last state the beads are
  std::int64_t beads_of_run = 0;             ///< their number
  bool operator==(const BeadOptions&) const = default;
};

// --- protocol

struct Run {
  double duration;  ///< [s]
  bool operator==(const Run&) const = default;
};

struct Settle {
  std::optional<double> bed_height;  ///< to reach [m]; none if the number of beads is given
  std::optional<double> friction;    ///< bead on bead, for the settling alone
  std::optional<double> porosity;    ///< to reach
  bool operator==(const Settle&) const = default;
};

enum class FlowChange { jump, ramp };

struct FlowRamp {
  double from;  ///< superficial velocity [m/s]
  double to;    ///< superficial velocity [m/s]
  std::int64_t steps;
  std::optional<double> hold;  ///< at each step [s]; none: until steady
  double hold_limit;           ///< longest hold until steady [s]
  FlowChange change;           ///< within a step
  bool operator==(const FlowRamp&) const = default;
};

struct Hold {
  double duration;             ///< [s]
  std::optional<double> flow;  ///< superficial velocity [m/s]; none: as it is
  bool operator==(const Hold&) const = default;
};

/// What the plunger goes to.
enum class PlungerGoal {
  height,
  compression,
  further_compression,  ///< than the plunger, or the settled bed, has now
  compression_factor,
  packing_factor,
  force,
  pressure
};

/// A move of the plunger, down ("compress") or up ("relax").
struct PlungerMove {
  double speed;  ///< [m/s]
  PlungerGoal goal;
  double value;                      ///< of the goal: m, -, -, -, -, N, Pa
  double hold = 0.0;                 ///< time for which it is kept [s]
  double flow = 0.0;                 ///< superficial velocity meanwhile [m/s]
  std::optional<double> friction{};  ///< bead on bead, for this step alone
  bool drained = false;              ///< no liquid, for this step alone
  bool operator==(const PlungerMove&) const = default;
};

struct Compress {
  PlungerMove move;
  bool operator==(const Compress&) const = default;
};

struct Relax {
  PlungerMove move;
  bool withdraw;  ///< in the end to the upper end of the column
  bool operator==(const Relax&) const = default;
};

/// A flow that packs, then the plunger on the bed, then no flow.
struct FlowPack {
  double flow;  ///< superficial velocity, the highest one [m/s]
  std::int64_t steps;
  std::optional<double> hold;                 ///< at each step [s]; none: until steady
  double hold_limit;                          ///< longest hold until steady [s]
  std::optional<double> compression;          ///< to reach; none: what the flow gives
  std::optional<double> further_compression;  ///< likewise, than there is
  double plunger_speed;                       ///< [m/s]
  bool operator==(const FlowPack&) const = default;
};

/// A load: a high and a low flow in turn.
struct Cycle {
  std::int64_t count;
  double high;                          ///< superficial velocity [m/s]
  double low;                           ///< [m/s]
  std::optional<double> high_duration;  ///< [s]; none: until steady
  std::optional<double> low_duration;   ///< [s]; none: until steady
  double hold_limit;                    ///< longest hold until steady [s]
  bool operator==(const Cycle&) const = default;
};

/// The column stands without flow until it is at rest.
struct Store {
  double hold_limit;  ///< longest time simulated [s]
  bool operator==(const Store&) const = default;
};

/// The column is shaken: one period of a sine of acceleration per tap.
struct Tap {
  double amplitude;  ///< of the sine, as a displacement [m]
  double frequency;  ///< [1/s]
  std::int64_t count;
  bool operator==(const Tap&) const = default;
};

struct ProtocolStep;

struct Repeat {
  std::int64_t count;
  std::vector<ProtocolStep> steps;
  bool operator==(const Repeat& other) const;
};

struct ProtocolStep {
  std::variant<Run, Settle, Tap, FlowRamp, Hold, Compress, Relax, FlowPack, Cycle, Store, Repeat>
      what;
  bool operator==(const ProtocolStep& other) const;
};

// Written out: clang 14 does not end when it defaults these two, which contain each other.
inline bool ProtocolStep::operator==(const ProtocolStep& other) const { return what == other.what; }
inline bool Repeat::operator==(const Repeat& other) const {
  return count == other.count && steps == other.steps;
}

// --- numerics and output

/// Whether a flow and the plunger scale the inertia of small beads more, or that of all alike.
enum class InertiaScaling { by_size, uniform };

struct NumericsOptions {
  std::optional<double> step;           ///< of the beads [s]; none: computed
  std::optional<double> inertia_scale;  ///< none: chosen by the program
  InertiaScaling inertia_scaling = InertiaScaling::by_size;
  std::uint64_t seed = 0;
  bool gravity = true;
  std::optional<double> background_damping;  ///< time in which a free bead slows down [s]
  double overlap_limit = 0.3;                ///< of the smaller diameter, beyond which a run stops
  bool force_step = false;                   ///< run with a step that is known to be too long
  bool operator==(const NumericsOptions&) const = default;
};

struct OutputOptions {
  std::string directory;                      ///< as given; runs/<name of the case> by default
  double interval = 0.0;                      ///< simulated time between rows of series.csv [s]
  bool beads_csv = false;                     ///< also write frames/beads_N.csv at each row
  bool frames = true;                         ///< write frames/beads_N.hdf and contacts_N.hdf
  std::optional<double> frame_interval;       ///< simulated [s]; none: at the ends of stages
  bool analysis = true;                       ///< analyze frames at the end of the run
  std::optional<double> checkpoint_interval;  ///< wall time [s]; none: only when a run is stopped
  std::optional<std::filesystem::path> measured;  ///< table of points shown in the report
  MeasuredFlow measured_points;                   ///< of `measured`
  bool operator==(const OutputOptions&) const = default;
};

struct Case {
  std::filesystem::path file;
  std::string title;
  ColumnOptions column;
  ResinOptions resin;
  std::optional<LiquidOptions> liquid;  ///< none: dry
  DragOptions drag;
  CouplingOptions coupling;
  BeadOptions beads;
  std::vector<ProtocolStep> protocol;
  NumericsOptions numerics;
  OutputOptions output;
  Echo echo;
};

}  // namespace packbed::setup
