// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_data.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace packbed::report {
namespace {

Plateau plateau_of_row(const Columns& series, std::size_t row) {
  Plateau p{.stage = static_cast<int>(series["stage"][row]),
            .time = series["time_s"][row],
            .velocity = series["superficial_velocity_m_s"][row],
            .pressure_drop = series["pressure_drop_Pa"][row]};
  if (series.has("bed_height_m")) {
    p.bed_height = series["bed_height_m"][row];
    p.compression = series["compression"][row];
    if (p.bed_height > 0.0) p.pressure_gradient = p.pressure_drop / p.bed_height;
  }
  return p;
}

}  // namespace

std::optional<double> RunData::number(const std::string& pointer) const {
  const Json::json_pointer at(pointer);
  if (!summary.contains(at) || !summary.at(at).is_number()) return std::nullopt;
  return summary.at(at).get<double>();
}

std::string RunData::title() const {
  const auto title = summary.find("title");
  return title != summary.end() && title->is_string() ? title->get<std::string>()
                                                      : folder.filename().string();
}

std::vector<std::string> RunData::warnings() const {
  std::vector<std::string> all;
  if (const auto found = summary.find("warnings"); found != summary.end()) {
    for (const auto& w : *found) all.push_back(w.is_string() ? w.get<std::string>() : w.dump());
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto stage = static_cast<int>(i + 1);
    const auto in_stage = [&](const Plateau& p) { return p.stage == stage; };
    const auto count = std::ranges::count_if(plateaus, in_stage);
    const auto unsteady =
        std::ranges::count_if(plateaus, [&](const Plateau& p) { return in_stage(p) && !p.steady; });
    if (unsteady == 0) continue;
    all.push_back(
        fmt::format("stage {} ({}): {} of {} plateau{} {} not steady at {} end; a longer hold "
                    "would bring other "
                    "figures",
                    stage, stages[i], unsteady, count, count == 1 ? "" : "s",
                    unsteady == 1 ? "was" : "were", unsteady == 1 ? "its" : "their"));
  }
  return all;
}

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

std::vector<Plateau> plateaus_of_series(const Columns& series) {
  std::vector<Plateau> plateaus;
  if (!series.has("superficial_velocity_m_s")) return plateaus;
  const auto& velocity = series["superficial_velocity_m_s"];
  const auto& stage = series["stage"];
  const auto is_like = [&](std::size_t a, std::size_t b) {
    return velocity[a] == velocity[b] && stage[a] == stage[b];
  };
  for (std::size_t i = 1; i < series.rows(); ++i) {
    const bool stood = velocity[i] != 0.0 && is_like(i - 1, i);
    const bool ends = i + 1 == series.rows() || !is_like(i, i + 1);
    if (stood && ends) plateaus.push_back(plateau_of_row(series, i));
  }
  if (!plateaus.empty()) return plateaus;
  // Rows are further apart than plateaus are long: each stands for itself.
  for (std::size_t i = 0; i < series.rows(); ++i) {
    if (velocity[i] != 0.0) plateaus.push_back(plateau_of_row(series, i));
  }
  return plateaus;
}

}  // namespace packbed::report
