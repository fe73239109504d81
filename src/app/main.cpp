// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <new>
#include <thread>

#include <fmt/format.h>

#include "app/cli.hpp"
#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/freed_memory.hpp"
#include "core/ranks.hpp"
#include "core/text.hpp"
#include "core/version.hpp"

namespace packbed::app {
namespace {

void add_run(CLI::App& app, RunCommand& options, Action& action) {
  auto* command = app.add_subcommand("run", "Run a case");
  command->add_option("CASE", options.file, "Case file (TOML)")->required();
  command->add_option("-o,--output", options.directory,
                      "Folder of the results; by default as the case says, runs/<case>");
  command
      ->add_option("-n,--ranks", options.ranks,
                   "Processes to share the run; by default as many cores as it can use")
      ->check(CLI::Range(1, 4096));
  auto* overwrite =
      command->add_flag("--overwrite", options.overwrite, "Replace results of an earlier run");
  command
      ->add_flag("--resume", options.resume,
                 "Go on with an interrupted run from its last checkpoint")
      ->excludes(overwrite);
  add_json(*command, options.json);
  command->callback([&] { action = [&] { return run(options); }; });
}

void add_check(CLI::App& app, CheckCommand& options, Action& action) {
  auto* command = app.add_subcommand(
      "check", "Read a case and print it with every default filled in, and its figures");
  command->add_option("CASE", options.file, "Case file (TOML)")->required();
  command->add_option("--mesh-svg", options.mesh_svg,
                      "Also draw the cross-section of the mesh to this file (SVG)");
  add_json(*command, options.json);
  command->callback([&] { action = [&] { return check(options); }; });
}

void add_report(CLI::App& app, ReportCommand& options, Action& action) {
  auto* command = app.add_subcommand(
      "report", "Write the page of a run again, or compare several runs on one page");
  command->add_option("RUN", options.runs, "Folders of runs that have ended")->required();
  command->add_option("-o,--output", options.output,
                      "File to write; by default report.html in the folder of the run, or "
                      "comparison.html of several");
  command->add_option("--measured", options.measured,
                      "CSV file of measured points to show, in place of those of the case");
  command->callback([&] { action = [&] { return report(options); }; });
}

void add_resins(CLI::App& app, ResinsCommand& options, Action& action) {
  auto* command =
      app.add_subcommand("resins", "List the resin library, or show one resin with its sources");
  command->add_option("NAME", options.name, "Name or alias of a resin");
  command->add_option("--library", options.library, "A library file of your own, added to ours");
  add_json(*command, options.json);
  command->callback([&] { action = [&] { return resins(options); }; });
}

void add_units(CLI::App& app, UnitsCommand& options, Action& action) {
  auto* command = app.add_subcommand("units", "Show how quantities with units are written");
  add_json(*command, options.json);
  command->callback([&] { action = [&] { return units(options); }; });
}

// On several ranks one that fails ends them all. Mostly all fail alike; the first one speaks, and
// the others only if it has nothing to say.
int complain(const std::string& message, ExitCode code) {
  const auto ranks = Ranks::all();
  if (!ranks.is_first()) std::this_thread::sleep_for(std::chrono::seconds(1));
  fmt::print(stderr, "packbed: {}{}\n",
             ranks.is_first() ? "" : fmt::format("rank {}: ", ranks.rank()), message);
  if (ranks.size() > 1) ranks.abort(static_cast<int>(code));
  return static_cast<int>(code);
}

// CLI11 would only say that a command is required.
void check_command(const CLI::App& app, const std::string& word) {
  if (word.starts_with('-')) return;
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  if (std::ranges::find(names, word) != names.end()) return;
  const auto near = nearest(word, names);
  throw ConfigError(fmt::format("\"{}\" is not a command{}; known are {}", word,
                                near ? fmt::format(", did you mean \"{}\"?", *near) : "",
                                either_of(names)));
}

int dispatch(int argc, char** argv) {
  give_back_freed_memory();
  const MpiSession session;
  CLI::App app("packbed simulates packed chromatography columns bead by bead.");
  app.set_version_flag("--version", fmt::format("packbed {}", version));
  app.require_subcommand(1);
  app.footer("Manual: docs/manual. First case: packbed run cases/quickstart.toml");
  RunCommand run_options;
  CheckCommand check_options;
  ReportCommand report_options;
  AnalyzeCommand analyze_options;
  CompareCommand compare_options;
  ResinsCommand resins_options;
  UnitsCommand units_options;
  BeadCommands bead_options;
  FlowCommands flow_options;
  WallSupportCommands wall_support_options;
  Action action;
  add_run(app, run_options, action);
  add_check(app, check_options, action);
  add_report(app, report_options, action);
  add_analyze(app, analyze_options, action);
  add_compare(app, compare_options, action);
  add_resins(app, resins_options, action);
  add_units(app, units_options, action);
  add_bead(app, bead_options, action);
  add_flow(app, flow_options, action);
  add_wall_support(app, wall_support_options, action);
  if (argc < 2) {
    fmt::print("{}", app.help());
    return static_cast<int>(ExitCode::input);
  }
  try {
    check_command(app, argv[1]);
    app.parse(argc, argv);
    const int code = action();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw DataError("standard output cannot be written");
    }
    return code;
  } catch (const CLI::CallForVersion& asked) {
    fmt::print("{}\n", asked.what());
    return 0;
  } catch (const CLI::Success& asked) {  // --help
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return complain(fmt::format("{}; `packbed --help` lists commands and options", error.what()),
                    ExitCode::input);
  } catch (const Stopped& stopped) {  // on all ranks at the same step
    if (Ranks::all().is_first()) fmt::print(stderr, "packbed: {}\n", stopped.what());
    return static_cast<int>(stopped.exit_code());
  } catch (const Error& error) {
    return complain(error.what(), error.exit_code());
  } catch (const std::bad_alloc&) {
    return complain("out of memory; take fewer beads, or a computer with more", ExitCode::files);
  }
}

}  // namespace
}  // namespace packbed::app

// Whatever is not an Error is a bug and may terminate.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) { return packbed::app::dispatch(argc, argv); }
