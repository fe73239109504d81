// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "report/case_words.hpp"
#include "report/words.hpp"

namespace packbed::report {
namespace {

std::string settle_text(const Json& step, const UnitSystem& units) {
  std::string words = "Settle";
  if (step.contains("bed_height")) {
    words += fmt::format(" to a bed of {}", length(text(step, "/bed_height"), units));
  }
  if (step.contains("porosity")) words += ", porosity " + text(step, "/porosity");
  if (step.contains("friction")) words += ", friction while settling " + text(step, "/friction");
  return words;
}

std::string ramp_text(const Json& step, const UnitSystem& units) {
  const auto steps = step.value("steps", 1);
  auto words = fmt::format("Flow from {} to {} in {} step{}, ", flow(text(step, "/from"), units),
                           flow(text(step, "/to"), units), steps, steps == 1 ? "" : "s");
  const auto hold = text(step, "/hold");
  words += hold == "until steady"
               ? fmt::format("each held until steady, {} at most", text(step, "/hold_limit"))
               : fmt::format("each held {}", hold);
  return words + (text(step, "/change") == "jump" ? ", changed at once" : "");
}

/// "for 0.1 s", or "until steady, 5 s at most".
std::string held(const Json& step, const char* key) {
  const auto words = text(step, key);
  return words == "until steady" ? fmt::format("{}, {} at most", words, text(step, "/hold_limit"))
                                 : "for " + words;
}

/// Where the plunger stops; empty where the step does not say.
std::string goal_text(const Json& step, const UnitSystem& units) {
  std::string words;
  for (const auto* goal :
       {"height", "compression", "compression_factor", "packing_factor", "force", "pressure"}) {
    if (!step.contains(goal)) continue;
    auto value = text(step, fmt::format("/{}", goal).c_str());
    if (std::string_view(goal) == "height") value = length(value, units);
    words += fmt::format(" to a {} of {}", goal, value);
  }
  return words;
}

std::string plunger_text(const Json& step, const UnitSystem& units, std::string words) {
  words += fmt::format(" at {}{}", text(step, "/speed"), goal_text(step, units));
  const auto is_set = [&](const char* key) { return step.value(key, false); };
  if (is_set("withdraw")) words += ", then out of the way";
  if (is_set("drained")) words += ", drained";
  if (const auto friction = text(step, "/friction"); !friction.empty()) {
    words += ", friction " + friction;
  }
  if (const auto through = text(step, "/flow"); !through.empty() && !through.starts_with("0 ")) {
    words += ", in a flow of " + flow(through, units);
  }
  return words;
}

std::string pack_text(const Json& step, const UnitSystem& units) {
  const auto steps = text(step, "/steps");
  auto words = fmt::format("Pack in a flow of {}, reached in {} step{}, each held {}",
                           flow(text(step, "/flow"), units), steps, steps == "1" ? "" : "s",
                           held(step, "/hold"));
  if (step.contains("compression")) {
    words += fmt::format(", to a compression of {}", text(step, "/compression"));
  }
  return words + fmt::format("; then the plunger is set down at {}", text(step, "/plunger_speed"));
}

std::string cycle_text(const Json& step, const UnitSystem& units) {
  return fmt::format("Cycle {} times: {} {}, {} {}", text(step, "/count"),
                     flow(text(step, "/high"), units), held(step, "/high_duration"),
                     flow(text(step, "/low"), units), held(step, "/low_duration"));
}

std::string step_text(const Json& step, const UnitSystem& units) {
  const auto kind = text(step, "/step");
  if (kind == "settle") return settle_text(step, units);
  if (kind == "flow_ramp") return ramp_text(step, units);
  if (kind == "compress") return plunger_text(step, units, "Plunger down");
  if (kind == "relax") return plunger_text(step, units, "Plunger up");
  if (kind == "flow_pack") return pack_text(step, units);
  if (kind == "cycle") return cycle_text(step, units);
  if (kind == "store") {
    return fmt::format("Store without a flow until steady, {} at most", text(step, "/hold_limit"));
  }
  if (kind == "run") return fmt::format("Run for {}", text(step, "/duration"));
  if (kind == "hold") {
    return fmt::format("Hold for {}{}", text(step, "/duration"),
                       step.contains("flow") ? " at " + flow(text(step, "/flow"), units) : "");
  }
  if (kind == "tap") {
    const auto count = text(step, "/count");
    return fmt::format("Tap {} time{}: {} at {}", count, count == "1" ? "" : "s",
                       length(text(step, "/amplitude"), units), text(step, "/frequency"));
  }
  if (kind == "repeat") return fmt::format("Repeat {} times:", text(step, "/count"));
  std::string words = kind;  // a step younger than this page
  for (const auto& [key, value] : step.items()) {
    if (key != "step") words += fmt::format(", {} {}", key, value.dump());
  }
  return words;
}

std::vector<Sentence> sentences(const Json& steps, const UnitSystem& units) {
  std::vector<Sentence> all;
  for (const auto& step : steps) {
    all.push_back({.text = step_text(step, units)});
    if (step.value("step", "") == "repeat") all.back().parts = sentences(step.at("steps"), units);
  }
  return all;
}

}  // namespace

std::vector<Sentence> protocol_sentences(const RunData& run, const UnitSystem& units) {
  return sentences(run.values.value("protocol", Json::array()), units);
}

}  // namespace packbed::report
