// SPDX-License-Identifier: BSD-3-Clause
#include "study/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace packbed::study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Figure = std::function<double(std::span<const double>)>;

// Stiffness of the spring that draws the figure to its place, in that of the misfit about its minimum.
constexpr double spring = 30.0;
constexpr double accuracy = 1e-3;    // of the interval, in standard deviations
constexpr double least_gain = 1e-5;  // of a step in the sum of squares, in variances
constexpr double reach = 0.02;       // of the figure: places nearer than this are at the same one
constexpr int most_searches = 40;    // fits per side
// Share of the range of a parameter: nearer to its bound it rests on it.
constexpr double free_share = 1e-3;
// Of residuals of order 1: below, they are round-off.
constexpr double least_variance = 1e-20;
// Of the way asked for: if the figure goes less, a bound of some parameter holds it.
constexpr double stuck_share = 0.3;

/// A place on the profile: the figure in standard deviations from its best value, and the square root of the growth of
/// the sum of squares in the same measure. On a parabola both are equal.
struct Place {
  double x = 0.0, z = 0.0;
  std::vector<double> values;
};

/// One figure of a fit, on the axis on which it is nearly normal.
struct Profile {
  const FitProblem& problem;
  const Fit& fit;
  Figure axis;                                ///< figure or its logarithm
  double center = 0.0;                        ///< axis at the best fit
  double deviation = 1.0;                     ///< linear standard error on the axis
  double variance = 1.0;                      ///< of a residual
  std::optional<std::size_t> parameter = {};  ///< if the figure is one
};

// From one list of values towards another and, with share > 1, beyond.
std::vector<double> towards(const FitProblem& problem,
                            const std::vector<double>& from,
                            const std::vector<double>& to,
                            double share) {
  auto values = from;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& p = problem.parameters[i];
    const double linear = from[i] + share * (to[i] - from[i]);
    values[i] = p.logarithmic && !(linear > 0.2 * to[i])
                    ? from[i] * std::pow(to[i] / from[i], share)
                    : linear;
    if (std::isfinite(p.low)) values[i] = std::clamp(values[i], p.low, p.high);
  }
  return values;
}

// The least misfit with the figure near x. A residual is added that draws it there by a spring: where that comes to
// rest the misfit is the least of all with the same figure, whether or not the figure has come all the way.
Place place_from(const Profile& p, double x, const std::vector<double>& start) {
  FitProblem held = p.problem;
  for (std::size_t i = 0; i < start.size(); ++i) held.parameters[i].start = start[i];
  ++held.rows;
  const double scale = std::sqrt(p.variance) * spring;
  const auto at = [&](std::span<const double> v) { return (p.axis(v) - p.center) / p.deviation; };
  held.residuals = [&](std::span<const double> v, std::span<double> r) {
    p.problem.residuals(v, r.first(r.size() - 1));
    r.back() = scale * (at(v) - x);
  };
  const auto fit = least_squares_values(held, least_gain * p.variance);
  Place place{.values = fit.values()};
  place.x = at(place.values);
  const double pull = scale * (place.x - x);
  const double growth = fit.sum_of_squares - pull * pull - p.fit.sum_of_squares;
  place.z = std::sqrt(std::max(growth, 0.0) / p.variance);
  return place;
}

// The same; what seems to be beyond the limit is sought from the other starts, too.
Place place_near(const Profile& p, double x, const std::vector<double>& start) {
  auto best = place_from(p, x, start);
  for (auto other : p.problem.starts) {
    if (best.z < p.fit.quantile) break;
    if (p.parameter) other[*p.parameter] = best.values[*p.parameter];
    auto place = place_from(p, x, other);
    // The spring has come to rest elsewhere: only what is as far out can say more.
    if (place.z < best.z && std::abs(place.x) >= (1.0 - reach) * std::abs(best.x))
      best = std::move(place);
  }
  return best;
}

// Between two places on either side of the limit: by straight lines in z, kept from creeping (Illinois).
double between(const Profile& p, Place inner, Place outer, double limit) {
  double inner_gap = inner.z - limit;
  double outer_gap = outer.z - limit;
  int last = 0;
  for (int i = 0; i < most_searches; ++i) {
    const double share = inner_gap / (inner_gap - outer_gap);
    const double x = inner.x + (outer.x - inner.x) * share;
    auto place = place_near(p, x, towards(p.problem, inner.values, outer.values, share));
    const double gap = place.z - limit;
    if (std::abs(gap) < accuracy || std::abs(outer.x - inner.x) < accuracy) return place.x;
    if (gap < 0.0) {
      inner = std::move(place);
      inner_gap = gap;
      if (last < 0) outer_gap *= 0.5;
      last = -1;
    } else {
      outer = std::move(place);
      outer_gap = gap;
      if (last > 0) inner_gap *= 0.5;
      last = 1;
    }
  }
  return outer.x;
}

