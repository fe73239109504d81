// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "continuum/bead/plate_contact.hpp"
#include "core/error.hpp"
#include "study/curve_fit.hpp"

namespace packbed::study {
namespace {

constexpr int most_terms = 4;
constexpr int grid_times = 12;          // relaxation times tried for a start
constexpr std::size_t grid_rows = 150;  // rows used for that
constexpr std::size_t kept_starts = 4;

/// Rows of a curve while it is held, with time from the end of the ramp.
struct Hold {
  std::vector<double> time, force;
  double depth = 0.0;
  double ramp_time = 0.0;
};

Hold find_hold(const continuum::BeadCurve& curve, const PronyOptions& options) {
  Hold hold;
  double end_of_ramp = 0.0;
  if (options.ramp_time) {
    const double top = *std::ranges::max_element(curve.approach);
    const auto first =
        std::ranges::find_if(curve.approach, [&](double d) { return d >= 0.98 * top; });
    end_of_ramp = curve.time[static_cast<std::size_t>(first - curve.approach.begin())];
    hold.ramp_time = *options.ramp_time;
    hold.depth = top;
  } else {
    try {
      const auto ramp = find_ramp(curve);
      hold.depth = ramp.depth;
      hold.ramp_time = ramp.depth / ramp.speed;
      end_of_ramp = ramp.touch + hold.ramp_time;
    } catch (const ValueError& error) {
      throw ValueError(fmt::format("{}; give --ramp-time (\"0 s\" for a step)", error.what()));
    }
  }
  const double slack = 1e-9 * (curve.time.back() - curve.time.front());
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    if (curve.time[i] < end_of_ramp - slack) continue;
    if (curve.approach[i] < 0.98 * hold.depth) break;
    hold.time.push_back(std::max(curve.time[i] - end_of_ramp, 0.0));
    hold.force.push_back(curve.force[i]);
    sum += curve.approach[i];
  }
  if (hold.time.empty()) throw ValueError("no row is left after the end of the ramp");
  if (options.ramp_time) hold.depth = sum / static_cast<double>(hold.time.size());
  return hold;
}

std::vector<double> decay(const std::vector<double>& time, double tau) {
  std::vector<double> values;
  values.reserve(time.size());
  for (const double t : time) values.push_back(std::exp(-t / tau));
  return values;
}

// All choices of `count` out of 0..size-1, in ascending order.
std::vector<std::vector<int>> choices(int size, int count) {
  std::vector<std::vector<int>> all;
  std::vector<int> chosen;
  const auto choose = [&](auto&& self, int from) -> void {
    if (static_cast<int>(chosen.size()) == count) {
      all.push_back(chosen);
      return;
    }
    for (int i = from; i < size; ++i) {
      chosen.push_back(i);
      self(self, i + 1);
      chosen.pop_back();
    }
  };
  choose(choose, 0);
  return all;
}

// Starts: relaxation times from a grid, amplitudes by linear least squares; the best ones.
std::vector<std::vector<double>> prony_starts(const std::vector<double>& time,
                                              const std::vector<double>& force,
                                              int terms,
                                              double shortest,
                                              double longest) {
  std::vector<double> t, f;
  const std::size_t stride = std::max<std::size_t>(1, time.size() / grid_rows);
  for (std::size_t i = 0; i < time.size(); i += stride) {
    t.push_back(time[i]);
    f.push_back(force[i]);
  }
  std::vector<double> taus;
  std::vector<std::vector<double>> decays;
  for (int i = 0; i < grid_times; ++i) {
    taus.push_back(longest *
                   std::pow(shortest / longest, i / (grid_times - 1.0)));  // longest first
    decays.push_back(decay(t, taus.back()));
  }
  const double least = 1e-3 * *std::ranges::max_element(f);
  std::vector<std::pair<double, std::vector<double>>> ranked;
  for (const auto& chosen : choices(grid_times, terms)) {
    std::vector<std::vector<double>> basis{std::vector<double>(t.size(), 1.0)};
    for (const int i : chosen) basis.push_back(decays[static_cast<std::size_t>(i)]);
    const auto a = amplitudes(basis, f);
    std::vector<double> start{std::max(a.values[0], least)};
    double rank = a.sum_of_squares;
    for (int k = 0; k < terms; ++k) {
      const double amplitude = a.values[static_cast<std::size_t>(k) + 1];
      if (amplitude < least) rank *= 4.0;  // not an answer, but perhaps near one
      start.push_back(std::max(amplitude, least));
      start.push_back(taus[static_cast<std::size_t>(chosen[static_cast<std::size_t>(k)])]);
    }
    ranked.emplace_back(rank, std::move(start));
  }
  std::ranges::sort(ranked);
  std::vector<std::vector<double>> starts;
  for (std::size_t i = 0; i < std::min(kept_starts, ranked.size()); ++i)
    starts.push_back(ranked[i].second);
  return starts;
}

double prony_force(std::span<const double> p, double t) {
  double force = p[0];
  for (std::size_t k = 1; k + 1 < p.size(); k += 2) force += p[k] * std::exp(-t / p[k + 1]);
  return force;
}

// tau_1 > tau_2 > ...: the order of the thesis. Exchanges pairs (B, tau) with their errors.
void sort_terms(Fit& fit, int terms) {
  const std::size_t n = fit.size();
  std::vector<std::size_t> order(static_cast<std::size_t>(terms));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::sort(order, std::greater{},
                    [&](std::size_t k) { return fit.estimates[2 * k + 2].value; });
  std::vector<std::size_t> from{0};
  for (const auto k : order) {
    from.push_back(2 * k + 1);
    from.push_back(2 * k + 2);
  }
  const auto before = fit;
  for (std::size_t a = 0; a < n; ++a) {
    fit.estimates[a] = before.estimates[from[a]];
    fit.estimates[a].name = before.parameters[a].name;
    fit.parameters[a] = before.parameters[from[a]];
    fit.parameters[a].name = before.parameters[a].name;
    for (std::size_t b = 0; b < n; ++b) {
      fit.covariance[a * n + b] = before.covariance[from[a] * n + from[b]];
      fit.correlation[a * n + b] = before.correlation[from[a] * n + from[b]];
    }
  }
}

void add_moduli(CurveFit& fit,
                int terms,
                const continuum::BeadShape& shape,
                const Hold& hold,
                RampCorrection correction) {
  const double scale = shape.factor() * hold.depth * std::sqrt(hold.depth);
  const auto coefficient = [=](std::span<const double> p, int i) {  // C_i, eqs 3.29, 3.30
    if (i == 0) return p[0] / scale;
    const auto k = static_cast<std::size_t>(2 * i - 1);
    return p[k] / scale / ramp_correction(correction, hold.ramp_time / p[k + 1]);
  };
  for (int i = 0; i <= terms; ++i) {
    add_figure(fit, fmt::format("C{}_Pa", i),
               [=](std::span<const double> p) { return coefficient(p, i); });
  }
  const auto at_once = [=](std::span<const double> p) {  // eq. 3.32
    double sum = 0.0;
    for (int i = 0; i <= terms; ++i) sum += coefficient(p, i);
    return 0.5 * sum;
  };
  const auto relaxed = [=](std::span<const double> p) {
    return 0.5 * coefficient(p, 0);
  };  // eq. 3.33
  const double to_e = 2.0 * (1.0 + shape.poisson);
  add_figure(fit, "G_instantaneous_Pa", at_once);
  add_figure(fit, "G_relaxed_Pa", relaxed);
  add_figure(fit, "E_instantaneous_Pa",
             [=](std::span<const double> p) { return to_e * at_once(p); });
  add_figure(fit, "E_relaxed_Pa", [=](std::span<const double> p) { return to_e * relaxed(p); });
}

}  // namespace

