// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/run_folder.hpp"
#include "app/simulate.hpp"
#include "app/stages.hpp"
#include "app/start_ranks.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/ranks.hpp"
#include "core/version.hpp"
#include "setup/case_report.hpp"
#include "setup/read_case.hpp"

namespace packbed::app {
namespace {

void add_results(nlohmann::ordered_json& summary, const RunSummary& r) {
  summary["simulated_time_s"] = r.simulated_time;
  summary["bead_steps"] = r.steps;
  summary["bead_step_s"] = r.step;
  summary["beads"] = r.beads;
  summary["inertia_scale"] = r.inertia_scale;
  summary["ranks"] = Ranks::all().size();
  summary["renewals"] = r.renewals;
  summary["kinetic_to_elastic"] = r.figures.kinetic_to_elastic;
  summary["unbalanced_force"] = r.figures.unbalanced_force;
  summary["max_overlap_ratio"] = r.figures.max_overlap_ratio;
  summary["coordination_number"] = r.figures.coordination_number;
  summary["wall_time_s"] = r.wall_time;
}

void report(const setup::Case& c,
            const setup::CaseFigures& f,
            const std::filesystem::path& folder,
            bool carried_out,
            int ranks_asked) {
  fmt::print("{}: {:.0f} grains, {} protocol step{}\n", c.title, f.bead_count, c.protocol.size(),
             c.protocol.size() == 1 ? "" : "s");
  if (carried_out) {
    if (c.protocol.empty()) fmt::print("The protocol has no steps: the start was written.\n");
    fmt::print("Written: {0}/series.csv, {0}/summary.json, {0}/case.toml, {0}/run.log{1}\n",
               folder.string(),
               c.output.beads_csv ? fmt::format(", {}/frames", folder.string()) : "");
    return;
  }
  if (ranks_asked > 1)
    fmt::print("-n {} has no effect on a case that is only prepared.\n", ranks_asked);
  fmt::print(
      "NOT SIMULATED: packbed {} carries out the step \"run\" with beads from a file ([beads] "
      "csv). "
      "Settling, flow and the plunger are not there yet, so none of the {} steps was carried out.\n"
      "Written: {}/case.toml (every value filled in), {}/summary.json\n",
      version, c.protocol.size(), folder.string(), folder.string());
}

}  // namespace

namespace {

/// Whether results of a run that ended are there.
bool has_ended(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "summary.json");
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
  if (carried_out && !MpiSession::is_started()) {
    const int ranks = command.ranks > 0 ? command.ranks : useful_ranks(f.bead_count);
    if (ranks > 1) {
      prepare_folder(command, c, folder);
      return run_on_ranks(ranks, command);
    }
  }
  const bool writes = Ranks::all().is_first();
  if (writes) {
    prepare_folder(command, c, folder);
    if (!command.resume) write_text_file(folder / "case.toml", setup::check_text(c, f));
  }
  nlohmann::ordered_json summary{{"program", "packbed"},
                                 {"version", version},
                                 {"case", std::filesystem::absolute(c.file).string()},
                                 {"title", c.title}};
  if (carried_out) add_results(summary, simulate(c, folder, command.resume));
  if (!writes) return 0;
  summary["steps_carried_out"] = carried_out ? c.protocol.size() : 0;
  summary["steps_in_case"] = c.protocol.size();
  summary["figures"] = setup::figures_json(c, f);
  write_text_file(folder / "summary.json", json_text(summary));
  if (command.json) {
    fmt::print("{}", json_text(summary));
  } else {
    report(c, f, folder, carried_out, command.ranks);
  }
  return 0;
}

}  // namespace packbed::app
