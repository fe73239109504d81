// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/simulate.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/version.hpp"
#include "setup/case_report.hpp"
#include "setup/read_case.hpp"

namespace packbed::app {
namespace {

void make_run_folder(const std::filesystem::path& folder, bool overwrite) {
  if (!overwrite && std::filesystem::exists(folder / "summary.json")) {
    throw ConfigError(
        fmt::format("{}: there are results of an earlier run; take another folder "
                    "with -o DIR, or replace them with --overwrite",
                    folder.string()));
  }
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw DataError(
        fmt::format("{}: the folder cannot be made ({})", folder.string(), failed.message()));
  }
}

void add_results(nlohmann::ordered_json& summary, const RunSummary& r) {
  summary["simulated_time_s"] = r.simulated_time;
  summary["bead_steps"] = r.steps;
  summary["bead_step_s"] = r.step;
  summary["renewals"] = r.renewals;
  summary["kinetic_to_elastic"] = r.kinetic_to_elastic;
  summary["unbalanced_force"] = r.unbalanced_force;
  summary["max_overlap_ratio"] = r.max_overlap_ratio;
  summary["coordination_number"] = r.coordination_number;
  summary["wall_time_s"] = r.wall_time;
}

void report(const setup::Case& c,
            const setup::CaseFigures& f,
            const std::filesystem::path& folder,
            bool carried_out) {
  fmt::print("{}: {:.0f} grains, {} protocol steps\n", c.title, f.bead_count, c.protocol.size());
  if (carried_out) {
    fmt::print("Written: {0}/series.csv, {0}/summary.json, {0}/case.toml{1}\n", folder.string(),
               c.output.beads_csv ? ", frames/" : "");
    return;
  }
  fmt::print(
      "NOT SIMULATED: packbed {} carries out the step \"run\" with beads from a file ([beads] "
      "csv). "
      "Settling, flow and the plunger are not there yet, so none of the {} steps was carried out.\n"
      "Written: {}/case.toml (every value filled in), {}/summary.json\n",
      version, c.protocol.size(), folder.string(), folder.string());
}

}  // namespace

int run(const RunCommand& command) {
  const UnitSystem units;
  const auto c = setup::read_case(command.file, units);
  const auto f = setup::figures(c);
  const std::filesystem::path folder =
      command.directory.empty() ? c.output.directory : command.directory;
  make_run_folder(folder, command.overwrite);

  nlohmann::ordered_json summary{{"program", "packbed"},
                                 {"version", version},
                                 {"case", std::filesystem::absolute(c.file).string()},
                                 {"title", c.title}};
  write_text_file(folder / "case.toml", setup::check_text(c, f));
  const bool carried_out = can_simulate(c);
  if (carried_out) add_results(summary, simulate(c, folder));
  summary["steps_carried_out"] = carried_out ? c.protocol.size() : 0;
  summary["steps_in_case"] = c.protocol.size();
  summary["figures"] = setup::figures_json(c, f);
  write_text_file(folder / "summary.json", json_text(summary));
  if (command.json) {
    fmt::print("{}", json_text(summary));
  } else {
    report(c, f, folder, carried_out);
  }
  return 0;
}

}  // namespace packbed::app
