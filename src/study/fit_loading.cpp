// SPDX-License-Identifier: BSD-3-Clause
// Models fitted to the loading of a bead: standard linear solid, Hertz, Hooke, power law.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "continuum/bead/hertz.hpp"
#include "continuum/bead/hooke.hpp"
#include "continuum/bead/viscoelastic.hpp"
#include "core/error.hpp"
#include "study/curve_fit.hpp"

namespace packbed::study {
namespace {

constexpr double most_deviation = 0.05;  // of a ramp from a straight line, in its depth

/// Rows up to the largest displacement, with positive displacement; time from first touch.
struct LoadingRows {
  std::vector<double> time, approach, force;
};

LoadingRows loading_rows(const continuum::BeadCurve& curve, double touch) {
  const auto top = std::ranges::max_element(curve.approach) - curve.approach.begin();
  LoadingRows rows;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(top); ++i) {
    if (curve.approach[i] <= 0.0 || curve.time[i] <= touch) continue;
    rows.time.push_back(curve.time[i] - touch);
    rows.approach.push_back(curve.approach[i]);
    rows.force.push_back(curve.force[i]);
  }
  if (rows.time.empty()) {
    throw ValueError("no row has a positive displacement before the largest one");
  }
  return rows;
}

double positive_maximum(const std::vector<double>& force) {
  const double most = *std::ranges::max_element(force);
  if (!(most > 0.0)) throw ValueError("the force is nowhere positive while the bead is loaded");
  return most;
}

/// A model F(p, row) fitted to rows: one start.
CurveFit fit_rows(const continuum::BeadCurve& curve,
                  LoadingRows rows,
                  std::vector<FitParameter> parameters,
                  const std::function<double(std::span<const double>, std::size_t)>& force,
                  const std::vector<std::vector<double>>& starts) {
  const double most = positive_maximum(rows.force);
  CurveFit fit;
  fit.problem.parameters = std::move(parameters);
  fit.problem.rows = rows.force.size();
  fit.problem.residuals = [force, data = rows.force, most](std::span<const double> p,
                                                           std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (force(p, i) - data[i]) / most;
  };
  fit.problem.starts = starts;
  auto started = least_squares(fit.problem, starts);
  fit.curve = curve.name;
  fit.fit = std::move(started.fit);
  fit.starts = started.starts;
  fit.agreeing = started.agreeing;
  fit.facts = {{"depth_m", rows.approach.back()}, {"radius_m", curve.radius}};
  const auto values = fit.fit.values();
  for (std::size_t i = 0; i < rows.force.size(); ++i) fit.model.push_back(force(values, i));
  fit.r2 = r_squared(rows.force, fit.model);
  fit.x = std::move(rows.approach);
  fit.data = std::move(rows.force);
  return fit;
}

// One amplitude of a fixed shape: F = p shape_i.
CurveFit fit_amplitude(const continuum::BeadCurve& curve,
                       LoadingRows rows,
                       const std::string& name,
                       const std::vector<double>& shape) {
  const double start = amplitudes({shape}, rows.force).values[0];
  if (!(start > 0.0)) throw ValueError("the force does not grow with the displacement");
  return fit_rows(curve, std::move(rows), {{name, start, 1e-3 * start, 1e3 * start, true}},
                  [shape](std::span<const double> p, std::size_t i) { return p[0] * shape[i]; },
                  {{start}});
}

void add_maxwell_figures(CurveFit& fit, double poisson) {
  const double to_e = continuum::youngs_modulus(1.0, poisson);
  const auto add = [&](const char* name, auto figure) { add_figure(fit, name, figure); };
  using P = std::span<const double>;
  add("eta_Pa_s", [](P p) { return p[1] * p[2]; });
  add("G_instantaneous_Pa", [](P p) { return p[0] + p[1]; });
  add("G_relaxed_Pa", [](P p) { return p[0]; });
  add("E_instantaneous_Pa", [=](P p) { return to_e * (p[0] + p[1]); });
  add("E_relaxed_Pa", [=](P p) { return to_e * p[0]; });
}

// The Kelvin form of the same curve: relaxed = G0 G1/(G0+G1), arm = G0^2/(G0+G1), tau = eta/(G0+G1).
void add_kelvin_figures(CurveFit& fit, double poisson) {
  const double to_e = continuum::youngs_modulus(1.0, poisson);
  const auto add = [&](const char* name, auto figure) { add_figure(fit, name, figure); };
  using P = std::span<const double>;
  const auto g0 = [](P p) { return p[0] + p[1]; };
  const auto g1 = [](P p) { return p[0] * (p[0] + p[1]) / p[1]; };
  add("G0_Pa", g0);
  add("G1_Pa", g1);
  add("eta_Pa_s", [=](P p) { return p[2] * (g0(p) + g1(p)); });
  add("E_instantaneous_Pa", [=](P p) { return to_e * g0(p); });
  add("E_relaxed_Pa", [=](P p) { return to_e * p[0]; });
}

}  // namespace

