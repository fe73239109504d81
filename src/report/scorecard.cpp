// SPDX-License-Identifier: BSD-3-Clause
#include "report/scorecard.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/html.hpp"
#include "report/plot.hpp"
#include "report/tables.hpp"

namespace packbed::report {
namespace {

constexpr double same = 1e-3;  ///< share by which equal velocities may differ

/// Of analysis.csv, in one state of the bed.
struct OfState {
  const char* column;
  const char* name;
  const char* unit;
  double factor;
  bool lowest_is_best;
  bool when_packed;
  bool at_the_end;
};

const OfState of_states[] = {{"S_mean", "S_mean", "", 1.0, true, true, true},
                             {"S_init", "S_init", "", 1.0, true, false, true},
                             {"IPD_absolute_d", "IPD", "d", 1.0, true, true, true},
                             {"share_above_6", "F > 6 <F>", "%", 100.0, true, true, true},
                             {"bed_height_m", "bed height", "mm", per_mm, false, true, true}};

bool is_flow(double velocity, double flow) {
  return flow > 0.0 && std::abs(velocity - flow) <= same * flow;
}

const Plateau* last_plateau(const RunData& run, double flow) {
  const Plateau* last = nullptr;
  for (const auto& p : run.plateaus) {
    if (is_flow(p.velocity, flow)) last = &p;
  }
  return last;
}

double common_flow(const std::vector<RunData>& runs) {
  double highest = unknown;
  for (const auto& p : runs.front().plateaus) {
    const bool is_common = p.velocity > 0.0 && std::ranges::all_of(runs, [&](const RunData& run) {
                             return last_plateau(run, p.velocity) != nullptr;
                           });
    if (is_common && !(p.velocity <= highest)) highest = p.velocity;
  }
  return highest;
}

/// Value of a column when packing was over, or in the last frame after that.
double state_value(const RunData& run, const char* column, bool packed) {
  const auto& table = run.analysis;
  if (table.empty() || !table.has(column)) return unknown;
  for (std::size_t i = table.rows(); i-- > 0;) {
    const double behind = table["stage"][i] - table["packing_end"][i];
    if (packed ? behind == 0.0 : behind > 0.0) return table[column][i];
  }
  return unknown;
}

/// Mean of a column over the frames after packing at this flow.
double mean_in_flow(const RunData& run, const char* column, double flow) {
  const auto& table = run.analysis;
  if (table.empty() || !table.has(column)) return unknown;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const bool counts = table["stage"][i] > table["packing_end"][i] &&
                        is_flow(table["superficial_velocity_m_s"][i], flow) &&
                        std::isfinite(table[column][i]);
    if (!counts) continue;
    sum += table[column][i];
    ++count;
  }
  return count > 0 ? sum / count : unknown;
}

/// Column over grain diameter.
double width_in_grains(const RunData& run) {
  return run.analysis.empty() ? unknown : run.analysis["D_over_d_eff"].back();
}

/// States at different flows are no answer to which method is better.
void warn_of_flows(const std::vector<RunData>& runs, std::vector<std::string>& warnings) {
  double low = unknown;
  double high = unknown;
  for (const auto& run : runs) {
    const double flow = state_value(run, "superficial_velocity_m_s", false);
    low = std::fmin(low, flow);
    high = std::fmax(high, flow);
  }
  if (!(std::abs(high - low) > same * std::abs(high))) return;
  warnings.push_back(fmt::format(
      "the last frames are of different flows, {:.4g} to {:.4g} cm/h: what stands under "
      "\"end\" cannot be compared",
      per_cm_h * low, per_cm_h * high));
}

std::vector<std::string> warnings_of(const std::vector<RunData>& runs) {
  std::vector<std::string> warnings;
  double low = unknown;
  double high = unknown;
  for (const auto& run : runs) {
    if (run.analysis.empty()) {
      warnings.push_back(
          fmt::format("{}: its frames were not analyzed; `packbed analyze {}` does it", run.label,
                      run.folder.string()));
    }
    const double width = width_in_grains(run);
    low = std::fmin(low, width);
    high = std::fmax(high, width);
  }
  if (high > 1.05 * low) {
    warnings.push_back(
        fmt::format("the columns are {:.1f} to {:.1f} grain diameters wide: IPD and sigma_z2 of "
                    "different widths "
                    "cannot be compared",
                    low, high));
  }
  warn_of_flows(runs, warnings);
  return warnings;
}

void add(Scorecard& card, Criterion criterion, const std::vector<double>& values) {
  card.criteria.push_back(std::move(criterion));
  for (std::size_t r = 0; r < values.size(); ++r) card.values[r].push_back(values[r]);
}

template <class Value>
std::vector<double> each(const std::vector<RunData>& runs, const Value& value) {
  std::vector<double> values(runs.size());
  std::ranges::transform(runs, values.begin(), value);
  return values;
}

/// A cell of a CSV file.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

}  // namespace

