// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column/protocol/settle.hpp"
#include "column/protocol/stage.hpp"

namespace packbed::column {

/// The step "settle" as a stage; an output is due after each `interval` [s] of simulated time.
class SettleStage : public Stage {
 public:
  SettleStage(SettleOptions options, double interval);

  [[nodiscard]] std::string_view name() const override { return "settle"; }
  void begin(dem::Dem& dem) override;
  After advance(dem::Dem& dem) override;
  [[nodiscard]] double share_done(const dem::Dem& dem) const override;
  [[nodiscard]] std::string doing() const override;
  [[nodiscard]] std::string result(const dem::Dem& dem) const override;
  [[nodiscard]] nlohmann::ordered_json save() const override;
  void load(const nlohmann::ordered_json& saved) override;

 private:
  Settle settle_;
  double interval_;
  double next_output_ = 0.0;  ///< [s]
};

}  // namespace packbed::column
