// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/plots.hpp"

namespace packbed::report {
namespace {

// A flow of no more than one velocity rises: from the bed at rest.
Branch branch_of(std::span<const Plateau> plateaus, std::size_t first, std::size_t last) {
  Branch branch;
  branch.rises = plateaus[last].velocity >= plateaus[first].velocity;
  for (std::size_t i = first; i <= last; ++i) branch.plateaus.push_back(i);
  std::ranges::stable_sort(branch.plateaus, {},
                           [&](std::size_t i) { return plateaus[i].velocity; });
  return branch;
}

}  // namespace

std::vector<Branch> branches(std::span<const Plateau> plateaus) {
  std::vector<Branch> all;
  std::size_t first = 0;
  int ups = 0;
  int downs = 0;
  while (first < plateaus.size()) {
    auto last = first;
    double direction = 0.0;
    for (; last + 1 < plateaus.size(); ++last) {
      const double change = plateaus[last + 1].velocity - plateaus[last].velocity;
      if (direction * change < 0.0) break;
      if (change != 0.0) direction = change;
    }
    auto branch = branch_of(plateaus, first, last);
    int& count = branch.rises ? ups : downs;
    ++count;
    branch.name = branch.rises ? "up" : "down";
    if (count > 1) branch.name += fmt::format(" {}", count);
    all.push_back(std::move(branch));
    if (last + 1 == plateaus.size()) break;
    first = last;
  }
  return all;
}

std::vector<Branch> shown_branches(std::span<const Plateau> plateaus) {
  constexpr std::ptrdiff_t limit = 6;
  constexpr std::ptrdiff_t last = 2;
  auto all = branches(plateaus);
  const auto excess = std::ssize(all) - limit;
  if (excess <= 0) return all;
  const auto first_left_out = all.end() - last - excess;
  all.erase(first_left_out, first_left_out + excess);
  return all;
}

std::string stage_label(const RunData& run, int stage) {
  const auto place = static_cast<std::size_t>(stage - 1);
  const bool has_name = stage > 0 && place < run.stages.size();
  return fmt::format("stage {}{}{}", stage, has_name ? ", " : "",
                     has_name ? run.stages[place] : "");
}

std::string stage_end_label(const RunData& run, int stage) {
  return stage == 0 ? "at the start" : "after " + stage_label(run, stage);
}

bool falls(const RunData& run, std::size_t plateau) {
  return plateau > 0 && run.plateaus[plateau].velocity < run.plateaus[plateau - 1].velocity;
}

std::string plateau_label(const RunData& run, std::size_t plateau) {
  return fmt::format("{:.4g} cm/h {}", per_cm_h * run.plateaus[plateau].velocity,
                     falls(run, plateau) ? "down" : "up");
}

std::size_t highest_flow(std::span<const Plateau> plateaus) {
  const auto size = [](const Plateau& p) { return std::abs(p.velocity); };
  return static_cast<std::size_t>(std::ranges::max_element(plateaus, {}, size) - plateaus.begin());
}

double plateau_shade(const RunData& run, std::size_t plateau) {
  const double highest = std::abs(run.plateaus[highest_flow(run.plateaus)].velocity);
  return highest > 0.0 ? std::abs(run.plateaus[plateau].velocity) / highest : 0.0;
}

std::string curve_label(std::span<const RunData> runs, std::size_t run, const std::string& what) {
  if (runs.size() == 1) return what;
  return what.empty() ? runs[run].label : fmt::format("{}, {}", runs[run].label, what);
}

std::vector<std::size_t> spread(std::size_t count, std::size_t limit) {
  std::vector<std::size_t> places;
  const auto taken = std::min(count, limit);
  if (taken == 1) return {count - 1};
  for (std::size_t k = 0; k < taken; ++k) places.push_back(k * (count - 1) / (taken - 1));
  return places;
}

}  // namespace packbed::report
