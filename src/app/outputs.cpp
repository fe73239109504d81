// SPDX-License-Identifier: BSD-3-Clause
#include "app/outputs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "analysis/profile.hpp"
#include "app/stages.hpp"
#include "column/plunger.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "io/bead_csv.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> section_columns = {
    "time_s", "section", "z_top_m", "z_bottom_m", "height_m", "compression", "packing_density"};

/// Ratio of two sums that may both be zero.
double ratio(double a, double b) { return b > 0.0 ? a / b : 0.0; }

std::array<double, 3> as_array(const Vec3& a) { return {a.x, a.y, a.z}; }

std::vector<std::string> columns(const dem::Dem& dem,
                                 bool has_bed,
                                 bool has_liquid,
                                 bool has_plunger) {
  std::vector<std::string> names = {"time_s", "step", "stage"};
  if (has_liquid) {
    names.insert(names.end(),
                 {"superficial_velocity_m_s", "pressure_drop_Pa", "frit_pressure_drop_Pa",
                  "liquid_wall_shear_N", "continuity_error", "courant", "largest_solid_fraction"});
  }
  if (has_bed) {
    names.insert(names.end(), {"bed_height_m", "compression", "mean_porosity", "middle_porosity",
                               "floor_force_N", "wall_shear_N", "budget_error"});
  }
  if (has_plunger) {
    names.insert(names.end(), {"plunger_position_m", "plunger_compression", "plunger_force_N",
                               "plunger_pressure_Pa"});
  }
  names.insert(names.end(), {"mean_overlap_m", "max_overlap_ratio", "coordination_number",
                             "kinetic_energy_J", "elastic_energy_J", "kinetic_to_elastic",
                             "unbalanced_force", "bead_step_s", "particles"});
  for (const auto& wall : dem.walls()) {
    for (const char axis : {'x', 'y', 'z'}) {
      names.push_back(fmt::format("{}_f{}_N", wall.name, axis));
    }
  }
  return names;
}

void check_finite(const dem::Dem& dem, const dem::Sums& s) {
  if (std::isfinite(s.kinetic_energy) && std::isfinite(s.elastic_energy)) return;
  throw DivergenceError(fmt::format(
      "step {}, time {:.6g} s: the energy of the beads is not a finite number; start them "
      "slower, or take a smaller step",
      dem.steps(), s.time));
}

/// What carries the weight of the bed, downwards [N].
struct Support {
  double floor = 0.0;  ///< force on the floor
  double shear = 0.0;  ///< vertical force on walls that stand
  double load = 0.0;   ///< weight of the beads, and what the lid adds
};

Support support_of(const dem::Dem& dem, const dem::Sums& s) {
  Support support;
  for (std::size_t w = 0; w < s.wall_force.size(); ++w) {
    const auto& name = dem.walls()[w].name;
    const double down = -s.wall_force[w].z;
    (name == "floor" ? support.floor : name == "lid" ? support.load : support.shear) += down;
  }
  support.load = s.weight - support.load;
  return support;
}

RowFigures::Plunger plunger_of(const dem::Dem& dem, const dem::Sums& s) {
  for (std::size_t w = 0; w < s.wall_force.size(); ++w) {
    if (dem.walls()[w].name != "lid") continue;
    return {.position = column::plunger_position(dem.walls()).value_or(column::lid_away),
            .force = s.wall_force[w].z};
  }
  return {};
}

/// Share of a mean diameter that bins of profiles are wide.
constexpr double bin_of_diameter = 0.1;

double mean_diameter(const std::vector<analysis::Bead>& beads, const Ranks& ranks) {
  std::array<std::int64_t, 2> sums = {static_cast<std::int64_t>(beads.size()), 0};
  for (const auto& bead : beads) sums[1] += std::llround(2e12 * bead.radius);  // pm
  ranks.sum(sums);
  return 1e-12 * static_cast<double>(sums[1]) /
         static_cast<double>(std::max<std::int64_t>(sums[0], 1));
}

std::string profile_text(const analysis::Profile& profile, std::string_view coordinate) {
  auto text = fmt::format("{0}_low_m,{0}_high_m,porosity\n", coordinate);
  for (std::size_t k = 0; k < profile.size(); ++k) {
    text += fmt::format("{},{},{}\n", profile.edges[k], profile.edges[k + 1], profile.porosity(k));
  }
  return text;
}

