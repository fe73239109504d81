// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A case and its figures for people and for programs.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "setup/case.hpp"
#include "setup/case_figures.hpp"

namespace packbed::setup {

/// The case with every value filled in, as a case file that reads back to the same values, its
/// figures as comments above it.
std::string check_text(const Case& c, const CaseFigures& f);

/// {"case": {...}, "figures": {...}}, numbers in SI, units in the keys.
nlohmann::ordered_json check_json(const Case& c, const CaseFigures& f);

nlohmann::ordered_json figures_json(const Case& c, const CaseFigures& f);

}  // namespace packbed::setup
