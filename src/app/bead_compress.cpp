// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "app/bead_commands.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "continuum/bead/loop.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"

namespace packbed::app {
namespace {

using continuum::Loading;
using enum Dimension;
namespace bounds = setup::bounds;

/// Force and displacement over time.
struct Curve {
  std::vector<double> time, approach, force;
};

Curve curve_of(const BeadModel& model, const Loading& loading, double from, double to, int points) {
  Curve curve;
  for (const double t : spread(from, to, points)) {
    curve.time.push_back(t);
    curve.approach.push_back(loading.approach(t));
    curve.force.push_back(model.force(loading, t));
  }
  return curve;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (auto& v : values) v *= factor;
  return values;
}

void write_files(const BeadCurveCommand& command, const Curve& curve, bool over_time) {
  write_csv(command.csv, {"time_s", "displacement_m", "force_N"},
            {curve.time, curve.approach, curve.force});
  if (command.plot.empty()) return;
  const auto force = scaled(curve.force, 1e6);
  const auto panel = [&](const std::string& title, const std::string& x_label,
                         std::vector<double> x) {
    return io::PlotPanel{.title = title,
                         .x = {x_label},
                         .y = {"force on a plate [uN]"},
                         .series = {{.label = command.bead.model, .x = std::move(x), .y = force}}};
  };
  auto by_time = panel("Force over time", "time [s]", curve.time);
  auto by_depth = panel("Force over displacement", "displacement of the plates [um]",
                        scaled(curve.approach, 1e6));
  write_plot(command.plot,
             over_time ? io::plot_svg({by_time}, 1) : io::plot_svg({by_depth, by_time}));
}

nlohmann::ordered_json figures(const BeadCurveCommand& command,
                               const BeadModel& model,
                               const Loading& loading,
                               double t) {
  nlohmann::ordered_json j{{"model", command.bead.model}, {"time_s", t}};
  j["displacement_m"] = loading.approach(t);
  j["force_N"] = model.force(loading, t);
  j["contact_radius_m"] = continuum::contact_radius(model.shape, loading.approach(t));
  j["strain"] = continuum::contact_radius(model.shape, loading.approach(t)) / model.shape.radius;
  if (model.instantaneous) {
    j["shear_modulus_instantaneous_Pa"] = *model.instantaneous;
    j["youngs_modulus_instantaneous_Pa"] =
        continuum::youngs_modulus(*model.instantaneous, model.shape.poisson);
  }
  if (model.relaxed) {
    j["shear_modulus_relaxed_Pa"] = *model.relaxed;
    j["youngs_modulus_relaxed_Pa"] = continuum::youngs_modulus(*model.relaxed, model.shape.poisson);
  }
  if (!model.approximation.empty() && loading.ramp_time > 0.0) j["note"] = model.approximation;
  return j;
}

void print(const nlohmann::ordered_json& j) {
  const auto line = [&](const char* key, const char* name, double factor, const char* unit) {
    if (j.contains(key))
      fmt::print("{:<34} {:.6g} {}\n", name, j[key].get<double>() * factor, unit);
  };
  fmt::print("{:<34} {}\n", "model", j["model"].get<std::string>());
  line("time_s", "time since first touch", 1.0, "s");
  line("displacement_m", "displacement of the plates", 1e6, "um");
  line("force_N", "force", 1e6, "uN");
  line("contact_radius_m", "elastic contact radius a", 1e6, "um");
  line("strain", "strain a/R", 1.0, "");
  line("shear_modulus_instantaneous_Pa", "shear modulus at once", 1e-6, "MPa");
  line("shear_modulus_relaxed_Pa", "shear modulus relaxed", 1e-6, "MPa");
  line("youngs_modulus_instantaneous_Pa", "Young's modulus at once", 1e-6, "MPa");
  line("youngs_modulus_relaxed_Pa", "Young's modulus relaxed", 1e-6, "MPa");
  line("work_loading_J", "work put in", 1e12, "pJ");
  line("work_unloading_J", "work given back", 1e12, "pJ");
  line("restitution", "restitution", 1.0, "");
  if (j.contains("note")) fmt::print("note: {}\n", j["note"].get<std::string>());
}

int finish(const BeadCurveCommand& command, const nlohmann::ordered_json& j) {
  if (command.json) {
    fmt::print("{}", json_text(j));
  } else {
    print(j);
  }
  return 0;
}

}  // namespace

int bead_compress(const BeadCurveCommand& command) {
  const UnitSystem units;
  const auto model = make_bead_model(command.bead, units);
  if (model.closing_only && command.unload) {
    throw ConfigError(
        "--unload does not apply to --model poroelastic, whose contact shrinks in a way that is "
        "not "
        "known; leave it out");
  }
  const double speed = quantity(units, {"--speed", command.speed}, velocity, bounds::positive);
  const double t = quantity(units, {"--time", command.time}, time, bounds::positive);
  Loading loading{.depth = speed * t, .ramp_time = t};
  if (command.unload)
    loading.hold_time =
        quantity_or(units, {"--hold", command.hold}, time, bounds::not_negative, 0.0);
  const double end = command.unload ? loading.unload_start() + t : t;
  // The end of the ramp is a row, so that a loop has its top.
  const auto curve = curve_of(model, loading, 0.0, end, command.points);
  auto j = figures(command, model, loading, t);
  if (command.unload) {
    constexpr int rows = 20001;
    const auto fine = curve_of(model, loading, 0.0, end, rows);
    const auto work = continuum::loop_work(fine.approach, fine.force);
    j["work_loading_J"] = work.loading;
    j["work_unloading_J"] = work.unloading;
    j["restitution"] = work.restitution();
  }
  write_files(command, curve, false);
  return finish(command, j);
}

int bead_relax(const BeadCurveCommand& command) {
  const UnitSystem units;
  const auto model = make_bead_model(command.bead, units);
  Loading loading{.depth = quantity(units, {"--depth", command.depth}, length, bounds::positive)};
  const auto speed =
      optional_quantity(units, {"--speed", command.speed}, velocity, bounds::positive);
  if (speed) loading.ramp_time = loading.depth / *speed;
  const double hold = quantity(units, {"--time", command.time}, time, bounds::not_negative);
  const double end = loading.ramp_time + hold;
  auto j = figures(command, model, loading, end);
  j["ramp_time_s"] = loading.ramp_time;
  j["force_at_end_of_ramp_N"] = model.force(loading, loading.ramp_time);
  write_files(command, curve_of(model, loading, 0.0, end, command.points), true);
  return finish(command, j);
}

}  // namespace packbed::app
