// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Everything that a run writes while it is under way, but checkpoints: rows of CSV files, profiles
/// and frames. All ranks call; the first one writes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/bed_height.hpp"
#include "analysis/sections.hpp"
#include "app/frame_writer.hpp"
#include "app/plateau_outputs.hpp"
#include "column/coupled_bed.hpp"
#include "dem/dem.hpp"
#include "io/series.hpp"
#include "setup/case.hpp"

namespace packbed::app {

/// Figures of the last row, and largest ones so far.
struct RowFigures {
  double kinetic_to_elastic = 0.0;
  double unbalanced_force = 0.0;   ///< mean unbalanced / mean contact force
  double max_overlap_ratio = 0.0;  ///< largest of all rows
  double coordination_number = 0.0;
  double floor_force = 0.0;       ///< downwards, of the beads on the floor [N]
  double wall_shear = 0.0;        ///< downwards, of the beads on walls that stand [N]
  double budget_error = 0.0;      ///< 1 - (floor force + wall shear) / (weight + pressure force)
  analysis::BedFigures bed;       ///< where there is a floor
  double settled_height = 0.0;    ///< H0, at the end of the last settling; 0 before [m]
  double settled_porosity = 0.0;  ///< of the middle half then
  /// The plunger, in cases that move it.
  struct Plunger {
    double position = 0.0;  ///< of its face [m]
    double force = 0.0;     ///< of the beads on it, upwards [N]
  } plunger{};
  column::LiquidFigures liquid;
  /// The last row of those with the highest flow.
  struct Flow {
    double velocity = 0.0;       ///< superficial [m/s]
    double pressure_drop = 0.0;  ///< [Pa]
    double bed_height = 0.0;     ///< [m]
  } highest_flow;

  /// Of the bed against its settled height; nothing before the first settling, or without a bed.
  [[nodiscard]] std::optional<double> compression() const {
    if (settled_height <= 0.0) return {};
    return (settled_height - bed.height) / settled_height;
  }
};

class Outputs {
 public:
  /// Starts the files in `folder`, or goes on with those that `saved` (from save()) tells of: what was
  /// written after it is cut off.
  Outputs(const setup::Case& c,
          const std::filesystem::path& folder,
          const dem::Dem& dem,
          const nlohmann::ordered_json* saved);

  /// A row of every series; frames too if they are due by time. `liquid` where there is a flow. `stage` from 1, 0 at the start.
  void row(const dem::Dem& dem, const column::CoupledBed* liquid, std::int64_t stage);
  /// A plateau that ended with the last row.
  void plateau(const column::Plateau& plateau,
               const column::CoupledBed& liquid,
               std::int64_t stage) {
    plateaus_->write(plateau, figures_, liquid, stage);
  }
  /// What is written at the start and at the end of a stage, after its row.
  void stage_end(const dem::Dem& dem, const column::CoupledBed* liquid, std::int64_t stage);
  /// The bed as it is now is the settled one: heights and sections are compared with it from now on.
  void set_settled(const dem::Dem& dem);
  /// The settled bed that another run knew, from its save(): compared with from now on. Nothing if it knew none.
  void take_settled(const nlohmann::ordered_json& saved);

  /// How far the files go. Numbers come back to the last bit.
  [[nodiscard]] nlohmann::ordered_json save() const;

  [[nodiscard]] const RowFigures& figures() const { return figures_; }

 private:
  void load(const nlohmann::ordered_json& saved);
  void write_row(const dem::Dem& dem, const dem::Sums& s, std::int64_t stage);
  void open_sections();
  void write_sections(const dem::Dem& dem);
  void write_profiles(const dem::Dem& dem, std::int64_t stage) const;
  void write_bead_csv(const dem::Snapshot& s);
  [[nodiscard]] std::filesystem::path bead_csv_file(std::int64_t k) const;

  const setup::Case& case_;
  std::filesystem::path folder_;
  std::vector<std::string> columns_;
  bool has_bed_;  ///< a floor
  bool has_liquid_;
  bool has_plunger_;  ///< one that moves
  std::optional<io::SeriesWriter> series_;
  std::optional<io::SeriesWriter> sections_;
  std::optional<PlateauOutputs> plateaus_;
  std::optional<FrameWriter> frames_;
  std::optional<analysis::SectionReference> reference_;
  std::int64_t bead_csv_files_ = 0;
  std::int64_t frames_by_time_ =
      1;  ///< multiples of the interval that have had theirs; that of 0 is the start
  RowFigures figures_;
};

}  // namespace packbed::app
