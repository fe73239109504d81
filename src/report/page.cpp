// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "report/case_words.hpp"
#include "report/html.hpp"
#include "report/key_figures.hpp"
#include "report/plots.hpp"
#include "report/web_files.hpp"

namespace packbed::report {
namespace {

// The page asks for nothing from anywhere, and a browser holds it to that.
constexpr auto policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

std::string section(const std::string& id, const std::string& title, const std::string& body) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, title, body);
}

std::string warnings_box(const std::vector<RunData>& runs) {
  std::string items;
  for (const auto& run : runs) {
    for (const auto& warning : run.warnings()) {
      items += fmt::format("<li>{}{}</li>\n",
                           runs.size() > 1 ? fmt::format("<b>{}</b>: ", escaped(run.label)) : "",
                           escaped(warning));
    }
    if (run.was_simulated()) continue;
    items += fmt::format(
        "<li>{}not simulated: the protocol has a step that this version of packbed does not carry "
        "out, so there is only the case.</li>\n",
        runs.size() > 1 ? fmt::format("<b>{}</b>: ", escaped(run.label)) : "");
  }
  if (items.empty()) return "<p class=\"fine\">No warnings.</p>\n";
  return fmt::format("<section class=\"warnings\">\n<h2>Warnings</h2>\n<ul>\n{}</ul>\n</section>\n",
                     items);
}

std::string tiles(const RunData& run) {
  std::string html;
  for (const auto& figure : key_figures(run)) {
    if (figure.value.empty()) continue;
    html += fmt::format(
        "<div class=\"tile\"><dt>{}</dt><dd>{}{}</dd></div>\n", escaped(figure.name),
        escaped(figure.value),
        figure.note.empty() ? "" : fmt::format("<small>{}</small>", escaped(figure.note)));
  }
  if (html.empty()) return {};
  return section("figures", "Key figures", fmt::format("<dl class=\"tiles\">\n{}</dl>\n", html));
}

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

std::string figure_table(const std::vector<RunData>& runs) {
  std::vector<std::vector<KeyFigure>> all;
  for (const auto& run : runs) all.push_back(key_figures(run));
  std::vector<std::string> titles;
  for (const auto& run : runs) titles.push_back(run.title());
  auto rows = row("Title", titles);
  for (std::size_t k = 0; k < all.front().size(); ++k) {
    std::vector<std::string> values;
    for (const auto& figures : all) values.push_back(figures[k].value);
    const bool is_anywhere =
        std::ranges::any_of(values, [](const std::string& v) { return !v.empty(); });
    if (is_anywhere) rows += row(all.front()[k].name, values);
  }
  return section("figures", "Key figures", table(head_cells(runs), rows));
}

std::string difference_table(const std::vector<RunData>& runs) {
  std::string rows;
  for (const auto& difference : differences(runs)) rows += row(difference.key, difference.values);
  if (rows.empty()) {
    return section("case", "What differs", "<p>The cases have the same values.</p>\n");
  }
  return section("case", "What differs", table(head_cells(runs), rows));
}

std::string steps_list(const std::vector<Sentence>& sentences) {
  std::string items;
  for (const auto& s : sentences) {
    items +=
        fmt::format("<li>{}{}</li>\n", escaped(s.text), s.parts.empty() ? "" : steps_list(s.parts));
  }
  return fmt::format("<ol>\n{}</ol>\n", items);
}

std::string case_section(const RunData& run, const UnitSystem& units) {
  std::string lines;
  for (const auto& line : case_lines(run, units)) {
    lines += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(line.name), escaped(line.text));
  }
  const auto steps = protocol_sentences(run, units);
  lines +=
      fmt::format("<dt>Protocol</dt><dd>{}</dd>\n", steps.empty() ? "no steps" : steps_list(steps));
  return section("case", "The case",
                 fmt::format("<dl class=\"case\">\n{}</dl>\n<details><summary>Every value "
                             "(case.toml)</summary><pre>{}</pre></details>\n",
                             lines, escaped(run.case_text)));
}

std::string times_section(const RunData& run) {
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

/// Headings and places of the plots; their data goes to `data`, in the same order.
std::string plot_section(const PlotGroup& group, Json& data) {
  if (group.plots.empty()) return {};
  std::string body = fmt::format("<p>{}</p>\n<div class=\"plots\">\n", escaped(group.text));
  for (const auto& plot : group.plots) {
    body += fmt::format(
        "<figure><figcaption>{}</figcaption><div class=\"plot\" data-plot=\"{}\"></div></figure>\n",
        escaped(plot.title), data.size());
    data.push_back(to_json(plot));
  }
  return section(group.id, group.title, body + "</div>\n");
}

std::string subtitle(const std::vector<RunData>& runs) {
  if (runs.size() > 1) return fmt::format("{} runs compared", runs.size());
  const auto& summary = runs[0].summary;
  return fmt::format("packbed {}, case {}", escaped(summary.value("version", "")),
                     escaped(std::filesystem::path(summary.value("case", "")).filename().string()));
}

/// By their titles, else by their folders.
void tell_apart(std::vector<RunData>& runs) {
  const auto are_distinct = [&] {
    std::set<std::string> labels;
    for (const auto& run : runs) labels.insert(run.label);
    return labels.size() == runs.size();
  };
  for (auto& run : runs) run.label = run.title();
  if (are_distinct()) return;
  for (auto& run : runs)
    run.label = std::filesystem::absolute(run.folder).lexically_normal().filename().string();
  if (are_distinct()) return;
  for (auto& run : runs) run.label = run.folder.string();
}

std::string links(const std::string& body) {
  std::string html;
  const std::pair<const char*, const char*> places[] = {
      {"figures", "Key figures"}, {"case", "Case"},         {"flow", "Flow"},
      {"time", "Time"},           {"sections", "Sections"}, {"profiles", "Profiles"},
      {"checks", "Checks"},       {"times", "Timings"}};
  for (const auto& [id, name] : places) {
    if (body.find(fmt::format("<section id=\"{}\">", id)) == std::string::npos) continue;
    html += fmt::format("<a href=\"#{}\">{}</a>\n", id, name);
  }
  return html;
}

}  // namespace

std::string page(std::vector<RunData> runs, const UnitSystem& units) {
  tell_apart(runs);
  const bool is_one = runs.size() == 1;
  auto body = warnings_box(runs);
  body += is_one ? tiles(runs[0]) + case_section(runs[0], units)
                 : figure_table(runs) + difference_table(runs);
  auto data = Json::array();
  for (auto* plots : {flow_plots, time_plots, section_plots, profile_plots, check_plots}) {
    body += plot_section(plots(runs), data);
  }
  if (is_one) body += times_section(runs[0]);
  const auto title = is_one ? escaped(runs[0].title()) : "Comparison of runs";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}\n{}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n"
      "<p>{}</p>\n<nav>\n{}</nav>\n</header>\n<main>\n"
      "<noscript><p>Plots are drawn by a script, which this browser does not run.</p></noscript>\n"
      "{}</main>\n<footer>Drag in a plot to look closer, double click to go back; click a name in "
      "a legend to hide its curve.</footer>\n"
      "<script type=\"application/json\" id=\"data\">{}</script>\n<script>\n/* "
      "uPlot:\n{}*/\n{}\n{}</script>\n"
      "</body>\n</html>\n",
      policy, title, uplot_style, page_style, title, subtitle(runs), links(body), body,
      script_json(data), uplot_license, uplot_script, page_script);
}

}  // namespace packbed::report
