// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol steps "compress" and "relax": the plunger moves, with or without a liquid in the column.
/// Text: docs/theory/plunger.md.

#include <cstdint>
#include <string>

#include "column/coupled_bed.hpp"
#include "column/protocol/bed_rules.hpp"
#include "column/protocol/stage.hpp"

namespace packbed::column {

/// What the plunger goes to.
enum class PlungerTarget {
  height,  ///< [m]
  force    ///< of the beads on it [N]
};

struct PlungerOptions : DriveOptions {
  std::string name = "compress";  ///< of the protocol step
  double speed = 0.0;             ///< downwards; upwards if negative [m/s]
  PlungerTarget target = PlungerTarget::height;
  double value = 0.0;
  double hold = 0.0;          ///< time for which height or force is kept afterwards [s]
  bool touches_only = false;  ///< it stops at the bed, whatever the target
  bool withdraws = false;     ///< in the end to the upper end of the column
  double column_height = 0;   ///< where that is [m]
  /// Of the liquid through the plunger [m/s]; none: as it is.
  std::optional<double> flow = 0.0;
  std::optional<double> friction;  ///< bead on bead, of this step alone
  double resin_friction = 0.0;     ///< of others
  bool drained = false;            ///< no liquid carries the beads meanwhile
  double gravity = 0.0;            ///< [m/s2]
  double liquid_density = 0.0;     ///< 0: dry [kg/m3]
  double settled_height = 0.0;     ///< for words alone; 0: none [m]
};

enum class PlungerPhase : int {
  approach,  ///< through the free liquid above the bed, which passes it
  move,
  hold,
  withdraw,
  done
};

/// All that a plunger stage remembers.
struct PlungerState {
  int phase = 0;
  double phase_start = 0.0;     ///< [s]
  double next_output = 0.0;     ///< [s]
  double goal = 0.0;            ///< of the approach [m]
  double flow = 0.0;            ///< of the liquid [m/s]
  double start = 0.0;           ///< position of the plunger at the start of the move [m]
  double force = 0.0;           ///< on the plunger after the last slice [N]
  double force_at_start = 0.0;  ///< [N]
  double stiffness = 0.0;       ///< force over displacement, as last seen [N/m]
  double work = 0.0;            ///< of the plunger on the bed [J]
  double interval = 0.0;        ///< longest time between exchanges of beads and liquid [s]
  double inertia_scale = 1.0;   ///< largest so far
  std::int64_t slices = 0;
};

/// An interval of coupling, or some time steps of a dry bed, per slice.
class PlungerStage : public Stage {
 public:
  /// `liquid`: nullptr in a dry column.
  PlungerStage(const PlungerOptions& options, CoupledBed* liquid);

  [[nodiscard]] std::string_view name() const override { return options_.name; }
  /// Throws ConfigError if the target is not on the plunger's way.
  void begin(dem::Dem& dem) override;
  void leave(dem::Dem& dem) const override;
  After advance(dem::Dem& dem) override;
  [[nodiscard]] double share_done(const dem::Dem& dem) const override;
  [[nodiscard]] std::string doing() const override;
  [[nodiscard]] std::string result(const dem::Dem& dem) const override;
  [[nodiscard]] nlohmann::ordered_json save() const override;
  void load(const nlohmann::ordered_json& saved) override;

 private:
  [[nodiscard]] PlungerPhase phase() const { return static_cast<PlungerPhase>(state_.phase); }
  void enter(PlungerPhase phase, dem::Dem& dem);
  void choose_inertia(dem::Dem& dem);
  [[nodiscard]] double wanted_speed(double time, const dem::Dem& dem) const;
  [[nodiscard]] std::optional<double> time_left(double speed, const dem::Dem& dem) const;
  [[nodiscard]] double slice_time(const dem::Dem& dem) const;
  void step(double speed, double time, dem::Dem& dem);
  void end_phase_if_due(bool is_there, dem::Dem& dem);
  [[nodiscard]] bool has_reached_target(bool is_at_height, bool at_upper_end) const;
  void leave_hold(dem::Dem& dem);
  void end(dem::Dem& dem);
  void set_flow(double plunger_speed);

  PlungerOptions options_;
  CoupledBed* liquid_;
  PlungerState state_;
};

}  // namespace packbed::column
