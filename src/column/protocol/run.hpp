// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The protocol step "run": beads move for a time under what is there.

#include <cstdint>

#include "column/protocol/stage.hpp"

namespace packbed::column {

/// How a duration is cut into steps: all equal and a whole number of them, none longer than asked.
struct RunPlan {
  std::int64_t steps;
  double step;                ///< [s]
  std::int64_t output_every;  ///< steps between outputs
};

/// `duration`, `step`, `interval` in s; no steps for no duration.
RunPlan plan_run(double duration, double step, double interval);

/// Steps through the plan; an output is due after every `output_every` steps and at the end.
/// At the start and at an output DivergenceError for overlaps beyond the limit, and unless
/// `force_step` for a step above the stable one of the contacts that there are.
class RunStage : public Stage {
 public:
  RunStage(const RunPlan& plan, bool force_step) : plan_(plan), force_step_(force_step) {}

  [[nodiscard]] std::string_view name() const override { return "run"; }
  void begin(dem::Dem& dem) override;
  After advance(dem::Dem& dem) override;
  [[nodiscard]] double share_done(const dem::Dem& dem) const override;
  [[nodiscard]] std::string result(const dem::Dem& dem) const override;
  [[nodiscard]] nlohmann::ordered_json save() const override;
  void load(const nlohmann::ordered_json& saved) override;

 private:
  RunPlan plan_;
  bool force_step_;
  std::int64_t done_ = 0;
};

}  // namespace packbed::column
