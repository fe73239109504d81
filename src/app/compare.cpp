// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "report/page.hpp"
#include "report/scorecard.hpp"

namespace packbed::app {
namespace {

void print(const report::Scorecard& card, const std::vector<report::RunData>& runs) {
  std::size_t wide = 4;
  for (const auto& run : runs) wide = std::max(wide, run.label.size());
  constexpr int cell = 11;
  const auto line = [&](const std::string& first, const auto& text_of) {
    fmt::print("{:<{}}", first, wide);
    for (std::size_t k = 0; k < card.criteria.size(); ++k) fmt::print(" {:>{}}", text_of(k), cell);
    fmt::print("\n");
  };
  line("", [&](std::size_t k) { return card.criteria[k].name; });
  line("", [&](std::size_t k) { return card.criteria[k].when; });
  line("run", [&](std::size_t k) {
    const auto& unit = card.criteria[k].unit;
    return unit.empty() ? std::string() : fmt::format("[{}]", unit);
  });
  for (std::size_t r = 0; r < runs.size(); ++r) {
    line(runs[r].label, [&](std::size_t k) {
      const auto value = card.shown(r, k);
      return value.empty() ? std::string("-") : value + (card.is_best(r, k) ? "*" : " ");
    });
  }
  fmt::print("{}\n", report::scorecard_text(card));
  for (const auto& warning : card.warnings) fmt::print("Warning: {}.\n", warning);
}

}  // namespace

int compare(const CompareCommand& command) {
  const UnitSystem units;
  if (command.runs.size() < 2) {
    throw ConfigError(
        "compare takes the folders of two runs or more; `packbed report RUN` shows one");
  }
  std::vector<report::RunData> runs;
  for (const auto& folder : command.runs) runs.push_back(report::read_run(folder, units));
  report::tell_apart(runs);
  const auto card = report::scorecard(runs);
  print(card, runs);
  if (!command.csv.empty()) {
    write_text_file(command.csv, report::to_csv(card, runs));
    fmt::print("Table: {}\n", command.csv.string());
  }
  write_text_file(command.output, report::page(std::move(runs), units));
  fmt::print("Report: {}\n", command.output.string());
  return 0;
}

}  // namespace packbed::app
