// SPDX-License-Identifier: BSD-3-Clause
#include "column/protocol/settle_stage.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "column/protocol/settled_porosity.hpp"

namespace packbed::column {
namespace {

/// Names and values of the state, in one place for both directions.
template <class State, class Visit>
void visit(State& s, Visit value) {
  value("falls", s.falls);
  value("count_changes", s.count_changes);
  value("corrections", s.corrections);
  value("slices", s.slices);
  value("phase_slices", s.phase_slices);
  value("phase_start", s.phase_start);
  value("wetting_time", s.wetting_time);
  value("next_id", s.next_id);
  value("friction", s.friction);
  value("looseness", s.looseness);
  value("aim", s.aim);
  value("sag", s.sag);
  value("stopped_at", s.stopped_at);
  value("bed_height", s.bed_height);
  value("porosity", s.porosity);
  value("unbalanced", s.unbalanced);
  value("coordination", s.coordination);
  value("speed", s.speed);
  value("resting_since", s.resting_since);
  value("pushes", s.pushes);
  value("max_overlap", s.max_overlap);
  value("height_before", s.height_before);
  value("porosity_before", s.porosity_before);
}

SettleState state_from(const nlohmann::ordered_json& saved) {
  SettleState state;
  state.phase = static_cast<SettlePhase>(saved.at("phase").get<int>());
  visit(state, [&](const char* key, auto& value) { saved.at(key).get_to(value); });
  return state;
}

/// How the porosity was met, and what a bed would have that had settled to it by itself.
std::string way_to_porosity(const SettleState& s, const SettleOptions& options) {
  return fmt::format(
      "; porosity met {}, after {} settling{} of the whole bed; a bed that settles to it by "
      "itself, away from walls, "
      "has {:.2f} contacts per grain",
      s.looseness < 1.0 ? "by less friction in place" : "as it settled", s.falls,
      s.falls == 1 ? "" : "s", settled_coordination(s.porosity, options.resin_rolling_friction));
}

}  // namespace

SettleStage::SettleStage(SettleOptions options, double interval)
    : settle_(std::move(options)), interval_(interval) {}

void SettleStage::begin(dem::Dem& dem) {
  SettleState start;
  start.next_id = dem.bead_count();
  settle_ = Settle(settle_.options(), start);
  next_output_ = dem.time() + interval_;
}

After SettleStage::advance(dem::Dem& dem) {
  if (!settle_.advance(dem)) return After::end;
  return output_is_due(dem.time(), interval_, next_output_) ? After::output : After::goes_on;
}

// By phases: nobody knows beforehand how long a bed takes.
double SettleStage::share_done(const dem::Dem& /*dem*/) const {
  switch (settle_.state().phase) {
    case SettlePhase::start:
      return 0.0;
    case SettlePhase::fall:
      return std::min(0.5, 0.002 * static_cast<double>(settle_.state().phase_slices));
    case SettlePhase::rest:
    case SettlePhase::densify:
      return 0.6;
    case SettlePhase::submerge:
      return 0.85;
    case SettlePhase::done:
      return 1.0;
  }
  return 1.0;
}

std::string SettleStage::doing() const { return column::name(settle_.state().phase); }

std::string SettleStage::result(const dem::Dem& dem) const {
  const auto& s = settle_.state();
  auto text = fmt::format(
      "{} beads, height {:.4f} mm, porosity {:.4f} of the middle half, coordination number {:.3f}, "
      "unbalanced / contact force {:.2g}, settled at friction {:.4g}, {} changes of the number of "
      "beads",
      dem.bead_count(), 1e3 * s.bed_height, s.porosity, s.coordination, s.unbalanced, s.friction,
      s.count_changes);
  if (settle_.options().porosity) text += way_to_porosity(s, settle_.options());
  if (s.pushes > 0) text += fmt::format("; {} pushes of grains that tipped over", s.pushes);
  if (s.speed > settle_.options().speed_limit) {
    text += fmt::format("; one grain still moves, at {:.2g} m/s", s.speed);
  }
  return text;
}

nlohmann::ordered_json SettleStage::save() const {
  nlohmann::ordered_json saved = {{"next_output", next_output_},
                                  {"phase", static_cast<int>(settle_.state().phase)}};
  visit(settle_.state(), [&](const char* key, const auto& value) { saved[key] = value; });
  return saved;
}

void SettleStage::load(const nlohmann::ordered_json& saved) {
  next_output_ = saved.at("next_output");
  settle_ = Settle(settle_.options(), state_from(saved));
}

}  // namespace packbed::column
