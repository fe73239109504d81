// SPDX-License-Identifier: BSD-3-Clause
#include "setup/case_report.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace packbed::setup {
namespace {

using Json = nlohmann::ordered_json;

constexpr double per_um = 1e6;
constexpr double per_mm = 1e3;
constexpr double cm_h = 3.6e5;  // of 1 m/s
constexpr double per_bar = 1e-5;

std::string figure(std::string_view name, const std::string& value) {
  return fmt::format("#   {:<34} {}\n", name, value);
}

std::string size_lines(const CaseFigures& f) {
  const auto& s = f.sizes;
  const auto um = [](double length) { return fmt::format("{:.1f} um", length * per_um); };
  return figure("mean, median of the number", um(s.mean) + ", " + um(s.median)) +
         figure("standard deviation of the number", um(s.standard_deviation)) +
         figure("d10, d50, d90 of the volume", um(s.d10) + ", " + um(s.d50) + ", " + um(s.d90)) +
         figure("Sauter mean d32", um(s.sauter)) +
         figure("smallest, largest", um(s.smallest) + ", " + um(s.largest));
}

std::string bed_lines(const CaseFigures& f) {
  std::string text;
  text += figure("grains to simulate", fmt::format("{:.0f}", f.bead_count));
  if (f.real_bead_count != f.bead_count) {
    text += figure("real beads that they stand for", fmt::format("{:.0f}", f.real_bead_count));
    text += figure("largest grain", fmt::format("{:.1f} um", f.largest_grain * per_um));
  }
  if (f.bed) {
    text += figure("settled bed height", fmt::format("{:.3f} mm", f.bed->height * per_mm));
    text += figure("settled porosity",
                   fmt::format("{:.3f} ({})", f.bed->porosity,
                               f.bed->porosity_is_set ? "asked for by the settle step"
                                                      : "assumed; it follows from the settling"));
  }
  text += figure("mass of the wet beads", fmt::format("{:.4g} g", f.bead_mass * 1e3));
  if (f.submerged_weight) {
    text += figure("submerged weight", fmt::format("{:.4g} mN", *f.submerged_weight * 1e3));
  }
  return text;
}

std::string liquid_lines(const LiquidOptions& liquid) {
  return figure("density, viscosity",
                fmt::format("{:.2f} kg/m3, {:.4f} mPa s", liquid.density, liquid.viscosity * 1e3));
}

std::string flow_lines(const FlowFigures& flow) {
  return figure("highest superficial velocity",
                fmt::format("{:.1f} cm/h = {:.4g} m/s", flow.highest_velocity * cm_h,
                            flow.highest_velocity)) +
         figure("Reynolds number, Stokes number",
                fmt::format("{:.3g}, {:.3g}", flow.reynolds, flow.stokes)) +
         figure("pressure drop, Kozeny-Carman",
                fmt::format("{:.3g} bar = {:.3g} bar/m (bed not compressed)",
                            flow.pressure_drop * per_bar, flow.pressure_gradient * per_bar));
}

std::string mesh_lines(const MeshFigures& mesh) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  return figure("cells: in a layer, layers, all",
                fmt::format("{}, {}, {}", mesh.counts.per_layer(), mesh.counts.layers,
                            mesh.counts.all())) +
         figure("mean size across, height",
                fmt::format("{:.4g} mm, {:.4g} mm", mesh.cell_across * per_mm,
                            mesh.cell_height * per_mm)) +
         figure("largest non-orthogonality",
                fmt::format("{:.1f} degrees", mesh.quality.largest_non_orthogonality * degrees)) +
         figure("largest skewness, aspect ratio",
                fmt::format("{:.2f}, {:.2f}", mesh.quality.largest_skewness,
                            mesh.quality.largest_aspect));
}

std::string step_lines(const Case& c, const CaseFigures& f) {
  std::string text = figure("step", fmt::format("{:.4g} us ({})", f.step.step * per_um,
                                                c.numerics.step ? "given" : "recommended")) +
                     figure("steps per shortest contact",
                            fmt::format("{:.1f}", f.step.contact_time / f.step.step)) +
                     figure("stable in a bed up to about",
                            fmt::format("{:.4g} us ({} contacts per bead)",
                                        f.step.stable_in_a_bed * per_um, dem::bed_contacts));
  if (f.run_time > 0.0) {
    const double steps = f.run_time / f.step.step;
    text += figure("steps of \"run\", expected time",
                   fmt::format("{:.4g}, {:.3g} s at {:.0f} million particle-steps/s", steps,
                               steps * f.bead_count / expected_rate, expected_rate * 1e-6));
  }
  return text;
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

// "inner_diameter" with a length becomes "inner_diameter_m".
std::string json_key(const EchoEntry& entry) {
  if (!entry.dimension || info(*entry.dimension).suffix.empty()) return entry.key;
  return fmt::format("{}_{}", entry.key, info(*entry.dimension).suffix);
}

Json json_value(const EchoEntry& entry) {
  if (!entry.si.empty() && !entry.dimension) return std::stoll(entry.toml);  // a whole number
  if (!entry.si.empty()) return entry.is_list ? Json(entry.si) : Json(entry.si.front());
  if (entry.toml == "true" || entry.toml == "false") return entry.toml == "true";
  return entry.words.empty() ? Json(entry.toml) : Json(entry.words.front());
}

// "[resin.sizes]" is found at /resin/sizes, "[[protocol.steps]]" below the last step.
Json& place_of(Json& root, std::string header) {
  const bool is_array = header.starts_with("[[");
  while (!header.empty() && header.front() == '[') header.erase(0, 1);
  while (!header.empty() && header.back() == ']') header.pop_back();
  Json* at = &root;
  while (!header.empty()) {
    const auto dot = header.find('.');
    const auto name = header.substr(0, dot);
    header = dot == std::string::npos ? "" : header.substr(dot + 1);
    at = &(*at)[name];
    if (is_array && header.empty()) at->push_back(Json::object());
    if (at->is_array()) at = &at->back();
  }
  return *at;
}

}  // namespace

