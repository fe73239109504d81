// SPDX-License-Identifier: BSD-3-Clause
#include "report/case_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "report/plot.hpp"
#include "report/words.hpp"

namespace packbed::report {
namespace {

/// "; name value" for each pair whose value is there.
std::string listed(std::initializer_list<std::pair<const char*, std::string>> pairs) {
  std::string all;
  for (const auto& [name, value] : pairs) {
    if (!value.empty()) all += fmt::format("{}{} {}", all.empty() ? "" : "; ", name, value);
  }
  return all;
}

std::string column_line(const Json& v, const UnitSystem& units) {
  const auto shape = text(v, "/column/shape");
  const auto of = [&](const char* pointer) { return length(text(v, pointer), units); };
  if (shape == "slice") {
    return fmt::format("slice of a round column, inner diameter {}, depth {} (periodic), height {}",
                       of("/column/inner_diameter"), of("/column/slice_depth"),
                       of("/column/height"));
  }
  if (shape == "cylinder") {
    return fmt::format("cylinder, inner diameter {}, height {}", of("/column/inner_diameter"),
                       of("/column/height"));
  }
  return fmt::format("box, {} x {} x {}; sides: x {}, y {}, z {}", of("/column/size/0"),
                     of("/column/size/1"), of("/column/size/2"), text(v, "/column/boundaries/x"),
                     text(v, "/column/boundaries/y"), text(v, "/column/boundaries/z"));
}

std::string resin_line(const Json& v) {
  const auto name = text(v, "/resin/name");
  const auto values = listed({{"Young's modulus", text(v, "/resin/youngs_modulus")},
                              {"Poisson's ratio", text(v, "/resin/poisson_ratio")},
                              {"density", text(v, "/resin/density")},
                              {"friction", text(v, "/resin/friction")},
                              {"friction on walls", text(v, "/resin/wall_friction")},
                              {"rolling friction", text(v, "/resin/rolling_friction")},
                              {"restitution", text(v, "/resin/restitution")},
                              {"contact law", text(v, "/resin/contact")}});
  return name.empty() ? values : fmt::format("{}: {}", name, values);
}

std::string um(const RunData& run, const char* key) {
  const auto value = run.number(fmt::format("/figures/sizes/{}", key));
  return value ? fmt::format("{:.1f} um", per_um * *value) : "?";
}

std::string bead_line(const RunData& run) {
  auto line =
      fmt::format("{} to {}, Sauter mean {}, d50 of the volume {}", um(run, "smallest_m"),
                  um(run, "largest_m"), um(run, "sauter_diameter_m"), um(run, "d50_volume_m"));
  const auto grain = run.values.value("/resin/coarse_grain"_json_pointer, 1.0);
  if (grain > 1.0) {
    line += fmt::format("; coarse grain {:g}: one simulated grain stands for {:.4g} beads", grain,
                        grain * grain * grain);
  }
  return line;
}

std::string liquid_line(const RunData& run, const UnitSystem& units) {
  if (!run.values.contains("liquid")) return "none: the column is dry";
  auto line = text(run.values, "/liquid/name");
  if (const auto t = text(run.values, "/liquid/temperature"); !t.empty()) {
    line += " at " + in_si(t, Dimension::temperature, units,
                           [](double kelvin) { return fmt::format("{:.4g} °C", kelvin - 273.15); });
  }
  const auto density = run.number("/figures/liquid/density_kg_m3");
  const auto viscosity = run.number("/figures/liquid/viscosity_Pa_s");
  if (!density || !viscosity) return line;
  return fmt::format("{}{}{:.5g} kg/m3, {:.4g} mPa s", line, line.empty() ? "" : ": ", *density,
                     per_milli_pa_s * *viscosity);
}

std::string coupling_line(const Json& v) {
  return listed({{"drag law", text(v, "/drag/law")},
                 {"smallest void fraction it sees", text(v, "/drag/min_void_fraction")},
                 {"void fraction at walls", text(v, "/liquid/wall_void_fraction")},
                 {"overlaps", text(v, "/coupling/overlap")},
                 {"averaging width", text(v, "/coupling/averaging_width")},
                 {"interval", text(v, "/coupling/interval")},
                 {"scheme", text(v, "/coupling/scheme")}});
}

std::string numerics_line(const RunData& run) {
  auto line = listed({{"seed", text(run.values, "/numerics/seed")},
                      {"time step", text(run.values, "/numerics/step")},
                      {"inertia scale", text(run.values, "/numerics/inertia_scale")}});
  const auto step = run.number("/bead_step_s");
  const auto scale = run.number("/inertia_scale");
  if (step && scale) {
    line += fmt::format("; at the end of the run: time step {:.4g} us, inertia scale {:.4g}",
                        per_um * *step, *scale);
  }
  return line;
}

/// "/protocol/1/to" as check and resume call it: "protocol[2].to".
std::string key_of(std::string_view pointer) {
  std::string key;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const auto part = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(part.size());
    if (const auto place = to_number(part)) {
      key += fmt::format("[{:.0f}]", *place + 1.0);
    } else {
      key += fmt::format("{}{}", key.empty() ? "" : ".", part);
    }
  }
  return key;
}

/// Kinds of the steps of a protocol, those that are repeated in brackets: "settle [cycle ]".
std::string kinds(const Json& steps) {
  std::string all;
  for (const auto& step : steps) {
    all += step.value("step", "") + ' ';
    if (step.contains("steps") && step["steps"].is_array()) all += '[' + kinds(step["steps"]) + ']';
  }
  return all;
}

}  // namespace

std::vector<CaseLine> case_lines(const RunData& run, const UnitSystem& units) {
  std::vector<CaseLine> lines = {{"Column", column_line(run.values, units)},
                                 {"Resin", resin_line(run.values)},
                                 {"Beads", bead_line(run)},
                                 {"Liquid", liquid_line(run, units)},
                                 {"Numerics", numerics_line(run)}};
  if (run.values.contains("liquid")) {
    lines.insert(lines.end() - 1, {"Coupling", coupling_line(run.values)});
  }
  for (const auto& [name, key] : {std::pair{"Bead file", "/beads/csv"}, {"Bed of", "/beads/run"}}) {
    if (const auto file = text(run.values, key); !file.empty()) {
      lines.insert(lines.begin() + 3, {name, file});
    }
  }
  return lines;
}

bool have_same_steps(const std::vector<RunData>& runs) {
  const auto kinds_of = [](const RunData& run) {
    return kinds(run.values.value("protocol", Json::array()));
  };
  return std::ranges::all_of(
      runs, [&](const RunData& run) { return kinds_of(run) == kinds_of(runs.front()); });
}

std::vector<Difference> differences(const std::vector<RunData>& runs) {
  std::vector<Difference> all;
  const bool compares_steps = have_same_steps(runs);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto flat = runs[r].values.flatten();
    for (const auto& [pointer, value] : flat.items()) {
      if (pointer == "/title" || pointer.starts_with("/output/")) continue;
      if (!compares_steps && pointer.starts_with("/protocol")) continue;
      const auto found = std::ranges::find(all, pointer, &Difference::key);
      auto& row =
          found != all.end()
              ? *found
              : all.emplace_back(Difference{pointer, std::vector<std::string>(runs.size())});
      row.values[r] = text(runs[r].values, pointer.c_str());
    }
  }
  std::erase_if(all, [](const Difference& row) {
    return std::ranges::all_of(row.values, [&](const auto& v) { return v == row.values.front(); });
  });
  for (auto& row : all) row.key = key_of(row.key);
  return all;
}

}  // namespace packbed::report
