// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// A validation: a long check against a reference, cut into pieces that run by themselves and leave
/// a table behind. Every program of validation/ makes one and hands it to `validation_main`; what
/// `./packbed validate` asks of a program stands in validation/README.md.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace packbed::validation {

/// Rows of named numbers.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< each as long as `columns`

  /// One column. Throws ValueError if there is none of this name.
  [[nodiscard]] std::vector<double> column(const std::string& name) const;
};

/// A part that takes at most 45 minutes on one core.
struct Piece {
  std::string name;
  std::function<Table()> run;
};

/// One figure against its reference. It fails outside [low, high], and if it is NaN.
struct Check {
  std::string what;
  double measured;
  double low;
  double high;
  std::string reference;  ///< where low and high come from
};

using Results = std::map<std::string, Table>;  ///< by name of the piece

struct Validation {
  std::vector<Piece> pieces;
  std::function<std::vector<Check>(const Results&)> judge;
};

/// `pieces`: prints their names; `files`: nothing; `run PIECE`: its table on standard output; `judge FOLDER`: compares
/// FOLDER/PIECE.csv of all pieces and prints one line per figure. Returns 0, or 1 for a figure
/// outside its limits, or the code of what went wrong.
int validation_main(int argc, char** argv, const Validation& validation);

/// Straight line through points.
struct Line {
  double slope, offset;
};
Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

double mean(const std::vector<double>& values);

}  // namespace packbed::validation
