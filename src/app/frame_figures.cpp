// SPDX-License-Identifier: BSD-3-Clause
#include "app/frame_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/bed_height.hpp"
#include "analysis/coordination.hpp"
#include "analysis/overlap_figures.hpp"
#include "analysis/porosity_deviation.hpp"
#include "analysis/slots.hpp"
#include "analysis/void_sizes.hpp"
#include "io/read_frames.hpp"

namespace packbed::app {
namespace {

constexpr FigureColumn columns[] = {
    {"superficial_velocity_m_s", &FrameFigures::superficial_velocity},
    {"pressure_drop_Pa", &FrameFigures::pressure_drop},
    {"bed_height_m", &FrameFigures::bed_height},
    {"compression", &FrameFigures::compression},
    {"mean_porosity", &FrameFigures::mean_porosity},
    {"S_mean", &FrameFigures::s_mean},
    {"S_init", &FrameFigures::s_init},
    {"coordination", &FrameFigures::coordination},
    {"coordination_without_rattlers", &FrameFigures::coordination_without_rattlers},
    {"rattler_share", &FrameFigures::rattler_share},
    {"mean_force_N", &FrameFigures::mean_force},
    {"share_above_6", &FrameFigures::share_above_6},
    {"strong_load", &FrameFigures::strong_load},
    {"tail_slope", &FrameFigures::tail_slope},
    {"fabric_anisotropy", &FrameFigures::fabric_anisotropy},
    {"force_anisotropy", &FrameFigures::force_anisotropy},
    {"axial_to_lateral", &FrameFigures::axial_to_lateral},
    {"stress_top_Pa", &FrameFigures::stress_top},
    {"stress_middle_Pa", &FrameFigures::stress_middle},
    {"stress_bottom_Pa", &FrameFigures::stress_bottom},
    {"lateral_ratio", &FrameFigures::lateral_ratio},
    {"wall_share", &FrameFigures::wall_share},
    {"bulk_porosity", &FrameFigures::bulk_porosity},
    {"IPD_signed_m", &FrameFigures::ipd_signed},
    {"IPD_absolute_m", &FrameFigures::ipd_absolute},
    {"IPD_signed_d", &FrameFigures::ipd_signed_d},
    {"IPD_absolute_d", &FrameFigures::ipd_absolute_d},
    {"sigma_z2_m2_s2", &FrameFigures::velocity_variance},
    {"velocity_variation", &FrameFigures::velocity_variation},
    {"granular_temperature_m2_s2", &FrameFigures::granular_temperature},
    {"mean_overlap", &FrameFigures::mean_overlap},
    {"largest_overlap", &FrameFigures::largest_overlap},
    {"overlaps_above_0.1", &FrameFigures::large_overlaps},
    {"overlaps_above_0.2", &FrameFigures::very_large_overlaps},
    {"void_d10_m", &FrameFigures::void_d10},
    {"void_d50_m", &FrameFigures::void_d50},
    {"D_over_d_eff", &FrameFigures::d_over_d_eff}};

// Widths in mean diameters of grains.
constexpr double slab_width = 2.0;            ///< of stresses and motions
constexpr double bulk_from = 4.0;             ///< distance from the wall; thesis section 10.2.2
constexpr double stress_multiple = 6.0;       ///< thesis section 10.2.1
constexpr double end_share = 0.1;             ///< of the bed, whose stress is that of an end
constexpr std::int64_t void_points = 20'000;  ///< of which four in ten lie in voids

/// Width of the column between its side walls; 0 where there are none [m].
double width_between_walls(const mesh::ColumnShape& shape) {
  if (const auto* box = std::get_if<mesh::Box>(&shape)) {
    for (const std::size_t axis : {0, 1}) {
      if (box->boundaries[axis] == mesh::Boundary::wall) return box->size[axis];
    }
    return 0.0;
  }
  if (const auto* slice = std::get_if<mesh::Slice>(&shape)) return slice->inner_diameter;
  return std::get<mesh::Cylinder>(shape).inner_diameter;
}

double cell_of(const report::Columns& series, const char* name, std::size_t row) {
  return series.has(name) ? series[name][row] : report::unknown;
}

void add_series(FrameFigures& f, const report::Columns& series, std::size_t row) {
  f.superficial_velocity = cell_of(series, "superficial_velocity_m_s", row);
  f.pressure_drop = cell_of(series, "pressure_drop_Pa", row);
  f.bed_height = cell_of(series, "bed_height_m", row);
  f.compression = cell_of(series, "compression", row);
  f.mean_porosity = cell_of(series, "mean_porosity", row);
  const double floor = cell_of(series, "floor_force_N", row);
  const double shear = cell_of(series, "wall_shear_N", row);
  if (floor + shear != 0.0) f.wall_share = shear / (floor + shear);
}

void add_sections(FrameFigures& f,
                  std::span<const analysis::Section> sections,
                  std::span<const analysis::Section> initial) {
  if (sections.empty()) return;
  f.s_mean = analysis::density_spread(sections);
  if (sections.size() == initial.size()) f.s_init = analysis::density_change(sections, initial);
}

/// Contacts that hold a bead of this case.
int holding_contacts(const report::RunData& run) {
  const report::Json& values = run.values;
  const double friction = values.value("/resin/friction"_json_pointer, 0.0);
  return friction > 0.0 ? analysis::holding_with_friction : analysis::holding_frictionless;
}

void add_contacts(FrameFigures& f, const BedFrame& frame, int holding) {
  const auto& contacts = frame.contacts;
  const auto beads = static_cast<std::int64_t>(frame.beads.size());
  const auto pairs = analysis::touching_pairs(contacts);
  const auto coordination = analysis::coordination(pairs, beads, holding);
  f.coordination = coordination.mean;
  f.coordination_without_rattlers = coordination.mean_without_rattlers;
  f.rattler_share = static_cast<double>(coordination.rattlers) / static_cast<double>(beads);
  const auto overlaps = analysis::overlap_figures(frame.beads, contacts);
  f.mean_overlap = overlaps.mean;
  f.largest_overlap = overlaps.largest;
  f.large_overlaps = overlaps.large_share;
  f.very_large_overlaps = overlaps.very_large_share;
  if (std::ranges::none_of(contacts, analysis::pushes)) return;
  f.mean_force = analysis::mean_force(contacts);
  f.share_above_6 = analysis::share_above(contacts, stress_multiple);
  f.strong_load = analysis::force_networks(contacts).strong_load;
  f.tail_slope = analysis::force_tail(contacts).slope;
  const auto fabric = analysis::fabric(contacts);
  f.fabric_anisotropy = analysis::anisotropy(fabric.contacts);
  f.force_anisotropy = analysis::anisotropy(fabric.forces);
  f.axial_to_lateral = fabric.axial_to_lateral();
}

void add_stress(FrameAnalysis& a,
                const BedFrame& frame,
                std::span<const double> edges,
                double area) {
  if (frame.tangential.empty() && !frame.contacts.empty()) return;
  a.stress = analysis::stress_profile(frame.contacts, frame.tangential, edges, area);
  const double height = edges.back();
  const std::array thirds = {0.0, end_share * height, (1.0 - end_share) * height, height};
  const auto ends = analysis::stress_profile(frame.contacts, frame.tangential, thirds, area);
  a.figures.stress_bottom = ends[0].axial();
  a.figures.stress_middle = ends[1].axial();
  a.figures.stress_top = ends[2].axial();
  if (ends[1].axial() > 0.0) a.figures.lateral_ratio = ends[1].lateral_ratio();
}

/// Over the middle half of the bed; the deviation over the whole width, both walls.
void add_wall(FrameAnalysis& a, const BedFrame& frame, const mesh::ColumnShape& shape) {
  const double width = width_between_walls(shape);
  if (width == 0.0) return;
  auto& f = a.figures;
  const double d = frame.diameter;
  f.d_over_d_eff = width / d;
  a.wall_porosity = analysis::wall_profile(
      frame.beads, shape,
      {.width = analysis::deviation_bin * d, .z = analysis::middle_half(f.bed_height)},
      Ranks::alone());
  const auto deviation = analysis::wall_deviation(*a.wall_porosity, d);
  f.bulk_porosity = deviation.bulk;
  f.ipd_signed = deviation.across.with_sign;
  f.ipd_absolute = deviation.across.absolute;
  f.ipd_signed_d = deviation.across_in_diameters.with_sign;
  f.ipd_absolute_d = deviation.across_in_diameters.absolute;
}

void add_liquid(FrameAnalysis& a, const BedFrame& frame, const mesh::ColumnShape& shape) {
  if (frame.liquid.empty()) return;
  const auto variance = analysis::velocity_variance(frame.liquid, {0.0, a.figures.bed_height});
  a.figures.velocity_variance = variance.variance;
  if (a.figures.superficial_velocity == 0.0) return;  // what still moves there has no bulk
  if (variance.mean != 0.0) a.figures.velocity_variation = variance.variation;
  const double width = width_between_walls(shape);
  if (width == 0.0) return;
  double volume = 0.0;
  for (const auto& cell : frame.liquid) volume += cell.volume;
  const double cell = std::cbrt(volume / static_cast<double>(frame.liquid.size()));
  const auto edges = analysis::even_edges(0.0, 0.5 * width, std::max(cell, frame.diameter));
  a.wall_velocity = analysis::velocity_profile(
      frame.liquid, shape, edges,
      {.z = analysis::middle_half(a.figures.bed_height), .inner = bulk_from * frame.diameter});
}

void add_voids(FrameFigures& f, const BedFrame& frame, const mesh::ColumnShape& shape) {
  if (f.bed_height <= 3.0 * frame.diameter) return;
  const auto voids = analysis::void_sizes(
      frame.beads, shape,
      {.z = {frame.diameter, f.bed_height - frame.diameter}, .points = void_points});
  f.void_d10 = voids.d10;
  f.void_d50 = voids.d50;
}

analysis::ContactForce contact_of(const io::ContactLine& c) {
  return {.i = c.id_i,
          .j = c.id_j,
          .x = c.from,
          .branch = c.to - c.from,
          .normal = c.normal_force,
          .tangential = c.tangential_force,
          .overlap = c.overlap};
}

}  // namespace

std::span<const FigureColumn> figure_columns() { return columns; }

BedFrame read_frame(const RunFrame& frame) {
  BedFrame bed;
  bed.place = frame;
  const auto beads = io::read_bead_frame(frame.beads);
  double sum = 0.0;
  for (std::size_t i = 0; i < beads.x.size(); ++i) {
    bed.beads.push_back({.x = beads.x[i], .radius = beads.radius[i], .id = beads.id[i]});
    bed.motion.push_back({.x = beads.x[i], .v = beads.velocity[i]});
    sum += 2.0 * beads.radius[i];
  }
  bed.diameter = bed.beads.empty() ? 0.0 : sum / static_cast<double>(bed.beads.size());
  const auto contacts = io::read_contact_frame(frame.contacts);
  for (const auto& c : contacts.contacts) {
    bed.contacts.push_back(contact_of(c));
    if (contacts.has_tangential_vectors) bed.tangential.push_back(c.tangential);
  }
  if (!frame.liquid) return bed;
  const auto liquid = io::read_liquid_frame(*frame.liquid);
  for (std::size_t c = 0; c < liquid.volume.size(); ++c) {
    bed.liquid.push_back({.x = liquid.center[c],
                          .volume = liquid.volume[c],
                          .eps = liquid.void_fraction[c],
                          .u_z = -liquid.velocity[c].z});  // downwards, as in all tables
  }
  return bed;
}

FrameAnalysis analyze_frame(const RunFrames& run,
                            const BedFrame& frame,
                            std::span<const analysis::Section> initial) {
  FrameAnalysis a;
  auto& f = a.figures;
  add_series(f, run.run.series, frame.place.row);
  add_sections(f, sections_at(run.run, frame.place.time), initial);
  a.forces = analysis::force_distribution(frame.contacts);
  a.angles = analysis::force_directions(frame.contacts);
  if (frame.beads.empty() || !(f.bed_height > 0.0)) return a;
  add_contacts(f, frame, holding_contacts(run.run));
  const auto edges = analysis::even_edges(0.0, f.bed_height, slab_width * frame.diameter);
  f.granular_temperature = analysis::granular_temperature(frame.motion, edges).mean;
  add_stress(a, frame, edges, mesh::cross_section(run.shape));
  add_wall(a, frame, run.shape);
  add_liquid(a, frame, run.shape);
  add_voids(f, frame, run.shape);
  return a;
}

}  // namespace packbed::app