Json to_json(const analysis::SectionReference& reference) {
  Json tracers = Json::array();
  for (const auto& t : reference.tracers) tracers.push_back({t.id, t.boundary, t.offset});
  return {{"boundaries", reference.boundaries}, {"tracers", tracers}};
}

analysis::SectionReference section_reference_from(const Json& saved) {
  analysis::SectionReference reference;
  reference.boundaries = saved.at("boundaries").get<std::vector<double>>();
  for (const auto& t : saved.at("tracers")) reference.tracers.push_back({t[0], t[1], t[2]});
  return reference;
}

Json to_json(const RowFigures& f) {
  return {f.kinetic_to_elastic,      f.unbalanced_force,      f.max_overlap_ratio,
          f.coordination_number,     f.budget_error,          f.bed.height,
          f.bed.mean_porosity,       f.bed.middle_porosity,   f.settled_height,
          f.settled_porosity,        f.highest_flow.velocity, f.highest_flow.pressure_drop,
          f.highest_flow.bed_height, f.plunger.position,      f.plunger.force};
}

RowFigures row_figures_from(const Json& saved) {
  return {.kinetic_to_elastic = saved[0],
          .unbalanced_force = saved[1],
          .max_overlap_ratio = saved[2],
          .coordination_number = saved[3],
          .budget_error = saved[4],
          .bed = {.height = saved[5], .mean_porosity = saved[6], .middle_porosity = saved[7]},
          .settled_height = saved[8],
          .settled_porosity = saved[9],
          .plunger = {saved[13], saved[14]},
          .liquid = {},
          .highest_flow = {saved[10], saved[11], saved[12]}};
}

}  // namespace

Outputs::Outputs(const setup::Case& c,
                 const std::filesystem::path& folder,
                 const dem::Dem& dem,
                 const Json* saved)
    : case_(c),
      folder_(folder),
      has_bed_(std::ranges::any_of(dem.walls(), [](const auto& w) { return w.name == "floor"; })),
      has_liquid_(has_flow(c)),
      has_plunger_(any_plunger(c)) {
  columns_ = columns(dem, has_bed_, has_liquid_, has_plunger_);
  if (dem.ranks().is_first() && c.output.beads_csv) {
    std::filesystem::create_directories(folder / "frames");
  }
  if (saved != nullptr) {
    load(*saved);
    return;
  }
  if (dem.ranks().is_first()) series_.emplace(folder / "series.csv", columns_);
  plateaus_.emplace(folder);
  if (c.output.frames) frames_.emplace(folder / "frames");
}

void Outputs::row(const dem::Dem& dem, const column::CoupledBed* liquid, std::int64_t stage) {
  const auto s = dem.sums();
  check_finite(dem, s);
  if (has_bed_) {
    figures_.bed = analysis::bed_figures(analysis::own_beads(dem.particles()),
                                         mesh::cross_section(case_.column.shape), dem.ranks());
  }
  figures_.liquid = liquid != nullptr ? liquid->figures() : column::LiquidFigures{};
  const double velocity = figures_.liquid.superficial_velocity;
  const bool is_pumped = liquid != nullptr && !figures_.liquid.plunger_moves;
  if (is_pumped && std::abs(velocity) >= std::abs(figures_.highest_flow.velocity)) {
    figures_.highest_flow = {velocity, figures_.liquid.pressure_drop, figures_.bed.height};
  }
  figures_.plunger = plunger_of(dem, s);
  auto support = support_of(dem, s);
  support.load += figures_.liquid.pressure_force;
  figures_.kinetic_to_elastic = ratio(s.kinetic_energy, s.elastic_energy);
  figures_.unbalanced_force = ratio(s.mean_unbalanced_force, s.mean_contact_force);
  figures_.max_overlap_ratio = std::max(figures_.max_overlap_ratio, s.max_overlap_ratio);
  figures_.coordination_number = s.coordination_number;
  figures_.floor_force = support.floor;
  figures_.wall_shear = support.shear;
  figures_.budget_error =
      support.load > 0.0
          ? 1.0 - (support.floor + support.shear + figures_.liquid.wall_shear) / support.load
          : 0.0;
  if (reference_) write_sections(dem);
  if (series_) write_row(dem, s, stage);
  if (case_.output.beads_csv) {
    const auto beads = dem.snapshot();
    if (series_) write_bead_csv(beads);
  }
  const auto& interval = case_.output.frame_interval;
  if (!frames_ || !interval) return;
  constexpr double rounding = 1e-9;
  const auto passed =
      1 + static_cast<std::int64_t>(std::floor(s.time / *interval * (1.0 + rounding)));
  if (passed <= frames_by_time_) return;
  frames_by_time_ = passed;
  frames_->write(dem, liquid);
}

