// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_checkpoint.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "app/liquid_file.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "io/dem_state_file.hpp"
#include "setup/make_dem.hpp"

namespace packbed::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// May differ between a run and its continuation: they change no result.
const std::set<std::string> free_keys = {"title", "output.directory", "output.checkpoint_interval",
                                         "output.measured"};

Json identity_of(const setup::Case& c) {
  Json values = Json::array();
  for (const auto& v : setup::flat_values(c.echo)) {
    if (!free_keys.contains(v.key)) values.push_back({v.key, v.value});
  }
  return values;
}

/// The first key whose value differs, in words; empty if none does.
std::string difference(const Json& saved, const Json& now) {
  std::map<std::string, std::string> before;
  for (const auto& v : saved) before[v[0]] = v[1];
  for (const auto& v : now) {
    const std::string key = v[0];
    const std::string value = v[1];
    const auto found = before.find(key);
    if (found == before.end()) return fmt::format("{} = {} is new", key, value);
    if (found->second != value) {
      return fmt::format("{} was {}, and is {} now", key, found->second, value);
    }
    before.erase(found);
  }
  if (!before.empty()) {
    return fmt::format("{} = {} is gone", before.begin()->first, before.begin()->second);
  }
  return {};
}

fs::path folder_of_checkpoints(const fs::path& folder) { return folder / "checkpoints"; }

void check_origin(const Json& run, const setup::Case& c, const fs::path& file) {
  if (run.at("version") != version) {
    throw ConfigError(
        fmt::format("{}: was written by packbed {}, this is packbed {}; resume with that version, "
                    "or start anew "
                    "with --overwrite",
                    file.string(), run.at("version").get<std::string>(), version));
  }
  const auto what = difference(run.at("case"), identity_of(c));
  if (what.empty()) return;
  throw ConfigError(
      fmt::format("{}: belongs to another case: {}; put it back, or start anew with --overwrite",
                  file.string(), what));
}

}  // namespace

fs::path write_checkpoint(const setup::Case& c,
                          const fs::path& folder,
                          const dem::Dem& dem,
                          const column::CoupledBed* liquid,
                          const RunState& state,
                          int keep) {
  const auto place = folder_of_checkpoints(folder);
  io::CheckpointWriter writer(place, dem.steps(), dem.ranks());
  const Json run = {{"version", version},       {"case", identity_of(c)},
                    {"stage", state.stage},     {"stage_state", state.stage_state},
                    {"outputs", state.outputs}, {"warnings", state.warnings}};
  writer.text("run", run.dump(-1, ' ', false, Json::error_handler_t::replace));
  io::write_dem_state(writer, dem.state());
  if (liquid != nullptr) write_fluid_state(writer, liquid->save());
  const auto file = writer.commit();
  if (dem.ranks().is_first()) io::prune_checkpoints(place, static_cast<std::size_t>(keep));
  return file;
}

LoadedCheckpoint read_checkpoint(const setup::Case& c, const fs::path& folder) {
  const auto place = folder_of_checkpoints(folder);
  const auto file = io::latest_checkpoint(place);
  if (!file) {
    throw ConfigError(fmt::format("{}: there is no checkpoint to resume from; start the run anew",
                                  place.string()));
  }
  const io::CheckpointReader reader(*file, Ranks::all());
  const auto run = Json::parse(reader.text("run"));
  check_origin(run, c, *file);
  return {
      .file = *file,
      .beads = io::read_dem_state(reader, setup::make_walls(c)),
      .liquid = has_fluid_state(reader) ? std::optional(read_fluid_state(reader)) : std::nullopt,
      .state = {.stage = run.at("stage"),
                .stage_state = run.at("stage_state"),
                .outputs = run.at("outputs"),
                .warnings = run.at("warnings").get<std::vector<std::string>>()}};
}

}  // namespace packbed::app
