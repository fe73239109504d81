// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "column/coupled_bed.hpp"
#include "column/protocol/bed_rules.hpp"
#include "column/protocol/stage.hpp"

namespace packbed::column {

/// A flow that goes from one velocity to another in equal steps, or stays as it is.
struct FlowOptions : DriveOptions {
  std::string name = "flow_ramp";  ///< of the protocol step
  std::optional<double> from =
      0.0;                     ///< superficial velocity, downwards [m/s]; none: the present one
  double to = 0.0;             ///< [m/s]
  std::int64_t steps = 1;      ///< plateaus
  std::optional<double> hold;  ///< time of each [s]; none: until steady
  double hold_limit = 0.0;     ///< longest time of a plateau [s]
  bool ramps = true;           ///< to the next plateau in a linear ramp; else in a jump
  /// Bed height at which the stage ends, whatever the flow is by then [m].
  std::optional<double> until_height;
};

/// All that a flow stage remembers.
struct FlowState {
  double from = 0.0;            ///< superficial velocity that it came from [m/s]
  std::int64_t plateau = 0;     ///< that is under way, from 0
  double started = 0.0;         ///< when it began, by the time of the liquid [s]
  double started_of_run = 0.0;  ///< by that of the beads [s]
  double window_started = 0.0;  ///< the last look at how steady it is [s]
  double height = 0.0;          ///< of the bed then [m]
  double pressure_drop = 0.0;   ///< then [Pa]
  double next_output = 0.0;     ///< [s]
  std::int64_t unsteady = 0;    ///< plateaus that were not steady when their time was over
  double inertia_scale = 1.0;   ///< the largest so far
  double interval = 0.0;        ///< longest time between exchanges of beads and liquid [s]
  Samples drops;  ///< pressure drop while the velocity stays [Pa], as far back as noise may want it
};

/// The steps "flow_ramp" and "hold": an interval of coupling per slice. A plateau is steady when bed height
/// and pressure drop change more slowly than `steady_rate`.
class FlowStage : public Stage {
 public:
  FlowStage(const FlowOptions& options, CoupledBed& liquid);

  [[nodiscard]] std::string_view name() const override { return options_.name; }
  void begin(dem::Dem& dem) override;
  After advance(dem::Dem& dem) override;
  [[nodiscard]] std::optional<Plateau> finished_plateau() const override { return finished_; }
  [[nodiscard]] double share_done(const dem::Dem& dem) const override;
  [[nodiscard]] std::string doing() const override;
  [[nodiscard]] std::string result(const dem::Dem& dem) const override;
  [[nodiscard]] nlohmann::ordered_json save() const override;
  void load(const nlohmann::ordered_json& saved) override;

 private:
  [[nodiscard]] double velocity(std::int64_t plateau) const;
  [[nodiscard]] double ramp_time() const;
  [[nodiscard]] bool is_low_enough(const dem::Dem& dem) const;
  void follow_rules(dem::Dem& dem);
  void start_plateau(const dem::Dem& dem);
  void end_plateau(const dem::Dem& dem, bool is_steady);
  void watch_drop();
  void set_flow();
  [[nodiscard]] bool looks_steady(const dem::Dem& dem);
  struct Look {
    bool is_over = false;
    bool is_steady = false;
  };
  [[nodiscard]] Look look_at_plateau(const dem::Dem& dem);

  FlowOptions options_;
  CoupledBed& liquid_;
  FlowState state_;
  std::optional<Plateau> finished_;  ///< with the last slice
};

/// Relative change per second of pressure drop, and of bed height, below which a plateau counts as steady.
inline constexpr double steady_rate = 0.02;
inline constexpr double steady_height_rate = 0.0005;

}  // namespace packbed::column
