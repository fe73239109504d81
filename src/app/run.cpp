// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "app/analyze.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/report.hpp"
#include "app/run_folder.hpp"
#include "app/simulate.hpp"
#include "app/stages.hpp"
#include "app/start_ranks.hpp"
#include "column/plunger.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/ranks.hpp"
#include "core/version.hpp"
#include "setup/case_report.hpp"
#include "setup/read_case.hpp"

namespace packbed::app {
namespace {

void add_results(nlohmann::ordered_json& summary, const RunSummary& r) {
  const auto& f = r.figures;
  summary["simulated_time_s"] = r.simulated_time;
  summary["bead_steps"] = r.steps;
  summary["bead_step_s"] = r.step;
  summary["beads"] = r.beads;
  summary["inertia_scale"] = r.inertia_scale;
  summary["ranks"] = Ranks::all().size();
  summary["renewals"] = r.renewals;
  summary["kinetic_to_elastic"] = f.kinetic_to_elastic;
  summary["unbalanced_force"] = f.unbalanced_force;
  summary["max_overlap_ratio"] = f.max_overlap_ratio;
  summary["coordination_number"] = f.coordination_number;
  if (f.bed.height > 0.0) {
    summary["bed_height_m"] = f.bed.height;
    summary["mean_porosity"] = f.bed.mean_porosity;
    summary["middle_porosity"] = f.bed.middle_porosity;
    summary["budget_error"] = f.budget_error;
  }
  if (f.settled_height > 0.0) {
    summary["settled_height_m"] = f.settled_height;
    summary["settled_porosity"] = f.settled_porosity;
  }
  if (r.has_flow && f.highest_flow.bed_height > 0.0) {  // a plunger alone has none
    summary["highest_superficial_velocity_m_s"] = f.highest_flow.velocity;
    summary["pressure_drop_at_highest_flow_Pa"] = f.highest_flow.pressure_drop;
    summary["bed_height_at_highest_flow_m"] = f.highest_flow.bed_height;
  }
  if (r.has_plunger && f.plunger.position < column::lid_away) {
    summary["plunger_position_m"] = f.plunger.position;
    summary["plunger_force_N"] = f.plunger.force;
  }
  summary["warnings"] = r.warnings;
  summary["timings"] = to_json(r.timings);
  summary["wall_time_s"] = r.wall_time;
}

void tell_results(const RunSummary& r) {
  const auto& f = r.figures;
  if (f.bed.height > 0.0) {
    fmt::print(
        "Bed of {} grains: {:.3f} mm high, porosity {:.4f} (middle half), {:.2f} contacts per "
        "grain, unbalanced / contact force {:.1e}\n",
        r.beads, 1e3 * f.bed.height, f.bed.middle_porosity, f.coordination_number,
        f.unbalanced_force);
  }
  if (f.highest_flow.bed_height > 0.0) {
    fmt::print(
        "Highest flow {:.4g} cm/h: pressure drop {:.4g} bar, {:.4g} bar/m of a bed of {:.3f} mm\n",
        f.highest_flow.velocity * 3.6e5, 1e-5 * f.highest_flow.pressure_drop,
        1e-5 * f.highest_flow.pressure_drop / f.highest_flow.bed_height,
        1e3 * f.highest_flow.bed_height);
  }
  for (const auto& warning : r.warnings) fmt::print("Warning: {}\n", warning);
  fmt::print("{:.4g} s simulated in {} steps, {:.3g} s of wall time\n", r.simulated_time, r.steps,
             r.wall_time);
}

void tell_files(const setup::Case& c, const std::filesystem::path& folder) {
  std::string files = "series.csv";
  for (const auto* name : {"sections.csv", "plateaus.csv", "profiles", "frames", "analysis"}) {
    if (std::filesystem::exists(folder / name)) files += fmt::format(", {}", name);
  }
  if (c.protocol.empty()) fmt::print("The protocol has no steps: the start was written.\n");
  fmt::print("Written in {}: {}, checkpoints, summary.json, case.toml, run.log, {}report.html\n",
             folder.string(), files, c.output.measured ? "measured.csv, " : "");
}

/// The measured points go with the results: the report of the run can be made again anywhere.
void write_measured(const setup::Case& c, const std::filesystem::path& folder) {
  if (!c.output.measured) return;
  write_text_file(folder / "measured.csv", setup::to_csv(c.output.measured_points));
}

/// The run has ended well, whatever becomes of its analysis.
void analyze_frames_of(const setup::Case& c,
                       const std::filesystem::path& folder,
                       const UnitSystem& units) {
  if (!c.output.analysis) return;
  try {
    analyze_ended_run(folder, units);
  } catch (const Error& error) {
    fmt::print(stderr, "packbed: the frames were not analyzed: {}\n", error.what());
  }
}

void tell_prepared(const setup::Case& c, const std::filesystem::path& folder, int ranks_asked) {
  if (ranks_asked > 1) {
    fmt::print("-n {} has no effect on a case that is only prepared.\n", ranks_asked);
  }
  fmt::print(
      "NOT SIMULATED: the case has no beads, so none of its {} steps was carried out.\n"
      "Written: {}/case.toml (every value filled in), {}/summary.json\n",
      c.protocol.size(), folder.string(), folder.string());
}

/// Whether results of a run that ended are there.
bool has_ended(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "summary.json");
}

/// Whether a run was killed after its results were complete and before they were analyzed and shown.
bool lacks_its_report(const std::filesystem::path& folder) {
  return has_ended(folder) && !std::filesystem::exists(folder / "report.html");
}

int write_what_is_missing(const setup::Case& c,
                          const std::filesystem::path& folder,
                          const UnitSystem& units) {
  if (!Ranks::all().is_first()) return 0;
  const FolderLock lock(folder);
  write_measured(c, folder);
  analyze_frames_of(c, folder, units);
  fmt::print("This run had ended without its report.\nReport: {}\n",
             write_report(folder, units).string());
  return 0;
}

void prepare_folder(const RunCommand& command,
                    const setup::Case& c,
                    const std::filesystem::path& folder) {
  if (command.resume) {
    if (!has_ended(folder)) return;
    throw ConfigError(fmt::format(
        "{}: this run has ended, there is nothing to resume; start it anew with --overwrite",
        folder.string()));
  }
  std::vector<std::filesystem::path> inputs = {command.file};
  if (c.beads.csv) inputs.push_back(*c.beads.csv);
  if (c.output.measured) inputs.push_back(*c.output.measured);
  make_run_folder(folder, command.overwrite, inputs);
}

}  // namespace

