// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Parts of the page that are tables, as HTML. Texts of runs are escaped here.

#include <string>
#include <vector>

#include "report/case_words.hpp"

namespace packbed::report {

/// A part of the page under a heading; `body` is HTML.
std::string section(const std::string& id, const std::string& title, const std::string& body);

/// Key figures of several runs, one column each.
std::string figure_table(const std::vector<RunData>& runs);

/// Steps of a protocol as a list with numbers.
std::string steps_list(const std::vector<Sentence>& sentences);

/// Values of the cases that are not the same in all of them; protocols of other steps side by side, in words.
std::string difference_table(const std::vector<RunData>& runs, const UnitSystem& units);

/// Wall times of the stages with bars; empty where the run did not write them.
std::string times_table(const RunData& run);

}  // namespace packbed::report
