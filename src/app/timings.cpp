// SPDX-License-Identifier: BSD-3-Clause
#include "app/timings.hpp"

#include <utility>

#include <fmt/format.h>

#include "app/print.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;

/// Names and values, in one place for both directions.
template <class Timings, class Visit>
void visit(Timings& t, Visit value) {
  value("stage", t.stage);
  value("name", t.name);
  value("beads_s", t.beads);
  value("coupling_s", t.coupling);
  value("liquid_s", t.liquid);
  value("outputs_s", t.outputs);
  value("wall_s", t.wall);
}

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "checkpoints" / "timings.json";
}

}  // namespace

StageClock::StageClock(StageTimings before, const column::CoupledBed* liquid)
    : before_(std::move(before)), liquid_(liquid) {
  if (liquid == nullptr) return;
  coupling_start_ = liquid->coupling_seconds();
  liquid_start_ = liquid->liquid_seconds();
}

StageTimings StageClock::now() const {
  auto t = before_;
  const double coupling = liquid_ ? liquid_->coupling_seconds() - coupling_start_ : 0.0;
  const double liquid = liquid_ ? liquid_->liquid_seconds() - liquid_start_ : 0.0;
  t.beads += advance.seconds() - coupling - liquid;
  t.coupling += coupling;
  t.liquid += liquid;
  t.outputs += outputs.seconds();
  t.wall += seconds_since(start_);
  return t;
}

std::string in_words(const StageTimings& t) {
  return fmt::format(
      "stage {} took {:.1f} s: beads {:.1f}, coupling {:.1f}, liquid {:.1f}, outputs {:.1f}",
      t.stage, t.wall, t.beads, t.coupling, t.liquid, t.outputs);
}

Json to_json(const std::vector<StageTimings>& timings) {
  Json all = Json::array();
  for (const auto& t : timings) {
    auto& entry = all.emplace_back();
    visit(t, [&](const char* key, const auto& value) { entry[key] = value; });
  }
  return all;
}

void write_timings(const std::filesystem::path& folder, const std::vector<StageTimings>& timings) {
  write_text_file(file_in(folder), json_text(to_json(timings)));
}

std::vector<StageTimings> read_timings(const std::filesystem::path& folder) {
  const auto file = file_in(folder);
  std::vector<StageTimings> timings;
  if (Ranks::all().is_first())
    std::filesystem::remove(file.string() + ".part");  // of a run that was killed
  if (!std::filesystem::exists(file)) return timings;
  try {
    for (const auto& entry : Json::parse(read_text_file(file))) {
      visit(timings.emplace_back(),
            [&](const char* key, auto& value) { entry.at(key).get_to(value); });
    }
  } catch (const nlohmann::json::exception& error) {
    throw DataError(fmt::format(
        "{}: it is no list of wall times ({}); take it away and the run goes on without them",
        file.string(), error.what()));
  }
  return timings;
}

StageTimings& entry_of(std::vector<StageTimings>& timings,
                       std::int64_t stage,
                       std::string_view name) {
  while (!timings.empty() && timings.back().stage > stage) timings.pop_back();
  if (timings.empty() || timings.back().stage < stage) {
    timings.push_back({.stage = stage, .name = std::string(name)});
  }
  return timings.back();
}

}  // namespace packbed::app