/// The cells of a row, in the order of columns().
void Outputs::write_row(const dem::Dem& dem, const dem::Sums& s, std::int64_t stage) {
  const io::Cell none{std::string()};
  std::vector<io::Cell> row = {s.time, dem.steps(), stage};
  if (has_liquid_) {
    const auto& l = figures_.liquid;
    row.insert(row.end(), {l.superficial_velocity, l.pressure_drop, l.frit_pressure_drop,
                           l.wall_shear, l.continuity_error, l.courant, l.largest_solid_fraction});
  }
  if (has_bed_) {
    const auto share = figures_.compression();
    row.insert(row.end(), {figures_.bed.height, share ? io::Cell(*share) : none,
                           figures_.bed.mean_porosity, figures_.bed.middle_porosity,
                           figures_.floor_force, figures_.wall_shear, figures_.budget_error});
  }
  if (has_plunger_) {
    const auto& p = figures_.plunger;
    const double h0 = figures_.settled_height;
    const bool is_there = p.position < column::lid_away;
    row.insert(row.end(), {is_there ? io::Cell(p.position) : none,
                           is_there && h0 > 0.0 ? io::Cell(1.0 - p.position / h0) : none, p.force,
                           p.force / mesh::cross_section(case_.column.shape)});
  }
  row.insert(row.end(), {s.mean_overlap, s.max_overlap_ratio, s.coordination_number,
                         s.kinetic_energy, s.elastic_energy, figures_.kinetic_to_elastic,
                         figures_.unbalanced_force, dem.options().step, dem.bead_count()});
  for (const auto& force : s.wall_force) {
    for (const double component : as_array(force)) row.emplace_back(component);
  }
  series_->row(row);
}

void Outputs::stage_end(const dem::Dem& dem, const column::CoupledBed* liquid, std::int64_t stage) {
  if (frames_ && !case_.output.frame_interval) frames_->write(dem, liquid);
  if (has_bed_ && stage > 0 && figures_.bed.height > 0.0) write_profiles(dem, stage);
}

void Outputs::set_settled(const dem::Dem& dem) {
  figures_.settled_height = figures_.bed.height;
  figures_.settled_porosity = figures_.bed.middle_porosity;
  const auto beads = analysis::own_beads(dem.particles());
  try {
    reference_ = analysis::section_reference(beads, figures_.bed.height, {}, dem.ranks());
  } catch (const ValueError&) {
    reference_.reset();  // a bed too low for sections has none
    return;
  }
  open_sections();
  write_sections(dem);
}

void Outputs::take_settled(const Json& saved) {
  const auto before = row_figures_from(saved.at("figures"));
  figures_.settled_height = before.settled_height;
  figures_.settled_porosity = before.settled_porosity;
  if (saved.at("reference").is_null()) return;
  reference_ = section_reference_from(saved.at("reference"));
  open_sections();
}

void Outputs::open_sections() {
  if (!Ranks::all().is_first() || sections_) return;
  sections_.emplace(folder_ / "sections.csv", section_columns);
}

void Outputs::write_sections(const dem::Dem& dem) {
  const auto rows =
      analysis::sections(*reference_, analysis::own_beads(dem.particles()), figures_.bed.height,
                         mesh::cross_section(case_.column.shape), dem.ranks());
  if (!sections_) return;
  for (const auto& s : rows) {
    sections_->row({dem.time(), static_cast<std::int64_t>(s.section), s.z_top, s.z_bottom, s.height,
                    s.compression, s.packing_density});
  }
}