CurveFit fit_prony_terms(const std::vector<double>& time,
                         const std::vector<double>& force,
                         int terms) {
  const double most = *std::ranges::max_element(force);
  if (!(most > 0.0)) throw ValueError("the force is nowhere positive");
  const double span = time.back() - time.front();
  if (!(span > 0.0)) throw ValueError("all rows have the same time");
  const double step = span / static_cast<double>(time.size());
  CurveFit fit;
  auto& problem = fit.problem;
  problem.rows = time.size();
  problem.parameters.push_back({"B0_N", most, 1e-6 * most, 1e3 * most, true});
  for (int i = 1; i <= terms; ++i) {
    problem.parameters.push_back(
        {fmt::format("B{}_N", i), 0.1 * most, 1e-6 * most, 1e3 * most, true});
    problem.parameters.push_back({fmt::format("tau{}_s", i), span, 0.1 * step, 1e3 * span, true});
  }
  problem.residuals = [time, force, most](std::span<const double> p, std::span<double> r) {
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (prony_force(p, time[i]) - force[i]) / most;
  };
  if (problem.rows <= problem.parameters.size()) least_squares(problem);  // refuses
  problem.starts = prony_starts(time, force, terms, step, 3.0 * span);
  auto started = least_squares(problem, problem.starts);
  sort_terms(started.fit, terms);
  fit.fit = std::move(started.fit);
  fit.starts = started.starts;
  fit.agreeing = started.agreeing;
  fit.x = time;
  fit.data = force;
  const auto values = fit.fit.values();
  for (const double t : time) fit.model.push_back(prony_force(values, t));
  fit.r2 = r_squared(fit.data, fit.model);
  return fit;
}

PronyFit fit_prony(const continuum::BeadCurve& curve, const PronyOptions& options) {
  const auto hold = find_hold(curve, options);
  PronyFit result;
  const int first = options.terms.value_or(1);
  const int last = options.terms.value_or(most_terms);
  for (int n = first; n <= last; ++n) {
    const auto rows = hold.time.size();
    if (n > first && rows <= 2 * static_cast<std::size_t>(n) + 1) break;
    auto fit = fit_prony_terms(hold.time, hold.force, n);
    result.bic.push_back(fit.fit.bic());
    if (n == first || result.bic.back() < result.best.fit.bic()) {
      result.best = std::move(fit);
      result.terms = n;
    }
  }
  if (options.terms) result.bic.clear();
  result.best.curve = curve.name;
  result.best.facts = {
      {"depth_m", hold.depth}, {"ramp_time_s", hold.ramp_time}, {"radius_m", curve.radius}};
  add_moduli(result.best, result.terms, {curve.radius, options.poisson}, hold, options.correction);
  return result;
}

}  // namespace packbed::study
