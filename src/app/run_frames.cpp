// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_frames.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/read_frames.hpp"
#include "setup/read_case.hpp"

namespace packbed::app {
namespace {

/// Rows of the series at which frames were taken. Frames of one instant, of stages that take no time, stand in
/// the order of the rows of that instant.
class RowFinder {
 public:
  explicit RowFinder(const report::Columns& series) : time_(series["time_s"]) {}

  std::size_t row_of(double time) {
    const auto begin =
        static_cast<std::size_t>(std::ranges::lower_bound(time_, time) - time_.begin());
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(time_, time) - time_.begin());
    auto row = std::max(begin, next_);
    if (row >= after) row = std::max<std::size_t>(after, 1) - 1;  // the last one that is not later
    next_ = row + 1;
    return row;
  }

 private:
  const std::vector<double>& time_;
  std::size_t next_ = 0;  ///< first row that no frame has
};

void check(const report::RunData& run) {
  const auto folder = run.folder.string();
  if (!run.was_simulated()) {
    throw DataError(
        fmt::format("{}: this case was only prepared, there is nothing to analyze", folder));
  }
  if (!run.series.has("bed_height_m")) {
    throw DataError(fmt::format(
        "{}: this run has no bed: its column has no floor that beads stand on", folder));
  }
  if (!std::filesystem::exists(run.folder / "frames" / "beads.hdf.series")) {
    throw DataError(fmt::format(
        "{}: this run has no frames; run the case again with frames = true in [output]", folder));
  }
}

/// Paths by numbers.
std::map<std::size_t, std::filesystem::path> files_of(const std::filesystem::path& frames,
                                                      const std::string& name) {
  std::map<std::size_t, std::filesystem::path> files;
  if (!std::filesystem::exists(frames / (name + ".hdf.series"))) return files;
  for (const auto& frame : io::listed_frames(frames, name)) files[frame.number] = frame.file;
  return files;
}

bool one_of(const std::string& name, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

/// Whether the bed is there before the first stage.
bool begins_with_a_bed(const report::RunData& run) {
  const auto& values = run.values;
  return values.contains("/beads/run"_json_pointer) || values.contains("/beads/csv"_json_pointer);
}

}  // namespace

RunFrames read_run_frames(const std::filesystem::path& folder, const UnitSystem& units) {
  RunFrames all{.run = report::read_results(folder, units), .shape = {}, .frames = {}};
  check(all.run);
  all.shape = setup::read_column_shape(all.run.case_text, folder / "case.toml", units);
  const auto frames = folder / "frames";
  const auto contacts = files_of(frames, "contacts");
  const auto liquid = files_of(frames, "liquid");
  const auto& stage = all.run.series["stage"];
  RowFinder rows(all.run.series);
  for (const auto& beads : io::listed_frames(frames, "beads")) {
    const auto with = contacts.find(beads.number);
    if (with == contacts.end()) {
      throw DataError(fmt::format("{}: there are no contacts of this frame; run the case again",
                                  beads.file.string()));
    }
    const auto row = rows.row_of(beads.time);
    RunFrame frame{.number = beads.number,
                   .time = beads.time,
                   .row = row,
                   .stage = static_cast<int>(stage[row]),
                   .ends_stage = row + 1 == stage.size() || stage[row + 1] != stage[row],
                   .beads = beads.file,
                   .contacts = with->second,
                   .liquid = {}};
    if (const auto wet = liquid.find(beads.number); wet != liquid.end()) frame.liquid = wet->second;
    all.frames.push_back(std::move(frame));
  }
  return all;
}

std::vector<RunFrame> frames_at_stage_ends(const RunFrames& all) {
  const auto& height = all.run.series["bed_height_m"];
  std::vector<RunFrame> ends;
  for (const auto& frame : all.frames) {
    if (frame.stage == 0 && !begins_with_a_bed(all.run)) continue;
    if (!(height[frame.row] > 0.0)) continue;
    if (!ends.empty() && ends.back().stage == frame.stage) ends.pop_back();
    ends.push_back(frame);
  }
  return ends;
}

std::string stage_name(const report::RunData& run, int stage) {
  if (stage <= 0) return "start";
  const auto place = static_cast<std::size_t>(stage - 1);
  return place < run.stages.size() ? run.stages[place] : "?";
}

int packing_end(const report::RunData& run) {
  int bed = 0;
  int packed = 0;
  for (int stage = 1; stage <= static_cast<int>(run.stages.size()); ++stage) {
    const auto name = stage_name(run, stage);
    if (one_of(name, {"settle", "tap"})) bed = stage;
    if (one_of(name, {"compress", "relax", "flow_pack", "store"})) packed = stage;
  }
  return packed > 0 ? packed : bed;
}

// A bed that has settled gets its sections after its row: the last ones of an instant count.
std::vector<analysis::Section> sections_at(const report::RunData& run, double time) {
  std::vector<analysis::Section> found;
  if (run.sections.empty()) return found;
  const auto& times = run.sections["time_s"];
  const auto& number = run.sections["section"];
  const auto last = std::ranges::upper_bound(times, time);
  for (auto at = std::ranges::lower_bound(times, time); at != last; ++at) {
    const auto row = static_cast<std::size_t>(at - times.begin());
    if (number[row] == 1.0) found.clear();
    found.push_back({.section = static_cast<int>(number[row]),
                     .z_top = run.sections["z_top_m"][row],
                     .z_bottom = run.sections["z_bottom_m"][row],
                     .height = run.sections["height_m"][row],
                     .compression = run.sections["compression"][row],
                     .packing_density = run.sections["packing_density"][row]});
  }
  return found;
}

std::vector<analysis::Section> sections_after(const report::RunData& run, int stage) {
  const auto& stages = run.series["stage"];
  const auto after = std::ranges::upper_bound(stages, static_cast<double>(stage));
  if (after == stages.begin()) return {};
  return sections_at(run,
                     run.series["time_s"][static_cast<std::size_t>(after - stages.begin() - 1)]);
}

}  // namespace packbed::app
