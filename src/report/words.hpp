// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Values of a case file as a page tells them. For the sources of case_words.hpp alone.

#include <string>

#include "core/quantity.hpp"
#include "report/run_data.hpp"

namespace packbed::report {

/// A value of the case file as text; empty if it is not there.
std::string text(const Json& values, const char* pointer);
/// "3 mm", "90 um". Words such as "auto" stay as they are, here and below.
std::string length(const std::string& words, const UnitSystem& units);
/// "553 cm/h".
std::string flow(const std::string& words, const UnitSystem& units);
/// In SI, written by `write`; the words if they are no such quantity.
std::string in_si(const std::string& words,
                  Dimension dimension,
                  const UnitSystem& units,
                  std::string (*write)(double));

}  // namespace packbed::report
