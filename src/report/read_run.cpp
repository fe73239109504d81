// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "report/html.hpp"
#include "report/run_data.hpp"
#include "setup/parse_toml.hpp"

namespace packbed::report {
namespace {

namespace fs = std::filesystem;

void check_folder(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_directory(folder, none)) {
    throw DataError(fmt::format(
        "{}: there is no such folder; name the folder of a run, such as runs/quickstart",
        folder.string()));
  }
  if (fs::exists(folder / "summary.json", none)) return;
  if (!fs::exists(folder / "case.toml", none)) {
    throw DataError(fmt::format("{}: there is no run in this folder (summary.json is missing)",
                                folder.string()));
  }
  throw DataError(
      fmt::format("{}: this run has not ended (summary.json is missing); wait for it, or go on "
                  "with `packbed run CASE --resume`",
                  folder.string()));
}

Json read_summary(const fs::path& file) {
  try {
    auto summary = Json::parse(read_text_file(file));
    if (summary.is_object()) return summary;
  } catch (const Json::exception&) {
    // as below
  }
  throw DataError(fmt::format("{}: it is not a summary of packbed; it is damaged", file.string()));
}

Json case_values(const std::string& text, const fs::path& file) {
  std::ostringstream json;
  json << toml::json_formatter{setup::parse_toml(text, file)};
  return Json::parse(json.str());
}

void add_stages(const Json& steps, std::vector<std::string>& stages) {
  for (const auto& step : steps) {
    const auto kind = step.value("step", std::string("?"));
    // A file that was tampered with must not fill the memory.
    const auto turns = std::min(step.value("count", 1), 100'000);
    if (kind == "cycle") {
      for (int turn = 0; turn < turns; ++turn)
        stages.insert(stages.end(), {"cycle high", "cycle low"});
      continue;
    }
    if (kind != "repeat") {
      stages.insert(stages.end(), kind == "flow_pack" ? 3 : 1, kind);
      continue;
    }
    for (int turn = 0; turn < turns; ++turn) add_stages(step.value("steps", Json::array()), stages);
  }
}

/// The names that the run gave its stages, where the summary tells them: they know what a step of the case became.
void take_names_of(const Json& summary, std::vector<std::string>& stages) {
  const auto found = summary.find("timings");
  if (found == summary.end() || !found->is_array()) return;
  for (const auto& t : *found) {
    const auto stage = t.value("stage", std::int64_t{0});
    const auto name = t.value("name", std::string());
    if (stage < 1 || stage > 100'000 || name.empty()) continue;
    if (stages.size() < static_cast<std::size_t>(stage))
      stages.resize(static_cast<std::size_t>(stage), "?");
    stages[static_cast<std::size_t>(stage - 1)] = name;
  }
}

/// "z_000012.csv" is number 12 of "z_".
std::optional<int> number_of(const fs::path& file, std::string_view begin) {
  const auto name = file.stem().string();
  if (file.extension() != ".csv" || !name.starts_with(begin)) return std::nullopt;
  const auto digits = std::string_view(name).substr(begin.size());
  if (digits.empty() || digits.size() > 9) return std::nullopt;
  int number = 0;
  for (const char c : digits) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return number;
}

std::vector<Profile> read_tables(const fs::path& folder, std::string_view begin) {
  std::vector<Profile> profiles;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const auto number = number_of(entry.path(), begin);
    if (number) profiles.push_back({.number = *number, .table = Columns(entry.path())});
  }
  std::ranges::sort(profiles, {}, &Profile::number);
  return profiles;
}

std::vector<Plateau> read_plateaus(const fs::path& file) {
  const Columns table(file);
  std::vector<Plateau> plateaus;
  const bool has_frits = table.has("frit_pressure_drop_Pa");  // runs of before had none
  for (std::size_t i = 0; i < table.rows(); ++i) {
    plateaus.push_back(
        {.stage = static_cast<int>(table["stage"][i]),
         .time = table["end_time_s"][i],
         .velocity = table["superficial_velocity_m_s"][i],
         .pressure_drop = table["pressure_drop_Pa"][i],
         .frit_pressure_drop = has_frits ? table["frit_pressure_drop_Pa"][i] : unknown,
         .pressure_gradient = table["pressure_drop_per_height_Pa_m"][i],
         .bed_height = table["bed_height_m"][i],
         .compression = table["compression"][i],
         .pressure_noise = table["pressure_noise"][i],
         .steady = table["steady"][i] != 0.0});
  }
  return plateaus;
}

RunData read_files(const fs::path& folder, const UnitSystem& units) {
  RunData run;
  run.folder = folder;
  run.summary = read_summary(folder / "summary.json");
  run.case_text = valid_utf8(read_text_file(folder / "case.toml"));
  run.values = case_values(run.case_text, folder / "case.toml");
  run.label = run.title();
  add_stages(run.values.value("protocol", Json::array()), run.stages);
  take_names_of(run.summary, run.stages);
  const bool was_simulated = run.summary.contains("simulated_time_s");
  if (!was_simulated) return run;
  run.series = Columns(folder / "series.csv");
  if (fs::exists(folder / "sections.csv")) run.sections = Columns(folder / "sections.csv");
  run.plateaus = fs::exists(folder / "plateaus.csv") ? read_plateaus(folder / "plateaus.csv")
                                                     : plateaus_of_series(run.series);
  run.porosity_z = read_tables(folder / "profiles", "z_");
  run.porosity_wall = read_tables(folder / "profiles", "wall_distance_");
  run.plateau_z = read_tables(folder / "profiles", "plateau_z_");
  for (const auto* axis : {"x", "radius"}) {
    auto profiles = read_tables(folder / "profiles", fmt::format("plateau_{}_", axis));
    if (profiles.empty()) continue;
    run.plateau_across = std::move(profiles);
    run.across = axis;
  }
  if (fs::exists(folder / "measured.csv")) {
    run.measured = setup::read_measured(folder / "measured.csv", units);
  }
  return run;
}

void add_analysis(RunData& run) {
  const auto folder = run.folder / "analysis";
  if (!fs::exists(folder / "analysis.csv")) return;
  run.analysis = Columns(folder / "analysis.csv", "stage_name");
  run.forces = read_tables(folder, "forces_");
  run.angles = read_tables(folder, "angles_");
  run.stress = read_tables(folder, "stress_");
  run.wall_velocity = read_tables(folder, "wall_velocity_");
}

}  // namespace

RunData read_run(const fs::path& folder, const UnitSystem& units) {
  auto run = read_results(folder, units);
  add_analysis(run);
  return run;
}

RunData read_results(const fs::path& folder, const UnitSystem& units) {
  check_folder(folder);
  try {
    return read_files(folder, units);
  } catch (const Json::exception& error) {
    throw DataError(fmt::format("{}: case.toml or summary.json is not as packbed wrote it ({})",
                                folder.string(), error.what()));
  }
}

}  // namespace packbed::report
