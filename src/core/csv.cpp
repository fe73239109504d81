// SPDX-License-Identifier: BSD-3-Clause
#include "core/csv.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"

namespace packbed {
namespace {

std::vector<std::string> split_row(std::string_view line) {
  std::vector<std::string> cells;
  while (true) {
    const auto comma = line.find(',');
    cells.emplace_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : file_(file) {
  std::istringstream text(read_text_file(file));
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    const auto content = trimmed(line);
    if (content.empty() || content.starts_with('#')) continue;
    if (header_.empty()) {
      read_header(std::string(content), number);
      continue;
    }
    auto cells = split_row(content);
    if (cells.size() != header_.size()) {
      throw ConfigError(
          fmt::format("{}:{}: cells in this row: {}, in the header: {}{}", file_.string(), number,
                      cells.size(), header_.size(),
                      cells.size() > header_.size() ? "; decimals need points, not commas" : ""));
    }
    lines_.push_back(number);
    std::ranges::move(cells, std::back_inserter(cells_));
  }
  if (lines_.empty()) throw ConfigError(fmt::format("{}: it has no rows", file_.string()));
}

void CsvTable::read_header(const std::string& line, std::size_t number) {
  header_line_ = number;
  const auto at = [&] { return fmt::format("{}:{}", file_.string(), number); };
  if (line.find(';') != std::string::npos || line.find('\t') != std::string::npos) {
    throw ConfigError(
        fmt::format("{}: columns must be separated by commas (and decimals by points), not by {}",
                    at(), line.find(';') != std::string::npos ? "semicolons" : "tabs"));
  }
  header_ = split_row(line);
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (to_number(header_[i])) {
      throw ConfigError(fmt::format(
          "{}: \"{}\" is a number where a column name is expected; the first row must be a header",
          at(), header_[i]));
    }
    if (std::find(header_.begin(), header_.begin() + static_cast<std::ptrdiff_t>(i), header_[i]) !=
        header_.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw ConfigError(fmt::format("{}: column \"{}\" is there twice", at(), header_[i]));
    }
  }
}

int CsvTable::find(const std::string& name) const {
  const auto found = std::ranges::find(header_, name);
  return found == header_.end() ? -1 : static_cast<int>(found - header_.begin());
}

const std::string& CsvTable::text(std::size_t row, int column) const {
  return cells_[row * header_.size() + static_cast<std::size_t>(column)];
}

double CsvTable::number(std::size_t row, int column) const {
  const auto& cell = text(row, column);
  if (const auto value = to_number(cell)) return *value;
  throw ConfigError(fmt::format("{}: {} = \"{}\" is not a finite number", place(row),
                                header_[static_cast<std::size_t>(column)], cell));
}

std::string CsvTable::place(std::size_t row) const {
  return fmt::format("{}:{}", file_.string(), lines_[row]);
}

std::string CsvTable::header_place() const {
  return fmt::format("{}:{}", file_.string(), header_line_);
}

ColumnName split_column_name(const std::string& header) {
  const auto open = header.find('[');
  if (open == std::string::npos || !header.ends_with(']')) return {header, ""};
  return {std::string(trimmed(header.substr(0, open))),
          std::string(trimmed(header.substr(open + 1, header.size() - open - 2)))};
}

}  // namespace packbed
