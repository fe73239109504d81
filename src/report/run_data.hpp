// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What a finished run has left in its folder, as the report needs it. SI inside.

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/quantity.hpp"
#include "report/columns.hpp"
#include "setup/read_measured.hpp"

namespace packbed::report {

using Json = nlohmann::ordered_json;

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The bed at the end of a plateau of the flow. What was not written is NaN.
struct Plateau {
  int stage = 0;
  double time = unknown;                ///< [s]
  double velocity = unknown;            ///< superficial [m/s]
  double pressure_drop = unknown;       ///< of the bed [Pa]
  double frit_pressure_drop = unknown;  ///< of both frits, besides [Pa]
  double pressure_gradient = unknown;   ///< per present bed height [Pa/m]
  double bed_height = unknown;          ///< [m]
  double compression = unknown;
  double pressure_noise = unknown;  ///< standard deviation over mean of the pressure drop
  bool steady = true;
};

/// A table over slices of the bed.
struct Profile {
  int number = 0;  ///< of the stage or of the plateau, from 1
  Columns table;
};

// NOLINTNEXTLINE(bugprone-exception-escape): the JSON type may throw where it is moved, says the tool.
struct RunData {
  std::filesystem::path folder;
  std::string label;  ///< how the run is called on the page
  Json summary;       ///< summary.json
  Json values;        ///< case.toml as JSON
  std::string case_text;
  std::vector<std::string> stages;  ///< kind of each stage, "settle"; stage 1 comes first
  Columns series;
  Columns sections;
  std::vector<Plateau> plateaus;
  std::vector<Profile> porosity_z;      ///< at ends of stages
  std::vector<Profile> porosity_wall;   ///< over the distance from the wall, at ends of stages
  std::vector<Profile> plateau_z;       ///< at ends of plateaus
  std::vector<Profile> plateau_across;  ///< over x or radius
  std::string across;                   ///< "x" or "radius"
  std::optional<setup::MeasuredFlow> measured;
  Columns analysis;             ///< analysis.csv, texts: names of stages; empty if it was not made
  std::vector<Profile> forces;  ///< P(F/<F>); these are numbered by frames
  std::vector<Profile> angles;  ///< where contacts point
  std::vector<Profile> stress;  ///< over the height
  std::vector<Profile> wall_velocity;  ///< over the distance from the wall

  [[nodiscard]] bool was_simulated() const { return !series.empty(); }
  /// A number of the summary by its JSON pointer, such as "/figures/liquid/viscosity_Pa_s"; none if it is not there.
  [[nodiscard]] std::optional<double> number(const std::string& pointer) const;
  [[nodiscard]] std::string title() const;
  /// Warnings of the run, and of plateaus that were not steady.
  [[nodiscard]] std::vector<std::string> warnings() const;
};

/// Reads the folder of a run. Throws DataError, on one line, for a folder that is not there, a run that has
/// not ended, a file that is missing or damaged.
RunData read_run(const std::filesystem::path& folder, const UnitSystem& units);
/// The same without what `packbed analyze` has added.
RunData read_results(const std::filesystem::path& folder, const UnitSystem& units);

/// Gives runs labels that tell them apart: their titles, else the names of their folders, else the whole paths.
void tell_apart(std::vector<RunData>& runs);

/// Plateaus of a run that has no plateaus.csv: rows after which a flow that stood still in a stage changes.
std::vector<Plateau> plateaus_of_series(const Columns& series);

}  // namespace packbed::report
