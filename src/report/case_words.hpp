// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/quantity.hpp"
#include "report/run_data.hpp"

namespace packbed::report {

/// A step of the protocol in words, and the steps that it repeats.
struct Sentence {
  std::string text;
  std::vector<Sentence> parts = {};
};

/// One line of the case: "Resin", "CM Sepharose 6FF, ...".
struct CaseLine {
  std::string name;
  std::string text;
};

/// Column, resin, liquid and numerics of a run in words, lengths in mm and um, flows in cm/h.
std::vector<CaseLine> case_lines(const RunData& run, const UnitSystem& units);

std::vector<Sentence> protocol_sentences(const RunData& run, const UnitSystem& units);

/// A value that is not the same in all cases.
struct Difference {
  std::string key;                  ///< "resin.friction"
  std::vector<std::string> values;  ///< one per run; empty where the case does not have it
};
/// Whether the protocols have the same kinds of steps, one by one.
bool have_same_steps(const std::vector<RunData>& runs);
/// Titles and outputs left out, and protocols of other steps, which do not compare key by key.
std::vector<Difference> differences(const std::vector<RunData>& runs);

}  // namespace packbed::report
