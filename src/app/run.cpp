// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
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

}  // namespace

int run(const RunCommand& command) {
  const UnitSystem units;
  const auto c = setup::read_case(command.file, units);
  const auto f = setup::figures(c);
  const std::filesystem::path folder =
      command.directory.empty() ? c.output.directory : command.directory;
  make_run_folder(folder, command.overwrite);

  const nlohmann::ordered_json summary{{"program", "packbed"},
                                       {"version", version},
                                       {"case", std::filesystem::absolute(c.file).string()},
                                       {"simulated_time_s", 0.0},
                                       {"steps_carried_out", 0},
                                       {"steps_in_case", c.protocol.size()},
                                       {"figures", setup::figures_json(c, f)}};
  write_text_file(folder / "case.toml", setup::check_text(c, f));
  write_text_file(folder / "summary.json", json_text(summary));

  if (command.json) {
    fmt::print("{}", json_text(summary));
    return 0;
  }
  fmt::print("{}: read and checked; {:.0f} grains, {} protocol steps\n", c.title, f.bead_count,
             c.protocol.size());
  fmt::print(
      "NOT SIMULATED: packbed {} prepares cases; it has no bead mechanics and no liquid yet, "
      "so none of the {} steps was carried out.\n",
      version, c.protocol.size());
  fmt::print("Written: {0}/case.toml (every value filled in), {0}/summary.json\n", folder.string());
  return 0;
}

}  // namespace packbed::app
