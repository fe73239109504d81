// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Parts of the page that are tables, as HTML. Texts of runs are escaped here.

#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace packbed::report {

/// A part of the page under a heading; `body` is HTML.
std::string section(const std::string& id, const std::string& title, const std::string& body);

/// Key figures of several runs, one column each.
std::string figure_table(const std::vector<RunData>& runs);

/// Values of the cases that are not the same in all of them.
std::string difference_table(const std::vector<RunData>& runs);

/// Wall times of the stages with bars; empty where the run did not write them.
std::string times_table(const RunData& run);

}  // namespace packbed::report
