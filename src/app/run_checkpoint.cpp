// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_checkpoint.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "app/liquid_file.hpp"
#include "column/plunger.hpp"
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
                                         "output.measured", "output.analysis"};

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

/// Keys that a bed has from the run that made it.
bool belongs_to_bed(std::string_view key) {
  for (const auto* other : {"column.mesh.", "column.wall.", "column.frit.", "column.full_load"}) {
    if (key.starts_with(other)) return false;
  }
  return key.starts_with("column.") || key.starts_with("resin.sizes.") ||
         key == "resin.coarse_grain";
}

Json only_of_bed(const Json& values) {
  Json some = Json::array();
  for (const auto& v : values) {
    if (belongs_to_bed(v[0].get<std::string>())) some.push_back(v);
  }
  return some;
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

RunState state_of(const Json& run) {
  return {.stage = run.at("stage"),
          .stage_state = run.at("stage_state"),
          .outputs = run.at("outputs"),
          .warnings = run.at("warnings").get<std::vector<std::string>>(),
          .bed = {.settled_height = run.at("settled_height"),
                  .height = run.at("height"),
                  .plunger = run.at("plunger")}};
}

}  // namespace

void as_this_build_writes(const fs::path& file, const std::function<void()>& read) {
  try {
    read();
  } catch (const Json::exception& error) {
    throw DataError(fmt::format(
        "{}: was written by another build of packbed {} ({}); use that build, or start that run "
        "anew with --overwrite",
        file.string(), version, error.what()));
  }
}

fs::path write_checkpoint(const setup::Case& c,
                          const fs::path& folder,
                          const dem::Dem& dem,
                          const column::CoupledBed* liquid,
                          const RunState& state,
                          int keep) {
  const auto place = folder_of_checkpoints(folder);
  io::CheckpointWriter writer(place, dem.steps(), dem.ranks());
  const Json run = {{"version", version},
                    {"case", identity_of(c)},
                    {"stage", state.stage},
                    {"stage_state", state.stage_state},
                    {"outputs", state.outputs},
                    {"warnings", state.warnings},
                    {"settled_height", state.bed.settled_height},
                    {"height", state.bed.height},
                    {"plunger", state.bed.plunger}};
  writer.text("run", run.dump(-1, ' ', false, Json::error_handler_t::replace));
  io::write_dem_state(writer, dem::in_order_of_ids(dem.state(), dem.ranks()));
  if (liquid != nullptr) write_fluid_state(writer, liquid->save());
  auto file = writer.commit();
  prune_checkpoints(folder, keep);
  return file;
}

TakenBed take_bed(const setup::Case& c, double step) {
  const auto place = folder_of_checkpoints(*c.beads.run);
  const auto file = io::latest_checkpoint(place);
  if (!file) {
    throw ConfigError(fmt::format(
        "{}: there is no checkpoint to take the bed from; run that case again", place.string()));
  }
  const io::CheckpointReader reader(*file, Ranks::all());
  const auto run = Json::parse(reader.text("run"));
  std::string what;
  as_this_build_writes(
      *file, [&] { what = difference(only_of_bed(run.at("case")), only_of_bed(identity_of(c))); });
  if (!what.empty()) {
    throw ConfigError(fmt::format(
        "{}: beads.run = \"{}\" has a bed that does not belong in this column: {}; make them equal",
        c.file.string(), c.beads.run->string(), what));
  }
  auto state = io::read_dem_state(reader, setup::make_walls(c));
  const auto options = setup::options_of(c, step);
  const auto before = state.progress;
  const auto plunger = column::plunger_position(state.walls);
  state.walls = setup::make_walls(c);
  state.progress = {.step = step,
                    .skin = before.skin,
                    .near_skin = before.near_skin,
                    .cell = before.cell,
                    .inertia_scale = options.inertia_scale,
                    .background_damping = options.background_damping,
                    .friction = options.model.friction,
                    .rolling_friction = c.resin.rolling_friction};
  for (auto& bead : state.beads) {
    const auto& old = bead.properties;
    const bool fixed = old.fixed;
    const dem::Material material{
        .youngs_modulus = c.resin.youngs_modulus.value_or(old.material.youngs_modulus),
        .poisson_ratio = c.resin.poisson_ratio.value_or(old.material.poisson_ratio)};
    bead.properties = setup::bead_properties(c, old.id, old.diameter,
                                             c.resin.density.value_or(old.density), material);
    bead.properties.fixed = fixed;
  }
  return {.file = *file,
          .beads = std::move(state),
          .plunger = plunger,
          .outputs = run.value("outputs", Json())};
}

void prune_checkpoints(const fs::path& folder, int keep) {
  if (!Ranks::all().is_first()) return;
  io::prune_checkpoints(folder_of_checkpoints(folder), static_cast<std::size_t>(keep));
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
  RunState state;
  as_this_build_writes(*file, [&] {
    check_origin(run, c, *file);
    state = state_of(run);
  });
  return {
      .file = *file,
      .beads = io::read_dem_state(reader, setup::make_walls(c)),
      .liquid = has_fluid_state(reader) ? std::optional(read_fluid_state(reader)) : std::nullopt,
      .state = std::move(state)};
}

}  // namespace packbed::app