CurveFit fit_standard_linear_solid(const continuum::BeadCurve& curve,
                                   double poisson,
                                   SolidForm form) {
  const auto ramp = find_ramp(curve);
  if (ramp.deviation > most_deviation) {
    throw ValueError(
        fmt::format("the displacement departs from a constant speed of {:.4g} um/s by {:.1f} % of "
                    "its depth; the standard linear "
                    "solid is fitted to a loading at constant speed (thesis eq. 3.26)",
                    ramp.speed * 1e6, 100.0 * ramp.deviation));
  }
  auto rows = loading_rows(curve, ramp.touch);
  const continuum::BeadShape shape{curve.radius, poisson};
  std::vector<double> stiff;  // F of 1 Pa
  for (const double t : rows.time)
    stiff.push_back(continuum::elastic_force(shape, 1.0, ramp.speed * t));
  const auto time = rows.time;
  const double end = time.back();
  const double shortest = 0.1 * end / static_cast<double>(time.size());
  const double g = amplitudes({stiff}, rows.force).values[0];
  if (!(g > 0.0)) throw ValueError("the force does not grow with the displacement");
  std::vector<std::vector<double>> starts;
  for (const double share : {0.003, 0.03, 0.3, 3.0}) {
    const double tau = share * end;
    std::vector<double> arm;
    for (std::size_t i = 0; i < time.size(); ++i)
      arm.push_back(stiff[i] * continuum::ramp_remainder(time[i] / tau));
    const auto a = amplitudes({stiff, arm}, rows.force);
    starts.push_back({std::max(a.values[0], 0.01 * g), std::max(a.values[1], 0.01 * g), tau});
  }
  const bool maxwell = form == SolidForm::maxwell;
  auto fit = fit_rows(
      curve, std::move(rows),
      {{maxwell ? "G0_Pa" : "G_relaxed_Pa", g, 1e-4 * g, 1e2 * g, true},
       {maxwell ? "G1_Pa" : "G_arm_Pa", g, 1e-4 * g, 1e4 * g, true},
       {"tau_s", 0.1 * end, std::min(shortest, 1e-4 * end), 1e3 * end, true}},
      [stiff, time](std::span<const double> p, std::size_t i) {
        return stiff[i] * (p[0] + p[1] * continuum::ramp_remainder(time[i] / p[2]));
      },
      starts);
  fit.facts.emplace_back("speed_m_s", ramp.speed);
  (maxwell ? add_maxwell_figures : add_kelvin_figures)(fit, poisson);
  return fit;
}

CurveFit fit_hertz(const continuum::BeadCurve& curve, double poisson) {
  auto rows = loading_rows(curve, curve.time.front() - 1.0);
  const continuum::HertzBead one{{curve.radius, poisson}, 1.0};
  std::vector<double> shape;
  for (const double d : rows.approach) shape.push_back(one.force(d));
  return fit_amplitude(curve, std::move(rows), "E_Pa", shape);
}

CurveFit fit_hooke(const continuum::BeadCurve& curve, const HookeOptions& options) {
  auto rows = loading_rows(curve, curve.time.front() - 1.0);
  std::vector<double> shape;
  for (const double d : rows.approach) shape.push_back(0.5 * d);
  auto fit = fit_amplitude(curve, std::move(rows), "stiffness_N_m", shape);
  const continuum::HookeBead bead{
      {curve.radius, options.poisson}, 1.0, options.density, options.characteristic_velocity};
  add_figure(fit, "E_Pa",
             [bead](std::span<const double> p) { return bead.youngs_modulus_of(p[0]); });
  return fit;
}

CurveFit fit_power_law(const continuum::BeadCurve& curve) {
  auto rows = loading_rows(curve, curve.time.front() - 1.0);
  const double end = rows.approach.back();
  const double most = positive_maximum(rows.force);
  const auto approach = rows.approach;
  return fit_rows(curve, std::move(rows),
                  {{"exponent", 1.5, 0.1, 10.0, false},
                   {"force_at_end_N", most, 1e-3 * most, 1e3 * most, true}},
                  [approach, end](std::span<const double> p, std::size_t i) {
                    return p[1] * std::pow(approach[i] / end, p[0]);
                  },
                  {{1.5, most}});
}

}  // namespace packbed::study
