// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <fmt/format.h>

#include "report/html.hpp"
#include "report/key_figures.hpp"
#include "report/plots.hpp"
#include "report/scorecard.hpp"
#include "report/tables.hpp"
#include "report/web_files.hpp"

namespace packbed::report {
namespace {

// The page asks for nothing from anywhere, and a browser holds it to that.
constexpr auto policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

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

/// Headings and places of the plots; their data goes to `data`, in the same order.
std::string plot_section(const PlotGroup& group, Json& data, const std::vector<Rose>& roses = {}) {
  if (group.plots.empty()) return {};
  std::string body = fmt::format("<p>{}</p>\n<div class=\"plots\">\n", escaped(group.text));
  for (const auto& plot : group.plots) {
    body += fmt::format(
        "<figure><figcaption>{}</figcaption><div class=\"plot\" data-plot=\"{}\"></div></figure>\n",
        escaped(plot.title), data.size());
    data.push_back(to_json(plot));
  }
  for (const auto& rose : roses) body += rose_figure(rose);
  return section(group.id, group.title, body + "</div>\n");
}

std::string subtitle(const std::vector<RunData>& runs) {
  if (runs.size() > 1) return fmt::format("{} runs compared", runs.size());
  const auto& summary = runs[0].summary;
  return fmt::format("packbed {}, case {}", escaped(summary.value("version", "")),
                     escaped(std::filesystem::path(summary.value("case", "")).filename().string()));
}

std::string links(const std::string& body) {
  std::string html;
  const std::pair<const char*, const char*> places[] = {
      {"scores", "Methods"},    {"figures", "Key figures"}, {"case", "Case"},
      {"flow", "Flow"},         {"plunger", "Plunger"},     {"time", "Time"},
      {"sections", "Sections"}, {"evenness", "Evenness"},   {"forces", "Forces"},
      {"profiles", "Profiles"}, {"checks", "Checks"},       {"times", "Timings"}};
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
                 : scorecard_section(runs) + figure_table(runs) + difference_table(runs, units);
  auto data = Json::array();
  for (auto* plots : {flow_plots, plunger_plots, time_plots, section_plots, evenness_plots}) {
    body += plot_section(plots(runs), data);
  }
  body += plot_section(force_plots(runs), data, direction_roses(runs));
  for (auto* plots : {profile_plots, check_plots}) body += plot_section(plots(runs), data);
  if (is_one) body += times_table(runs[0]);
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