// Along z over the whole bed; across it over the middle half.
void Outputs::write_profiles(const dem::Dem& dem, std::int64_t stage) const {
  const auto beads = analysis::own_beads(dem.particles());
  const auto& ranks = dem.ranks();
  const auto& shape = case_.column.shape;
  const double width = bin_of_diameter * mean_diameter(beads, ranks);
  const double height = figures_.bed.height;
  const analysis::ProfileBins across{.width = width, .z = analysis::middle_half(height)};
  std::filesystem::path folder = folder_ / "profiles";
  if (ranks.is_first()) std::filesystem::create_directories(folder);
  const auto write = [&](std::string_view name, const analysis::Profile& profile) {
    if (!ranks.is_first()) return;
    write_text_file(folder / fmt::format("{}_{:06}.csv", name, stage), profile_text(profile, name));
  };
  write("z", analysis::bed_profile(beads, shape, analysis::Axis::z,
                                   {.width = width, .z = {0.0, height}}, ranks));
  write("x", analysis::bed_profile(beads, shape, analysis::Axis::x, across, ranks));
  write("y", analysis::bed_profile(beads, shape, analysis::Axis::y, across, ranks));
  const bool has_sides = std::ranges::any_of(
      dem.walls(), [](const auto& w) { return w.name != "floor" && w.name != "lid"; });
  if (has_sides) write("wall_distance", analysis::wall_profile(beads, shape, across, ranks));
}

void Outputs::write_bead_csv(const dem::Snapshot& s) {
  std::vector<io::BeadRow> rows;
  for (std::size_t i = 0; i < s.beads.size(); ++i) {
    const auto& p = s.beads[i];
    rows.push_back({.id = p.id,
                    .x = as_array(s.x[i]),
                    .v = as_array(s.v[i]),
                    .w = as_array(s.w[i]),
                    .diameter = p.diameter,
                    .fixed = p.fixed,
                    .density = p.density,
                    .youngs_modulus = p.material.youngs_modulus,
                    .poisson_ratio = p.material.poisson_ratio,
                    .force = as_array(s.force[i]),
                    .torque = as_array(s.torque[i])});
  }
  io::write_bead_csv(bead_csv_file(bead_csv_files_++), rows);
}

std::filesystem::path Outputs::bead_csv_file(std::int64_t k) const {
  return folder_ / "frames" / fmt::format("beads_{:06}.csv", k);
}

// The numbers are the same on all ranks but those of files, which count on the first one only.
Json Outputs::save() const {
  if (series_) series_->sync();
  if (sections_) sections_->sync();
  return {{"series_bytes", series_ ? series_->bytes() : 0},
          {"sections_bytes", sections_ ? sections_->bytes() : 0},
          {"plateaus", plateaus_->save()},
          {"frames", frames_ ? frames_->save() : Json()},
          {"frames_by_time", frames_by_time_},
          {"bead_csv_files", bead_csv_files_},
          {"figures", to_json(figures_)},
          {"reference", reference_ ? to_json(*reference_) : Json()}};
}

void Outputs::load(const Json& saved) {
  figures_ = row_figures_from(saved.at("figures"));
  frames_by_time_ = saved.at("frames_by_time");
  bead_csv_files_ = saved.at("bead_csv_files");
  if (!saved.at("reference").is_null()) reference_ = section_reference_from(saved.at("reference"));
  plateaus_.emplace(folder_, saved.at("plateaus"));
  if (case_.output.frames) frames_.emplace(folder_ / "frames", saved.at("frames"));
  if (!Ranks::all().is_first()) return;
  series_ = io::SeriesWriter::resume(folder_ / "series.csv", columns_, saved.at("series_bytes"));
  const std::int64_t bytes = saved.at("sections_bytes");
  if (bytes > 0) {
    sections_ = io::SeriesWriter::resume(folder_ / "sections.csv", section_columns, bytes);
  } else {
    std::filesystem::remove(folder_ / "sections.csv");  // of after the checkpoint
  }
  for (auto k = bead_csv_files_; std::filesystem::remove(bead_csv_file(k)); ++k) {}
}

}  // namespace packbed::app
