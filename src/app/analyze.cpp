// SPDX-License-Identifier: BSD-3-Clause
#include "app/analyze.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "core/error.hpp"

namespace packbed::app {
namespace {

/// Displacements over periodic sides are the shortest ones.
Vec3 period_of(const mesh::ColumnShape& shape) {
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) return {0.0, slice->depth, 0.0};
  const auto* box = std::get_if<mesh::Box>(&shape);
  if (box == nullptr) return {};
  const auto along = [&](std::size_t axis) {
    return box->boundaries[axis] == mesh::Boundary::periodic ? box->size[axis] : 0.0;
  };
  return {along(0), along(1), along(2)};
}

/// What the analyses refuse is damage of this frame.
FrameAnalysis analyzed(const RunFrames& run,
                       const BedFrame& bed,
                       const std::vector<analysis::Section>& initial) {
  try {
    return analyze_frame(run, bed, initial);
  } catch (const ValueError& error) {
    throw DataError(
        fmt::format("{}: it cannot be analyzed ({})", bed.place.beads.string(), error.what()));
  }
}

RearrangementRow rearrangement(const BedFrame& before,
                               const BedFrame& after,
                               const mesh::ColumnShape& shape) {
  const auto moved = analysis::displacements(before.beads, after.beads, period_of(shape));
  const auto wandering = analysis::wandering(moved, 10);
  const auto non_affine = analysis::non_affine_motion(moved, before.contacts);
  return {.from = before.place.number,
          .to = after.place.number,
          .from_time = before.place.time,
          .to_time = after.place.time,
          .diameter = before.diameter,
          .beads = static_cast<std::int64_t>(moved.beads.size()),
          .gone = moved.gone,
          .come = moved.come,
          .lateral = wandering.lateral,
          .vertical = wandering.vertical,
          .non_affine = std::sqrt(non_affine.mean_square),
          .left_out = non_affine.left_out,
          .contacts = analysis::contact_changes(analysis::touching_pairs(before.contacts),
                                                analysis::touching_pairs(after.contacts))};
}

std::vector<RunFrame> chosen_frames(const AnalyzeCommand& command, const RunFrames& run) {
  auto frames = command.all || command.frame >= 0 ? run.frames : frames_at_stage_ends(run);
  if (command.frame >= 0) {
    std::erase_if(frames, [&](const RunFrame& f) {
      return f.number != static_cast<std::size_t>(command.frame);
    });
    if (frames.empty()) {
      throw ConfigError(fmt::format(
          "{}: there is no frame {}; the last one is {}", command.run.string(), command.frame,
          run.frames.empty() ? -1 : static_cast<int>(run.frames.back().number)));
    }
  }
  if (frames.empty()) {
    throw DataError(fmt::format("{}: there is no frame of a bed; --all takes all frames",
                                command.run.string()));
  }
  return frames;
}

std::string printed(double value, double factor, const char* form) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(form), factor * value) : "-";
}

void print(const RunAnalysis& analysis, const RunFrames& run) {
  fmt::print("{:>6} {:>5} {:<10} {:>9} {:>7} {:>7} {:>9} {:>8} {:>11} {:>11} {:>8} {:>9} {:>8}\n",
             "frame", "stage", "", "bed", "S_mean", "S_init", "<F>", ">6<F>", "stress top",
             "bottom", "IPD", "sigma_z2", "overlap");
  fmt::print("{:>6} {:>5} {:<10} {:>9} {:>7} {:>7} {:>9} {:>8} {:>11} {:>11} {:>8} {:>9} {:>8}\n",
             "", "", "", "[mm]", "", "", "[uN]", "[%]", "[kPa]", "[kPa]", "[d]", "[cm2/s2]", "[%]");
  for (const auto& row : analysis.rows) {
    const auto& f = row.figures;
    fmt::print("{:>6} {:>5} {:<10} {:>9} {:>7} {:>7} {:>9} {:>8} {:>11} {:>11} {:>8} {:>9} {:>8}\n",
               row.frame.number, row.frame.stage, row.stage_name,
               printed(f.bed_height, 1e3, "{:.3f}"), printed(f.s_mean, 1.0, "{:.4f}"),
               printed(f.s_init, 1.0, "{:.4f}"), printed(f.mean_force, 1e6, "{:.4g}"),
               printed(f.share_above_6, 100.0, "{:.3g}"), printed(f.stress_top, 1e-3, "{:.4g}"),
               printed(f.stress_bottom, 1e-3, "{:.4g}"), printed(f.ipd_absolute_d, 1.0, "{:.3f}"),
               printed(f.velocity_variance, 1e4, "{:.4g}"),
               printed(f.largest_overlap, 100.0, "{:.1f}"));
  }
  fmt::print("S_init is taken against the end of stage {} ({}).", analysis.packing_end,
             stage_name(run.run, analysis.packing_end));
  const double ratio = analysis.rows.front().figures.d_over_d_eff;
  if (std::isfinite(ratio)) {
    fmt::print(" IPD and sigma_z2 depend on the width of the column in grains: D/d = {:.1f}.",
               ratio);
  }
  fmt::print("\n");
  if (analysis.has_stress) return;
  fmt::print(
      "No stresses: these frames are of a version of packbed that did not write the direction of "
      "tangential forces; run the case again for them.\n");
}

}  // namespace

RunAnalysis analyze_frames(const RunFrames& run,
                           const std::vector<RunFrame>& frames,
                           const std::filesystem::path& output) {
  RunAnalysis found{.rows = {}, .packing_end = packing_end(run.run)};
  const auto initial = sections_after(run.run, found.packing_end);
  std::vector<RearrangementRow> moves;
  std::optional<BedFrame> before;
  prepare_analysis_folder(output);
  for (const auto& frame : frames) {
    auto bed = read_frame(frame);
    const auto analysis = analyzed(run, bed, initial);
    write_frame_tables(output, frame.number, analysis);
    found.rows.push_back({.frame = frame,
                          .stage_name = stage_name(run.run, frame.stage),
                          .figures = analysis.figures});
    if (bed.tangential.empty() && !bed.contacts.empty()) found.has_stress = false;
    if (before) moves.push_back(rearrangement(*before, bed, run.shape));
    before = std::move(bed);
  }
  write_rearrangement(output, moves);
  write_analysis(output, found.rows, found.packing_end);
  return found;
}

void analyze_ended_run(const std::filesystem::path& folder, const UnitSystem& units) {
  if (!report::read_results(folder, units).series.has("bed_height_m")) return;
  const auto run = read_run_frames(folder, units);
  const auto frames = frames_at_stage_ends(run);
  if (!frames.empty()) static_cast<void>(analyze_frames(run, frames, folder / "analysis"));
}

int analyze(const AnalyzeCommand& command) {
  const UnitSystem units;
  const auto run = read_run_frames(command.run, units);
  const auto output = command.output.empty() ? command.run / "analysis" : command.output;
  const auto analysis = analyze_frames(run, chosen_frames(command, run), output);
  if (command.json) {
    fmt::print("{}", json_text(to_json(analysis.rows, analysis.packing_end)));
    return 0;
  }
  print(analysis, run);
  fmt::print("Written in {}: analysis.csv, {}tables of each frame\n", output.string(),
             analysis.rows.size() > 1 ? "rearrangement.csv, " : "");
  return 0;
}

}  // namespace packbed::app