std::string check_text(const Case& c, const CaseFigures& f) {
  std::string text = fmt::format("# {}: the case with every value filled in (a case file again)\n",
                                 c.file.string());
  text += fmt::format("#\n# Beads ({})\n{}",
                      c.beads.csv ? "grains as in the bead file" : "real size", size_lines(f));
  text += fmt::format("#\n# Bed\n{}", bed_lines(f));
  if (c.liquid) text += fmt::format("#\n# Liquid\n{}", liquid_lines(*c.liquid));
  if (f.flow) text += fmt::format("#\n# Flow, at the highest velocity\n{}", flow_lines(*f.flow));
  if (f.mesh) text += fmt::format("#\n# Mesh of the liquid\n{}", mesh_lines(*f.mesh));
  if (f.bead_count > 0.0) {
    text += fmt::format("#\n# Time step of the beads\n{}", step_lines(c, f));
  }
  text += "#\n# Computer\n";
  text += figure("memory of beads and contacts", fmt::format("{:.3g} MB", f.memory * 1e-6));
  if (c.output.frames) {
    text +=
        figure("while frames are written", fmt::format("{:.3g} MB", f.memory_with_frames * 1e-6));
  }
  return text + "\n" + to_toml(c.echo);
}

Json figures_json(const Case& c, const CaseFigures& f) {
  Json j;
  j["sizes"] = {{"mean_diameter_m", f.sizes.mean},
                {"median_diameter_m", f.sizes.median},
                {"standard_deviation_m", f.sizes.standard_deviation},
                {"d10_volume_m", f.sizes.d10},
                {"d50_volume_m", f.sizes.d50},
                {"d90_volume_m", f.sizes.d90},
                {"sauter_diameter_m", f.sizes.sauter},
                {"volume_mean_diameter_m", f.sizes.volume_mean},
                {"smallest_m", f.sizes.smallest},
                {"largest_m", f.sizes.largest}};
  j["bead_count"] = std::llround(f.bead_count);
  j["real_bead_count"] = std::llround(f.real_bead_count);
  j["largest_grain_m"] = f.largest_grain;
  j["bead_volume_m3"] = f.bead_volume;
  j["bead_mass_kg"] = f.bead_mass;
  j["submerged_weight_N"] = number_or_null(f.submerged_weight);
  if (f.bed) {
    j["bed"] = {{"height_m", f.bed->height},
                {"porosity", f.bed->porosity},
                {"porosity_is_assumed", !f.bed->porosity_is_set}};
  }
  if (f.flow) {
    j["flow"] = {{"highest_superficial_velocity_m_s", f.flow->highest_velocity},
                 {"reynolds", f.flow->reynolds},
                 {"stokes", f.flow->stokes},
                 {"kozeny_carman_pressure_gradient_Pa_m", f.flow->pressure_gradient},
                 {"kozeny_carman_pressure_drop_Pa", f.flow->pressure_drop}};
  }
  if (c.liquid) {
    j["liquid"] = {{"density_kg_m3", c.liquid->density}, {"viscosity_Pa_s", c.liquid->viscosity}};
  }
  if (f.mesh) {
    const auto& q = f.mesh->quality;
    j["mesh"] = {{"cells_per_layer", f.mesh->counts.per_layer()},
                 {"layers", f.mesh->counts.layers},
                 {"cells", f.mesh->counts.all()},
                 {"cell_across_m", f.mesh->cell_across},
                 {"cell_height_m", f.mesh->cell_height},
                 {"largest_non_orthogonality_rad", q.largest_non_orthogonality},
                 {"mean_non_orthogonality_rad", q.mean_non_orthogonality},
                 {"largest_skewness", q.largest_skewness},
                 {"largest_aspect_ratio", q.largest_aspect},
                 {"largest_over_smallest_area", q.largest_over_smallest}};
  }
  if (f.bead_count > 0.0) {
    j["time_step"] = {{"step_s", f.step.step},
                      {"shortest_contact_s", f.step.contact_time},
                      {"steps_per_contact", f.step.contact_time / f.step.step},
                      {"stable_step_in_a_bed_s", f.step.stable_in_a_bed},
                      {"run_steps", std::llround(f.run_time / f.step.step)}};
  }
  j["memory_of_beads_B"] = f.memory;
  j["memory_with_frames_B"] = f.memory_with_frames;
  return j;
}

Json check_json(const Case& c, const CaseFigures& f) {
  Json root = Json::object();
  for (const auto& table : c.echo) {
    Json& at = place_of(root, table.header);
    for (const auto& entry : table.entries) at[json_key(entry)] = json_value(entry);
  }
  return {{"case", root}, {"figures", figures_json(c, f)}};
}

}  // namespace packbed::setup
