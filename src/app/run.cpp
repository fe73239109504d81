// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/run_folder.hpp"
#include "app/simulate.hpp"
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
  summary["inertia_scale"] = r.inertia_scale;
  summary["ranks"] = Ranks::all().size();
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

// Below this a rank waits for its neighbors more than it works.
constexpr double fewest_grains_per_rank = 20000.0;

int useful_ranks(double grains) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(static_cast<int>(grains / fewest_grains_per_rank), 1, std::max(1, cores));
}

/// Starts this run again under mpiexec; returns only if that fails.
void start_ranks(int ranks, const RunCommand& command) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> words = {
      // Open MPI counts cores, not threads of the hardware, and else refuses more ranks than that.
      "mpiexec", "-q", "--oversubscribe", "-n", fmt::format("{}", ranks)};
  for (const auto& word : {program, std::string("run"), command.file.string()})
    words.push_back(word);
  if (!command.directory.empty()) words.insert(words.end(), {"-o", command.directory});
  words.emplace_back("--overwrite");  // asked and answered here
  if (command.json) words.emplace_back("--json");
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  // mpiexec puts a pipe where the terminal was.
  if (isatty(STDERR_FILENO) == 1) setenv("PACKBED_PROGRESS", "1", 1);
  // Open MPI refuses root, as whom packbed may well run in a container, unless told twice.
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  execvp("mpiexec", arguments.data());
  throw DataError(
      fmt::format("mpiexec cannot be started ({}); install the package openmpi-bin, or run "
                  "with -n 1",
                  std::strerror(errno)));
}

}  // namespace

int run(const RunCommand& command) {
  const UnitSystem units;
  const auto c = setup::read_case(command.file, units);
  const auto f = setup::figures(c);
  const std::filesystem::path folder =
      command.directory.empty() ? c.output.directory : command.directory;
  std::vector<std::filesystem::path> inputs = {command.file};
  if (c.beads.csv) inputs.push_back(*c.beads.csv);
  const bool carried_out = can_simulate(c);
  if (carried_out && !MpiSession::is_started()) {
    const int ranks = command.ranks > 0 ? command.ranks : useful_ranks(f.bead_count);
    if (ranks > 1) {
      make_run_folder(folder, command.overwrite, inputs);
      start_ranks(ranks, command);
    }
  }
  const bool writes = Ranks::all().is_first();
  if (writes) {
    make_run_folder(folder, command.overwrite, inputs);
    write_text_file(folder / "case.toml", setup::check_text(c, f));
  }
  nlohmann::ordered_json summary{{"program", "packbed"},
                                 {"version", version},
                                 {"case", std::filesystem::absolute(c.file).string()},
                                 {"title", c.title}};
  if (carried_out) add_results(summary, simulate(c, folder));
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
