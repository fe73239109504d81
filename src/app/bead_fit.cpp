// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/bead_commands.hpp"
#include "app/fit_print.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "continuum/bead/loop.hpp"
#include "continuum/bead/plate_contact.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/plot.hpp"
#include "setup/read_curves.hpp"
#include "study/collapse.hpp"

namespace packbed::app {
namespace {

using enum Dimension;
namespace bounds = setup::bounds;
using continuum::BeadCurve;
using study::CurveFit;

const std::vector<std::string> models = {"prony", "sls-maxwell", "sls-kelvin", "hertz",
                                         "hooke", "power",       "restitution"};
const std::vector<std::string> corrections = {"exact", "mattice", "thesis", "none"};

/// All curves fitted, and what was said about them.
struct Fitted {
  std::vector<CurveFit> fits;
  std::vector<std::string> notes;
  std::optional<study::Collapse> collapse;
};

CurveFit fit_restitution(const BeadCurve& curve) {
  const auto work = continuum::loop_work(curve.approach, curve.force);
  CurveFit fit;
  fit.curve = curve.name;
  fit.facts = {{"depth_m", *std::ranges::max_element(curve.approach)},
               {"work_loading_J", work.loading},
               {"work_unloading_J", work.unloading},
               {"restitution", work.restitution()}};
  fit.x = curve.approach;
  fit.data = curve.force;
  return fit;
}

study::PronyOptions prony_options(const BeadFitCommand& c,
                                  const UnitSystem& units,
                                  double poisson) {
  study::PronyOptions options{.poisson = poisson};
  if (c.terms != 0) options.terms = c.terms;
  options.ramp_time =
      optional_quantity(units, {"--ramp-time", c.ramp_time}, time, bounds::not_negative);
  const auto found = std::ranges::find(corrections, c.ramp_correction);
  if (found == corrections.end()) {
    throw ConfigError(fmt::format("--ramp-correction \"{}\" is not known; known are {}",
                                  c.ramp_correction, either_of(corrections)));
  }
  options.correction = static_cast<study::RampCorrection>(found - corrections.begin());
  return options;
}

void note_prony(const study::PronyFit& prony, study::Intervals intervals, Fitted& fitted) {
  const auto& fit = prony.best;
  if (!prony.bic.empty()) {
    fitted.notes.push_back(fmt::format(
        "{}: {} of 1 to {} relaxation times chosen by the information criterion BIC = {:.1f}",
        fit.curve, prony.terms, prony.bic.size(), fmt::join(prony.bic, ", ")));
  }
  for (int i = 1; i <= prony.terms; ++i) {
    const auto* tau = find(fit, fmt::format("tau{}_s", i));
    if (tau->value > fit.x.back()) {
      fitted.notes.push_back(
          fmt::format("{}: tau{} = {:.3g} s is longer than the data ({:.3g} s): it, its amplitude "
                      "and B0 are extrapolations{}",
                      fit.curve, i, tau->value, fit.x.back(),
                      intervals == study::Intervals::linear
                          ? ", and their intervals are too narrow; use --intervals profile"
                          : ""));
    }
  }
}

std::vector<study::Relaxation> relaxations(const std::vector<CurveFit>& fits) {
  std::vector<study::Relaxation> curves;
  for (const auto& fit : fits) {
    const continuum::BeadShape shape{*fact(fit, "radius_m"), 0.0};
    study::Relaxation r{.contact_radius = continuum::contact_radius(shape, *fact(fit, "depth_m")),
                        .duration = fit.x.back(),
                        .shortest = fit.x.back() / static_cast<double>(fit.x.size()),
                        .amplitudes = {},
                        .times = {}};
    for (int i = 1; const auto* b = find(fit, fmt::format("B{}_N", i)); ++i) {
      r.amplitudes.push_back(b->value);
      r.times.push_back(find(fit, fmt::format("tau{}_s", i))->value);
    }
    curves.push_back(std::move(r));
  }
  return curves;
}

std::optional<study::Collapse> try_collapse(Fitted& fitted) {
  try {
    return study::collapse(relaxations(fitted.fits));
  } catch (const ValueError& error) {
    fitted.notes.push_back(
        fmt::format("no test of viscoelastic against poroelastic relaxation: {}", error.what()));
    return std::nullopt;
  }
}

// Curves of the same depth, within 5 %: beads that can be averaged.
std::vector<std::vector<CurveFit>> same_depth(const std::vector<CurveFit>& fits) {
  std::vector<std::vector<CurveFit>> groups;
  for (const auto& fit : fits) {
    const auto near = [&](const std::vector<CurveFit>& group) {
      return std::abs(*fact(group.front(), "depth_m") / *fact(fit, "depth_m") - 1.0) < 0.05;
    };
    const auto found = std::ranges::find_if(groups, near);
    if (found == groups.end()) {
      groups.push_back({fit});
    } else {
      found->push_back(fit);
    }
  }
  std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
  return groups;
}

CurveFit fit_one(const BeadFitCommand& c,
                 const UnitSystem& units,
                 const BeadCurve& curve,
                 Fitted& fitted) {
  if (c.model == "restitution") return fit_restitution(curve);
  if (c.model == "power") return study::fit_power_law(curve);
  const double nu = quantity(units, {"--poisson", c.poisson}, fraction, bounds::poisson_ratio);
  if (c.model == "prony") {
    auto prony = study::fit_prony(curve, prony_options(c, units, nu));
    note_prony(prony, read_intervals(c.intervals), fitted);
    return std::move(prony.best);
  }
  if (c.model == "hertz") return study::fit_hertz(curve, nu);
  if (c.model == "hooke") {
    return study::fit_hooke(
        curve, {nu, quantity(units, {"--density", c.density}, density, bounds::positive),
                quantity(units, {"--characteristic-velocity", c.characteristic_velocity}, velocity,
                         bounds::positive)});
  }
  return study::fit_standard_linear_solid(
      curve, nu, c.model == "sls-maxwell" ? study::SolidForm::maxwell : study::SolidForm::kelvin);
}

Fitted fit_all(const BeadFitCommand& c, const UnitSystem& units) {
  const auto radius =
      c.model == "power" || c.model == "restitution"
          ? quantity_or(units, {"--radius", c.radius}, length, bounds::positive, 1.0)
          : optional_quantity(units, {"--radius", c.radius}, length, bounds::positive);
  const auto intervals = read_intervals(c.intervals);
  Fitted fitted;
  for (const auto& file : c.files) {
    for (const auto& curve : setup::read_curves(file, units, radius)) {
      try {
        fitted.fits.push_back(fit_one(c, units, curve, fitted));
        if (intervals == study::Intervals::profile) study::profile_intervals(fitted.fits.back());
      } catch (const ValueError& error) {
        throw ConfigError(fmt::format("{}: curve \"{}\": {}", file, curve.name, error.what()));
      }
    }
  }
  if (c.model == "prony" && fitted.fits.size() > 1) fitted.collapse = try_collapse(fitted);
  return fitted;
}

nlohmann::ordered_json to_json(const BeadFitCommand& c, const Fitted& fitted) {
  nlohmann::ordered_json j{{"model", c.model}, {"intervals", c.intervals}};
  j["curves"] = nlohmann::ordered_json::array();
  for (const auto& fit : fitted.fits) j["curves"].push_back(fit_json(fit));
  for (const auto& group : same_depth(fitted.fits)) {
    j["over_curves"].push_back(over_curves_json(group));
  }
  if (fitted.collapse) {
    j["collapse"] = {
        {"spread_over_time", fitted.collapse->spread_over_time},
        {"spread_over_time_by_area", fitted.collapse->spread_over_scaled},
        {"better", fitted.collapse->is_viscoelastic() ? "viscoelastic" : "poroelastic"}};
  }
  j["notes"] = fitted.notes;
  return j;
}

void print(const Fitted& fitted) {
  for (const auto& fit : fitted.fits) print_fit(fit);
  for (const auto& group : same_depth(fitted.fits)) print_over_curves(group);
  if (fitted.collapse) {
    const auto& k = *fitted.collapse;
    fmt::print(
        "Spread of the normalized relaxations over time {:.4f}, over time / a^2 {:.4f}: {}\n",
        k.spread_over_time, k.spread_over_scaled,
        k.is_viscoelastic()
            ? "rather viscoelastic (the time does not depend on the size of the contact)"
            : "rather poroelastic (the time grows with the area of the contact)");
  }
  for (const auto& note : fitted.notes) fmt::print("note: {}\n", note);
}

// Thesis fig. 6.8: which axis brings the normalized relaxations together.
std::vector<io::PlotPanel> collapse_panels(const std::vector<CurveFit>& fits) {
  const std::string y = "(F - F_inf) / (F_0 - F_inf)";
  io::PlotPanel plain{.title = "Over time", .x = {"time [s]", true}, .y = {y}, .series = {}};
  io::PlotPanel scaled{.title = "Over time / contact area",
                       .x = {"time / a^2 [s/um2]", true},
                       .y = {y},
                       .series = {}};
  const auto curves = relaxations(fits);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    io::PlotSeries line{.label = fits[k].curve, .x = {}, .y = {}};
    for (const double t : spread(curves[k].shortest, curves[k].duration, 120, true)) {
      line.x.push_back(t);
      line.y.push_back(curves[k].normalized(t));
    }
    plain.series.push_back(line);
    for (auto& t : line.x) t /= curves[k].contact_radius * curves[k].contact_radius * 1e12;
    scaled.series.push_back(std::move(line));
  }
  return {plain, scaled};
}

// Force, and what the model leaves, of each curve.
std::string draw(const BeadFitCommand& c, const Fitted& fitted) {
  const bool over_time = c.model == "prony";
  const double x_scale = over_time ? 1.0 : 1e6;
  const std::string x_label =
      over_time ? "time since the end of the ramp [s]" : "displacement of the plates [um]";
  io::PlotPanel curve{.title = "Force", .x = {x_label}, .y = {"force [uN]"}, .series = {}};
  io::PlotPanel rest{
      .title = "Residuals: data less model", .x = {x_label}, .y = {"force [uN]"}, .series = {}};
  int color = 0;
  for (const auto& fit : fitted.fits) {
    std::vector<double> x, data, model, residual;
    for (std::size_t i = 0; i < fit.x.size(); ++i) {
      x.push_back(fit.x[i] * x_scale);
      data.push_back(fit.data[i] * 1e6);
      if (fit.model.empty()) continue;
      model.push_back(fit.model[i] * 1e6);
      residual.push_back(data.back() - model.back());
    }
    const auto style = fit.model.empty() ? io::PlotStyle::line : io::PlotStyle::points;
    curve.series.push_back({.label = fit.curve, .x = x, .y = data, .style = style, .color = color});
    if (!fit.model.empty()) {
      curve.series.push_back(
          {.label = fit.curve + ", " + c.model, .x = x, .y = model, .color = color + 1});
      rest.series.push_back({.label = fit.curve,
                             .x = x,
                             .y = residual,
                             .style = io::PlotStyle::points,
                             .color = color});
    }
    color += 2;
  }
  if (rest.series.empty()) return io::plot_svg({curve}, 1);
  std::vector<io::PlotPanel> panels{curve, rest};
  if (fitted.collapse) {
    for (auto& panel : collapse_panels(fitted.fits)) panels.push_back(std::move(panel));
  }
  return io::plot_svg(panels);
}

}  // namespace

int bead_fit(const BeadFitCommand& command) {
  if (std::ranges::find(models, command.model) == models.end()) {
    throw ConfigError(command.model.empty()
                          ? fmt::format("--model is missing; known are {}", either_of(models))
                          : fmt::format("--model \"{}\" is not known; known are {}", command.model,
                                        either_of(models)));
  }
  const UnitSystem units;
  const auto fitted = fit_all(command, units);
  if (command.json) {
    fmt::print("{}", json_text(to_json(command, fitted)));
  } else {
    print(fitted);
  }
  if (!command.plot.empty()) write_plot(command.plot, draw(command, fitted));
  return 0;
}

}  // namespace packbed::app