bool Scorecard::is_best(std::size_t run, std::size_t criterion) const {
  if (!criteria[criterion].lowest_is_best || !std::isfinite(values[run][criterion])) return false;
  bool beats_one = false;
  for (const auto& other : values) {
    if (other[criterion] < values[run][criterion]) return false;
    beats_one = beats_one || other[criterion] > values[run][criterion];
  }
  return beats_one;
}

std::string Scorecard::shown(std::size_t run, std::size_t criterion) const {
  const double value = values[run][criterion];
  return std::isfinite(value) ? fmt::format("{:.4g}", criteria[criterion].factor * value) : "";
}

Scorecard scorecard(const std::vector<RunData>& runs) {
  Scorecard card{.flow = common_flow(runs),
                 .criteria = {},
                 .values = std::vector<std::vector<double>>(runs.size()),
                 .warnings = warnings_of(runs)};
  for (const auto& of : of_states) {
    for (const bool packed : {true, false}) {
      if (packed ? !of.when_packed : !of.at_the_end) continue;
      const std::string when = packed ? "packed" : "end";
      add(card,
          {.key = fmt::format("{}_{}", when, of.column),
           .name = of.name,
           .when = when,
           .unit = of.unit,
           .factor = of.factor,
           .lowest_is_best = of.lowest_is_best},
          each(runs, [&](const RunData& run) { return state_value(run, of.column, packed); }));
    }
  }
  add(card,
      {.key = "sigma_z2_m2_s2",
       .name = "sigma_z2",
       .when = "mean",
       .unit = "cm2/s2",
       .factor = 1e4,
       .lowest_is_best = true},
      each(runs,
           [&](const RunData& run) { return mean_in_flow(run, "sigma_z2_m2_s2", card.flow); }));
  add(card,
      {.key = "pressure_drop_Pa",
       .name = "pressure",
       .when = "last",
       .unit = "bar",
       .factor = per_bar,
       .lowest_is_best = true},
      each(runs, [&](const RunData& run) {
        const auto* plateau = last_plateau(run, card.flow);
        return plateau != nullptr ? plateau->pressure_drop : unknown;
      }));
  add(card, {.key = "D_over_d_eff", .name = "D/d", .when = "", .unit = ""},
      each(runs, width_in_grains));
  return card;
}

std::string to_csv(const Scorecard& card, const std::vector<RunData>& runs) {
  std::string text = "run,folder,flow_m_s";
  for (const auto& c : card.criteria) text += fmt::format(",{}", c.key);
  text += '\n';
  const auto cell = [](double v) {
    return std::isfinite(v) ? fmt::format("{}", v) : std::string();
  };
  for (std::size_t r = 0; r < runs.size(); ++r) {
    text += fmt::format("{},{},{}", quoted(runs[r].label), quoted(runs[r].folder.string()),
                        cell(card.flow));
    for (const double v : card.values[r]) text += fmt::format(",{}", cell(v));
    text += '\n';
  }
  return text;
}

std::string scorecard_text(const Scorecard& card) {
  return fmt::format(
      "packed: when packing was over; end: the last frame after that. {} The lowest of each is "
      "marked; "
      "bed heights are not ranked.",
      std::isfinite(card.flow)
          ? fmt::format(
                "sigma_z2 (mean of the frames after packing) and pressure drop (last plateau) at "
                "{:.4g} cm/h, the highest flow of which all runs have a plateau.",
                per_cm_h * card.flow)
          : std::string(
                "No flow is common to all runs, so sigma_z2 and pressure drop are missing."));
}

std::string scorecard_section(const std::vector<RunData>& runs) {
  if (std::ranges::all_of(runs, [](const RunData& run) { return run.analysis.empty(); })) return {};
  const auto card = scorecard(runs);
  std::string head;
  for (const auto& c : card.criteria) {
    head +=
        fmt::format("<th scope=\"col\">{}<br><small>{}{}</small></th>", escaped(c.name),
                    escaped(c.when), c.unit.empty() ? "" : fmt::format(" [{}]", escaped(c.unit)));
  }
  std::string rows;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", escaped(runs[r].label));
    for (std::size_t k = 0; k < card.criteria.size(); ++k) {
      const auto value = card.shown(r, k);
      rows += fmt::format("<td{}>{}</td>", card.is_best(r, k) ? " class=\"best\"" : "",
                          value.empty() ? "&ndash;" : escaped(value));
    }
    rows += "</tr>\n";
  }
  std::string notes;
  for (const auto& w : card.warnings)
    notes += fmt::format("<p class=\"fine\">{}.</p>\n", escaped(w));
  return section(
      "scores", "Packing methods",
      fmt::format("<p>{}</p>\n<div class=\"scroll\"><table class=\"scores\">\n"
                  "<thead><tr><td></td>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n{}",
                  escaped(scorecard_text(card)), head, rows, notes));
}

}  // namespace packbed::report
