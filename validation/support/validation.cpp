// SPDX-License-Identifier: BSD-3-Clause
#include "validation/support/validation.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "core/csv.hpp"
#include "core/error.hpp"

namespace packbed::validation {
namespace {

std::string text_of(const Table& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows) text += fmt::format("{:.17g}\n", fmt::join(row, ","));
  return text;
}

Table read_table(const std::filesystem::path& file) {
  const CsvTable csv(file);
  Table table{.columns = csv.header(), .rows = {}};
  for (std::size_t r = 0; r < csv.rows(); ++r) {
    auto& row = table.rows.emplace_back();
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      row.push_back(csv.number(r, static_cast<int>(c)));
    }
  }
  return table;
}

int run_piece(const Validation& validation, const std::string& name) {
  const auto piece = std::ranges::find(validation.pieces, name, &Piece::name);
  if (piece == validation.pieces.end()) {
    throw ConfigError(fmt::format("there is no piece \"{}\"; `pieces` lists them", name));
  }
  fmt::print("{}", text_of(piece->run()));
  return 0;
}

int judge(const Validation& validation, const std::filesystem::path& folder) {
  Results results;
  for (const auto& piece : validation.pieces) {
    results[piece.name] = read_table(folder / (piece.name + ".csv"));
  }
  bool all_right = true;
  for (const auto& c : validation.judge(results)) {
    const bool right = c.measured >= c.low && c.measured <= c.high;
    all_right = all_right && right;
    fmt::print("{:<4} {:<52} {:>11.5g}  in [{:.5g}, {:.5g}]  {}\n", right ? "ok" : "FAIL", c.what,
               c.measured, c.low, c.high, c.reference);
  }
  return all_right ? 0 : 1;
}

int dispatch(std::span<char*> arguments, const Validation& validation) {
  const std::vector<std::string> words(arguments.begin() + 1, arguments.end());
  if (words.size() == 1 && words[0] == "pieces") {
    for (const auto& piece : validation.pieces) fmt::print("{}\n", piece.name);
    return 0;
  }
  if (words.size() == 1 && words[0] == "files") return 0;  // all is in the program
  if (words.size() == 2 && words[0] == "run") return run_piece(validation, words[1]);
  if (words.size() == 2 && words[0] == "judge") return judge(validation, words[1]);
  throw ConfigError("a validation takes: pieces | files | run PIECE | judge FOLDER");
}

}  // namespace

std::vector<double> Table::column(const std::string& name) const {
  const auto found = std::ranges::find(columns, name);
  if (found == columns.end()) throw ValueError("the table has no column \"" + name + "\"");
  const auto place = static_cast<std::size_t>(found - columns.begin());
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[place]);
  return values;
}

int validation_main(int argc, char** argv, const Validation& validation) {
  try {
    return dispatch({argv, static_cast<std::size_t>(argc)}, validation);
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return std::max(static_cast<int>(error.exit_code()), 2);  // 1 is a figure outside its limits
  }
}

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double mx = mean(x);
  const double my = mean(y);
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    xy += (x[i] - mx) * (y[i] - my);
  }
  return {.slope = xy / xx, .offset = my - xy / xx * mx};
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace packbed::validation
