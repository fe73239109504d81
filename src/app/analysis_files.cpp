// SPDX-License-Identifier: BSD-3-Clause
#include "app/analysis_files.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"

namespace packbed::app {
namespace {

namespace fs = std::filesystem;

/// A cell; empty for what is not known.
std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

fs::path table_file(const fs::path& folder, std::string_view name, std::size_t number) {
  return folder / fmt::format("{}_{:06}.csv", name, number);
}

bool is_ours(const std::string& name) {
  if (name == "analysis.csv" || name == "rearrangement.csv") return true;
  if (!name.ends_with(".csv")) return false;
  for (const auto* begin : {"forces_", "angles_", "stress_", "wall_porosity_", "wall_velocity_"}) {
    const auto digits = name.size() - 4;
    if (name.starts_with(begin) &&
        name.find_first_not_of("0123456789", std::string_view(begin).size()) == digits) {
      return true;
    }
  }
  return false;
}

/// Share of the largest axial stress below which a ratio says nothing: a few beads on top.
constexpr double ratio_limit = 0.01;

std::string forces_text(const analysis::ForceDistribution& forces) {
  std::string text = "force_low,force_high,contacts,density\n";
  for (std::size_t k = 0; k < forces.counts.size(); ++k) {
    text += fmt::format("{},{},{},{}\n", forces.edges[k], forces.edges[k + 1], forces.counts[k],
                        forces.density[k]);
  }
  return text;
}

std::string angles_text(const std::vector<analysis::DirectionBin>& bins) {
  std::string text =
      "angle_low_deg,angle_high_deg,contacts,density,mean_force,largest_force,share_above_3\n";
  for (const auto& b : bins) {
    text += fmt::format("{},{},{},{},{},{},{}\n", b.low, b.high, b.contacts, b.density,
                        b.mean_force, b.largest_force, b.above_share);
  }
  return text;
}

std::string stress_text(const std::vector<analysis::StressBin>& bins) {
  std::string text =
      "z_low_m,z_high_m,stress_xx_Pa,stress_yy_Pa,stress_zz_Pa,stress_xy_Pa,stress_xz_Pa,"
      "stress_yz_Pa,lateral_ratio\n";
  double largest = 0.0;
  for (const auto& b : bins) largest = std::max(largest, b.axial());
  for (const auto& b : bins) {
    const auto& s = b.stress;
    const bool has_ratio = b.axial() > ratio_limit * largest;
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", b.z.low, b.z.high, s.xx, s.yy, s.zz, s.xy,
                        s.xz, s.yz, has_ratio ? cell(b.lateral_ratio()) : "");
  }
  return text;
}

std::string wall_text(const analysis::Profile& profile) {
  std::string text = "wall_distance_low_m,wall_distance_high_m,porosity\n";
  for (std::size_t k = 0; k < profile.size(); ++k) {
    text += fmt::format("{},{},{}\n", profile.edges[k], profile.edges[k + 1], profile.porosity(k));
  }
  return text;
}

std::string velocity_text(const std::vector<analysis::VelocityBin>& bins) {
  std::string text =
      "wall_distance_low_m,wall_distance_high_m,cells,interstitial_velocity_m_s,relative\n";
  for (const auto& b : bins) {
    if (b.cells == 0) continue;
    text += fmt::format("{},{},{},{},{}\n", b.distance.low, b.distance.high, b.cells, b.mean,
                        b.relative);
  }
  return text;
}

}  // namespace

void prepare_analysis_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) {
    throw DataError(
        fmt::format("{}: the folder cannot be made ({})", folder.string(), failed.message()));
  }
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_ours(entry.path().filename().string())) old.push_back(entry.path());
  }
  for (const auto& file : old) {
    if (fs::remove(file, failed) || !failed) continue;
    throw DataError(fmt::format("{}: cannot be taken away ({})", file.string(), failed.message()));
  }
}

void write_frame_tables(const fs::path& folder, std::size_t number, const FrameAnalysis& a) {
  const auto write = [&](std::string_view name, const std::string& text) {
    write_text_file(table_file(folder, name, number), text);
  };
  write("forces", forces_text(a.forces));
  write("angles", angles_text(a.angles));
  if (!a.stress.empty()) write("stress", stress_text(a.stress));
  if (a.wall_porosity) write("wall_porosity", wall_text(*a.wall_porosity));
  if (!a.wall_velocity.empty()) write("wall_velocity", velocity_text(a.wall_velocity));
}

void write_analysis(const fs::path& folder, const std::vector<AnalysisRow>& rows, int packing_end) {
  std::string text = "frame,time_s,stage,stage_name,ends_stage,packing_end";
  for (const auto& column : figure_columns()) text += fmt::format(",{}", column.name);
  text += '\n';
  for (const auto& row : rows) {
    text += fmt::format("{},{},{},{},{},{}", row.frame.number, row.frame.time, row.frame.stage,
                        row.stage_name, row.frame.ends_stage ? 1 : 0, packing_end);
    for (const auto& column : figure_columns())
      text += fmt::format(",{}", cell(row.figures.*column.value));
    text += '\n';
  }
  write_text_file(folder / "analysis.csv", text);
}

void write_rearrangement(const fs::path& folder, const std::vector<RearrangementRow>& rows) {
  if (rows.empty()) return;
  std::string text =
      "from_frame,to_frame,from_time_s,to_time_s,beads,gone,come,lateral_m,vertical_m,lateral_d,"
      "vertical_d,non_affine_m,non_affine_d,left_out,contacts_before,contacts_after,lost,made,"
      "lost_share,made_share\n";
  for (const auto& r : rows) {
    const auto over_d = [&](double length) { return r.diameter > 0.0 ? length / r.diameter : 0.0; };
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.from, r.to,
                    r.from_time, r.to_time, r.beads, r.gone, r.come, r.lateral, r.vertical,
                    over_d(r.lateral), over_d(r.vertical), r.non_affine, over_d(r.non_affine),
                    r.left_out, r.contacts.before, r.contacts.after, r.contacts.lost,
                    r.contacts.made, r.contacts.lost_share, r.contacts.made_share);
  }
  write_text_file(folder / "rearrangement.csv", text);
}

nlohmann::ordered_json to_json(const std::vector<AnalysisRow>& rows, int packing_end) {
  nlohmann::ordered_json json = {{"packing_end", packing_end}};
  auto& list = json["frames"] = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    nlohmann::ordered_json frame{{"frame", row.frame.number},
                                 {"time_s", row.frame.time},
                                 {"stage", row.frame.stage},
                                 {"stage_name", row.stage_name},
                                 {"ends_stage", row.frame.ends_stage}};
    for (const auto& column : figure_columns()) {
      const double value = row.figures.*column.value;
      if (std::isfinite(value)) {
        frame[column.name] = value;
      } else {
        frame[column.name] = nullptr;
      }
    }
    list.push_back(std::move(frame));
  }
  return json;
}

}  // namespace packbed::app
