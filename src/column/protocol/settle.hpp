// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol step "settle": a cloud of beads falls under its dry weight, comes to rest, is brought
/// to the height and the porosity asked for, is put into the liquid and comes to rest again. Goes on
/// slice by slice, so that a run can write outputs and checkpoints between them. docs/theory/settling.md.

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "column/plunger.hpp"
#include "column/protocol/bed_look.hpp"
#include "column/protocol/stepping.hpp"
#include "dem/dem.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::column {

struct SettleOptions {
  mesh::ColumnShape shape;
  double gravity = 9.81;        ///< [m/s2]
  double liquid_density = 0.0;  ///< 0: dry, no buoyancy [kg/m3]

  // What is asked for. Porosity is that of the middle half of the bed.
  std::optional<double> bed_height;  ///< within one mean diameter [m]; none: all beads as they are
  std::optional<double> porosity;    ///< within porosity_tolerance
  std::optional<double> friction;    ///< bead on bead while settling; none: the resin's, or chosen
  double porosity_tolerance = 1e-3;
  // Of the resin, in force when the step ends.
  double resin_friction = 0.0;  ///< bead on bead
  double resin_rolling_friction = 0.0;

  /// Bead of an id, for beads that are added: the same whenever it is asked for.
  std::function<dem::BeadProperties(std::int64_t)> bead;
  std::uint64_t seed = 1;  ///< of the places of beads that are put in
  double cloud_solid_fraction = 0.5;
  /// z of the wall "lid" in the end [m], which is out of the way meanwhile; none: it is left alone.
  std::optional<double> lid;

  SteppingOptions stepping;
  /// Time in which a bead slows down while beads fall [s]; none: 8 falling times, d being the mean diameter.
  /// While the bed comes to rest it is one, sqrt(inertia scale d / gravity).
  std::optional<double> fall_damping;
  double damping_after = 0.0;  ///< rate that is set in the end; 0: none [1/s]
  double rest_limit = 1e-5;    ///< unbalanced / contact force at which a dry bed counts as at rest
  double unbalanced_limit = 1e-6;  ///< of the bed at rest in the end: unbalanced / contact force
  double speed_limit = 1e-6;       ///< of its fastest bead, rattlers too [m/s]
  /// Falling times for which a bed without unbalanced forces waits for a bead that still moves.
  double patience = 10.0;
  std::int64_t slice = 500;          ///< time steps
  std::int64_t most_slices = 20000;  ///< of a phase, before it is given up
};

enum class SettlePhase : std::int32_t { start, fall, rest, densify, submerge, done };

/// Word for a phase, for logs: "fall", "rest", ...
const char* name(SettlePhase phase);

/// Everything that the next slices depend on, beside the beads; a plain record for checkpoints.
struct SettleState {
  SettlePhase phase = SettlePhase::start;
  std::int32_t falls = 0;  ///< how often the whole bed was let fall
  std::int32_t count_changes = 0;
  std::int32_t corrections = 0;   ///< of the porosity, after the liquid came in
  std::int64_t slices = 0;        ///< done
  std::int64_t phase_slices = 0;  ///< done of this phase
  double phase_start = 0.0;       ///< time when this phase began [s]
  double wetting_time = 0.0;      ///< in which the weight becomes that in the liquid [s]
  std::int64_t next_id = 0;       ///< of the next bead that is added
  double friction = 0.0;          ///< bead on bead, at which the bed settles
  double looseness = 1.0;         ///< share of friction that densification has left
  double aim = 0.0;               ///< porosity of the dry bed
  double sag = 3e-3;              ///< porosity lost after a densification; before the first a guess
  double stopped_at = 0.0;        ///< porosity at which one was ended just now; 0 otherwise
  // Figures of the last slice.
  double bed_height = 0.0;  ///< [m]
  double porosity = 1.0;
  double unbalanced = 1.0;
  double coordination = 0.0;
  double max_overlap = 0.0;
  double speed = 0.0;  ///< of the fastest bead [m/s]
  double resting_since =
      -1.0;  ///< time from which on all but its speed counts as rest [s]; < 0: not yet
  std::int64_t pushes = 0;       ///< of beads that tipped over
  double height_before = 0.0;    ///< one slice earlier [m]
  double porosity_before = 1.0;  ///< likewise
};

class Settle {
 public:
  explicit Settle(SettleOptions options, const SettleState& state = {})
      : options_(std::move(options)), state_(state) {}

  /// Does one slice of time steps, and what follows from it; `dem` is replaced where beads are added
  /// or taken away. Returns whether there is more to do. All ranks call it. Throws ConfigError where
  /// height or porosity cannot be reached, DivergenceError where the bed does not come to rest.
  bool advance(dem::Dem& dem);

  [[nodiscard]] const SettleState& state() const { return state_; }
  [[nodiscard]] const SettleOptions& options() const { return options_; }

 private:
  void begin(dem::Dem& dem);
  void fall(dem::Dem& dem);
  void run_slice(dem::Dem& dem);
  void run_densifying(dem::Dem& dem);
  void push_tipping(dem::Dem& dem);
  [[nodiscard]] bool may_tip() const;
  void look(dem::Dem& dem);
  void enter(SettlePhase phase, const dem::Dem& dem);
  void weigh(double liquid_density, dem::Dem& dem) const;
  void enter_fall(dem::Dem& dem);
  void wet(dem::Dem& dem) const;
  void enter_rest(SettlePhase phase, dem::Dem& dem);
  void after_rest(dem::Dem& dem);
  void after_densify(dem::Dem& dem);
  void after_submerge(dem::Dem& dem);
  [[nodiscard]] bool rests_for_good(const dem::Dem& dem);
  void loosen(dem::Dem& dem);
  void set_looseness(double looseness, dem::Dem& dem);
  void fall_again(dem::Dem& dem);
  void finish(dem::Dem& dem);
  bool has_porosity(dem::Dem& dem);
  bool has_height(double near, dem::Dem& dem);
  [[nodiscard]] bool has_landed(const dem::Dem& dem) const;
  [[nodiscard]] double wetting_time() const;
  [[nodiscard]] bool is_wet(const dem::Dem& dem) const;
  [[nodiscard]] bool is_at_rest(double unbalanced) const;
  [[nodiscard]] double working_friction() const;
  [[nodiscard]] double area() const { return mesh::cross_section(options_.shape); }
  [[noreturn]] void refuse_porosity(std::string_view why) const;

  SettleOptions options_;
  SettleState state_;
  // Of this slice.
  std::optional<dem::Snapshot> before_;  ///< shortly before its end
  Rest rest_;
  BedLook bed_;
};

}  // namespace packbed::column
