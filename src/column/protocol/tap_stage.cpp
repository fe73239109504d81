// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/tap_stage.hpp"

#include <fmt/format.h>

namespace packbed::column {
namespace {

/// Names and values of the state, in one place for both directions.
template <class State, class Visit>
void visit(State& s, Visit value) {
  value("taps", s.taps);
  value("pieces", s.pieces);
  value("rest_slices", s.rest_slices);
  value("resting", s.resting);
  value("done", s.done);
  value("mean_diameter", s.mean_diameter);
  value("bed_height", s.bed_height);
  value("height_before", s.height_before);
  value("porosity", s.porosity);
  value("unbalanced", s.unbalanced);
  value("coordination", s.coordination);
}

}  // namespace

TapStage::TapStage(const TapOptions& options, double interval)
    : options_(options), tap_(options), interval_(interval) {}

void TapStage::begin(dem::Dem& dem) { next_output_ = dem.time() + interval_; }

After TapStage::advance(dem::Dem& dem) {
  if (!tap_.advance(dem)) return After::end;
  return output_is_due(dem.time(), interval_, next_output_) ? After::output : After::goes_on;
}

double TapStage::share_done(const dem::Dem& /*dem*/) const {
  const auto& s = tap_.state();
  if (s.done != 0) return 1.0;
  return static_cast<double>(s.taps) / static_cast<double>(options_.count + 1);
}

std::string TapStage::doing() const {
  return fmt::format("{} of {}", tap_.state().taps, options_.count);
}

std::string TapStage::result(const dem::Dem& /*dem*/) const {
  const auto& s = tap_.state();
  return fmt::format(
      "{} taps of {:.3g} times gravity, height {:.4f} mm, porosity {:.4f} of the middle half, "
      "coordination number {:.3f}, unbalanced / contact force {:.2g}",
      s.taps, tap_strength(options_), 1e3 * s.bed_height, s.porosity, s.coordination, s.unbalanced);
}

nlohmann::ordered_json TapStage::save() const {
  nlohmann::ordered_json saved = {{"next_output", next_output_}};
  visit(tap_.state(), [&](const char* key, const auto& value) { saved[key] = value; });
  return saved;
}

void TapStage::load(const nlohmann::ordered_json& saved) {
  next_output_ = saved.at("next_output");
  TapState state;
  visit(state, [&](const char* key, auto& value) { saved.at(key).get_to(value); });
  tap_ = Tap(options_, state);
}

}  // namespace packbed::column