int run(const RunCommand& command) {
  const UnitSystem units;
  const auto c = setup::read_case(command.file, units);
  const auto f = setup::figures(c);
  const std::filesystem::path folder =
      command.directory.empty() ? c.output.directory : command.directory;
  const bool carried_out = can_simulate(c);
  if (command.resume && carried_out && lacks_its_report(folder)) {
    return write_what_is_missing(c, folder, units);
  }
  if (carried_out && !MpiSession::is_started()) {
    const int ranks = command.ranks > 0 ? command.ranks : useful_ranks(f.bead_count);
    if (ranks > 1) {
      {
        std::optional<FolderLock> lock;  // until the ranks take it
        if (std::filesystem::is_directory(folder)) lock.emplace(folder);
        prepare_folder(command, c, folder);
      }
      return run_on_ranks(ranks, command);
    }
  }
  const bool writes = Ranks::all().is_first();
  std::optional<FolderLock> lock;
  if (writes) {
    if (std::filesystem::is_directory(folder)) lock.emplace(folder);
    prepare_folder(command, c, folder);
    if (!lock) lock.emplace(folder);
    if (!command.resume) write_text_file(folder / "case.toml", setup::check_text(c, f));
  }
  nlohmann::ordered_json summary{{"program", "packbed"},
                                 {"version", version},
                                 {"case", std::filesystem::absolute(c.file).string()},
                                 {"title", c.title}};
  RunSummary results;
  if (carried_out) {
    results = simulate(c, folder, command.resume);
    add_results(summary, results);
  }
  if (!writes) return 0;
  summary["steps_carried_out"] = carried_out ? c.protocol.size() : 0;
  summary["steps_in_case"] = c.protocol.size();
  summary["figures"] = setup::figures_json(c, f);
  write_text_file(folder / "summary.json", json_text(summary));
  write_measured(c, folder);
  if (carried_out) analyze_frames_of(c, folder, units);
  if (command.json) {
    fmt::print("{}", json_text(summary));
    write_report(folder, units);
    return 0;
  }
  fmt::print("{}: {:.0f} grains, {} protocol step{}\n", c.title, f.bead_count, c.protocol.size(),
             c.protocol.size() == 1 ? "" : "s");
  if (carried_out) {
    tell_results(results);
    tell_files(c, folder);
  } else {
    tell_prepared(c, folder, command.ranks);
  }
  fmt::print("Report: {}\n", write_report(folder, units).string());
  return 0;
}

}  // namespace packbed::app
