// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli.hpp"

namespace packbed::app {

void add_analyze(CLI::App& app, AnalyzeCommand& options, Action& action) {
  auto* command = app.add_subcommand(
      "analyze", "Analyze the frames of a run: forces, stresses, sections, porosity, liquid");
  command->add_option("RUN", options.run, "Folder of a run that has ended")->required();
  command->add_option("-o,--output", options.output,
                      "Folder of the tables; by default analysis in the folder of the run");
  auto* frame = command->add_option("--frame", options.frame, "Number of the one frame to analyze")
                    ->check(CLI::Range(0, 999'999'999));
  command->add_flag("--all", options.all, "All frames, not only those at the ends of stages")
      ->excludes(frame);
  add_json(*command, options.json);
  command->callback([&] { action = [&] { return analyze(options); }; });
}

void add_compare(CLI::App& app, CompareCommand& options, Action& action) {
  auto* command = app.add_subcommand(
      "compare", "Compare packing methods: figures of several runs, the best of each marked");
  command->add_option("RUN", options.runs, "Folders of runs that have ended")->required();
  command->add_option("-o,--output", options.output, "Page to write; by default comparison.html");
  command->add_option("--csv", options.csv, "Also write the table to this file, in SI");
  command->callback([&] { action = [&] { return compare(options); }; });
}

}  // namespace packbed::app