// Where the profile reaches the limit on one side (sign), in standard deviations; infinite if it does not before `end`.
double limit_of(const Profile& p, double sign, double end) {
  const double limit = p.fit.quantile;
  Place inner{.values = p.fit.values()};
  auto start = inner.values;
  double x = limit;
  for (int i = 0; i < most_searches; ++i) {
    const bool last = x >= end;
    x = std::min(x, end);
    auto outer = place_near(p, sign * x, start);
    if (outer.z >= limit) return between(p, std::move(inner), std::move(outer), limit);
    const double way = sign * (outer.x - inner.x);
    if (last || !(way > stuck_share * (x - sign * inner.x))) return sign * infinity;
    // On to where a straight line would be a little past the limit, within reason.
    x *= std::clamp(1.05 * limit / std::max(outer.z, 1e-9), 1.2, 3.0);
    const double share = (x - sign * inner.x) / way;
    start = towards(p.problem, inner.values, outer.values, share);
    inner = std::move(outer);
  }
  return sign * infinity;
}

// Where the linear error is infinite, for the parameters are confounded, the figure may be known all the same.
void find_deviation(Profile& p) {
  for (int i = 0; i < most_searches; ++i) {
    const auto place = place_near(p, 1.0, p.fit.values());
    if (!(place.z > 2.0) || !(place.x > 0.0)) return;
    p.deviation *= place.x / place.z;
  }
}

double variance_of(const FitProblem& problem, const Fit& fit) {
  return problem.known_errors ? 1.0
                              : fit.sum_of_squares / static_cast<double>(problem.rows - fit.size());
}

/// On what axis, and how far it goes on either side of the best value.
struct Axis {
  bool logarithmic = false;
  double down = infinity, up = infinity;
};

void set_interval(const FitProblem& problem,
                  const Fit& fit,
                  const Figure& figure,
                  const Axis& axis,
                  std::optional<std::size_t> parameter,
                  Estimate& e) {
  const double variance = variance_of(problem, fit);
  if (!(variance > least_variance)) return;
  const double tiny = 1e-9 * e.value;
  const auto on_axis = [&](double v) { return axis.logarithmic ? std::log(std::max(v, tiny)) : v; };
  // A standard error that is unknown or absurd still needs a measure.
  const double most = axis.logarithmic ? 1.0 : std::abs(e.value) + tiny;
  const double error = axis.logarithmic ? e.error / e.value : e.error;
  Profile p{.problem = problem,
            .fit = fit,
            .axis = [&](std::span<const double> v) { return on_axis(figure(v)); },
            .center = on_axis(e.value),
            .deviation = std::isfinite(error) && error > 0.0 ? std::min(error, most) : most,
            .variance = variance,
            .parameter = parameter};
  if (!std::isfinite(error)) find_deviation(p);
  const auto side = [&](double sign, double way) {
    const double x = way > 0.0 ? limit_of(p, sign, way / p.deviation) : sign * infinity;
    const double at = p.center + x * p.deviation;
    return axis.logarithmic && std::isfinite(x) ? std::exp(at) : at;
  };
  e.low = side(-1.0, axis.down);
  e.high = side(1.0, axis.up);
}

}  // namespace

void profile_parameters(const FitProblem& problem, Fit& fit) {
  for (std::size_t k = 0; k < fit.size(); ++k) {
    const auto& q = problem.parameters[k];
    auto& e = fit.estimates[k];
    Axis axis{.logarithmic = q.logarithmic};
    if (std::isfinite(q.low)) {
      const auto on_axis = [&](double v) { return q.logarithmic ? std::log(v) : v; };
      const double margin = free_share * (on_axis(q.high) - on_axis(q.low));
      axis.down = on_axis(e.value) - on_axis(q.low) - margin;
      axis.up = on_axis(q.high) - on_axis(e.value) - margin;
    }
    set_interval(
        problem, fit, [k](std::span<const double> v) { return v[k]; }, axis, k, e);
  }
}

void profile_figure(const FitProblem& problem,
                    const Fit& fit,
                    const Figure& figure,
                    Estimate& estimate) {
  set_interval(problem, fit, figure, {.logarithmic = estimate.value > 0.0}, std::nullopt, estimate);
}

}  // namespace packbed::study
