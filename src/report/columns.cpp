// SPDX-License-Identifier: BSD-3-Clause
#include "report/columns.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"

namespace packbed::report {
namespace {

std::string_view next_part(std::string_view& text, char end) {
  const auto at = text.find(end);
  const auto part = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view{} : text.substr(at + 1);
  return part;
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  while (!line.empty()) cells.emplace_back(next_part(line, ','));
  return cells;
}

std::optional<double> value(std::string_view cell) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  return to_number(cell);
}

}  // namespace

Columns::Columns(const std::filesystem::path& file, std::string_view text_column) : file_(file) {
  const auto text = read_text_file(file);
  std::string_view rest = text;
  std::vector<std::vector<double>*> in_order;
  for (const auto& name : split(next_part(rest, '\n'))) {
    const bool is_text = !text_column.empty() && name == text_column;
    in_order.push_back(is_text ? nullptr : &columns_[name]);
  }
  for (std::size_t line = 2; !rest.empty(); ++line) {
    auto cells = next_part(rest, '\n');
    const auto count = static_cast<std::size_t>(std::ranges::count(cells, ',')) + 1;
    for (auto* column : in_order) {
      if (column == nullptr && count == in_order.size()) {
        texts_.emplace_back(next_part(cells, ','));
        continue;
      }
      const auto number = count == in_order.size() ? value(next_part(cells, ',')) : std::nullopt;
      if (!number) {
        throw DataError(fmt::format(
            "{}:{}: this row is not as packbed wrote it; run the case again", file.string(), line));
      }
      column->push_back(*number);
    }
    ++rows_;
  }
}

const std::vector<double>& Columns::operator[](std::string_view name) const {
  const auto found = columns_.find(name);
  if (found != columns_.end()) return found->second;
  throw DataError(
      fmt::format("{}: column \"{}\" is missing; was it written by another version of packbed?",
                  file_.string(), name));
}

}  // namespace packbed::report
