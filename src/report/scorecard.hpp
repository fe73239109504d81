// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Packing methods side by side (thesis fig. 11.1): figures of several runs, the best of each marked. There is no
/// sum of them: what counts how much is for the engineer to say.

#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace packbed::report {

/// A figure by which runs are compared.
struct Criterion {
  std::string key;              ///< in CSV, with the SI unit: "sigma_z2_m2_s2"
  std::string name;             ///< on the page: "sigma_z2"
  std::string when;             ///< "packed", "end"
  std::string unit;             ///< in which it is shown: "cm2/s2"
  double factor = 1.0;          ///< from SI to it
  bool lowest_is_best = false;  ///< else none is
};

struct Scorecard {
  double flow = unknown;  ///< highest velocity of which all runs have a plateau [m/s]
  std::vector<Criterion> criteria;
  std::vector<std::vector<double>>
      values;                         ///< [run][criterion], SI; NaN where a run does not have it
  std::vector<std::string> warnings;  ///< why runs may not be comparable

  /// Whether no run is better and at least one is worse.
  [[nodiscard]] bool is_best(std::size_t run, std::size_t criterion) const;
  /// In the unit of the criterion, with four digits; empty where there is none.
  [[nodiscard]] std::string shown(std::size_t run, std::size_t criterion) const;
};

/// Of two or more runs. Those that were not analyzed have the figures of their plateaus alone.
Scorecard scorecard(const std::vector<RunData>& runs);

/// One row per run, in SI.
std::string to_csv(const Scorecard& card, const std::vector<RunData>& runs);

/// What the page says above the scores.
std::string scorecard_text(const Scorecard& card);

/// The part of the page; empty where no run was analyzed.
std::string scorecard_section(const std::vector<RunData>& runs);

}  // namespace packbed::report
