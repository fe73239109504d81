// SPDX-License-Identifier: BSD-3-Clause
#include "app/report.hpp"

#include <fmt/format.h>

#include "app/commands.hpp"
#include "core/file.hpp"
#include "report/page.hpp"
#include "setup/read_measured.hpp"

namespace packbed::app {

std::filesystem::path write_report(const std::filesystem::path& folder, const UnitSystem& units) {
  auto file = folder / "report.html";
  write_text_file(file, report::page({report::read_run(folder, units)}, units));
  return file;
}

int report(const ReportCommand& command) {
  const UnitSystem units;
  std::vector<report::RunData> runs;
  for (const auto& folder : command.runs) {
    runs.push_back(report::read_run(folder, units));
    if (!command.measured.empty()) {
      runs.back().measured = setup::read_measured(command.measured, units);
    }
  }
  auto file = command.output;
  if (file.empty()) {
    file = runs.size() == 1 ? runs[0].folder / "report.html" : "comparison.html";
  }
  write_text_file(file, report::page(std::move(runs), units));
  fmt::print("Report: {}\n", file.string());
  return 0;
}

}  // namespace packbed::app
