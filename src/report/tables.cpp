// SPDX-License-Identifier: BSD-3-Clause
#include "report/tables.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "report/html.hpp"
#include "report/key_figures.hpp"

namespace packbed::report {
namespace {

std::string head_cells(const std::vector<RunData>& runs) {
  std::string cells;
  for (const auto& run : runs) {
    cells += fmt::format("<th scope=\"col\">{}</th>", escaped(run.label));
  }
  return cells;
}

std::string row(const std::string& name, const std::vector<std::string>& values) {
  std::string cells;
  for (const auto& v : values) {
    cells += fmt::format("<td>{}</td>", v.empty() ? "&ndash;" : escaped(v));
  }
  return fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>\n", escaped(name), cells);
}

std::string table(const std::string& head, const std::string& rows) {
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><td></td>{}</tr></thead>\n<tbody>\n{}</tbody>\n"
      "</table></div>\n",
      head, rows);
}

}  // namespace

std::string section(const std::string& id, const std::string& title, const std::string& body) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, title, body);
}

std::string figure_table(const std::vector<RunData>& runs) {
  std::vector<std::string> titles(runs.size());
  std::ranges::transform(runs, titles.begin(), &RunData::title);
  std::vector<std::vector<KeyFigure>> all(runs.size());
  std::ranges::transform(runs, all.begin(), key_figures);
  auto rows = row("Title", titles);
  for (std::size_t k = 0; k < all.front().size(); ++k) {
    std::vector<std::string> values(runs.size());
    std::ranges::transform(all, values.begin(),
                           [&](const auto& figures) { return figures[k].value; });
    const bool is_anywhere =
        std::ranges::any_of(values, [](const std::string& v) { return !v.empty(); });
    if (is_anywhere) rows += row(all.front()[k].name, values);
  }
  return section("figures", "Key figures", table(head_cells(runs), rows));
}

std::string steps_list(const std::vector<Sentence>& sentences) {
  std::string items;
  for (const auto& s : sentences) {
    items +=
        fmt::format("<li>{}{}</li>\n", escaped(s.text), s.parts.empty() ? "" : steps_list(s.parts));
  }
  return fmt::format("<ol>\n{}</ol>\n", items);
}

std::string difference_table(const std::vector<RunData>& runs, const UnitSystem& units) {
  std::string rows;
  if (!have_same_steps(runs)) {
    rows += "<tr><th scope=\"row\">protocol</th>";
    for (const auto& run : runs) {
      rows += fmt::format("<td>{}</td>", steps_list(protocol_sentences(run, units)));
    }
    rows += "</tr>\n";
  }
  for (const auto& difference : differences(runs)) rows += row(difference.key, difference.values);
  if (rows.empty()) {
    return section("case", "What differs", "<p>The cases have the same values.</p>\n");
  }
  return section("case", "What differs", table(head_cells(runs), rows));
}

std::string times_table(const RunData& run) {
  const auto times = stage_times(run);
  if (times.empty()) return {};
  double longest = 0.0;
  for (const auto& t : times) longest = std::max(longest, t.all);
  std::string rows;
  for (const auto& t : times) {
    std::string bar;
    const double rest = std::max(0.0, t.all - t.beads - t.coupling - t.liquid - t.outputs);
    const double parts[] = {t.beads, t.coupling, t.liquid, t.outputs, rest};
    for (std::size_t k = 0; k < std::size(parts); ++k) {
      bar += fmt::format("<i class=\"part{}\" style=\"width:{:.2f}%\"></i>", k,
                         longest > 0.0 ? 100.0 * parts[k] / longest : 0.0);
    }
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td>"
        "<td>{:.3g}</td><td class=\"bar\">{}</td></tr>\n",
        escaped(t.stage), t.beads, t.coupling, t.liquid, t.outputs, t.all, bar);
  }
  return section("times", "Where the time went",
                 table("<th scope=\"col\"><i class=\"part0 key\"></i>beads [s]</th>"
                       "<th scope=\"col\"><i class=\"part1 key\"></i>coupling [s]</th>"
                       "<th scope=\"col\"><i class=\"part2 key\"></i>liquid [s]</th>"
                       "<th scope=\"col\"><i class=\"part3 key\"></i>outputs [s]</th>"
                       "<th scope=\"col\">all [s]</th><td></td>",
                       rows));
}

}  // namespace packbed::report
