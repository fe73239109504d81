// SPDX-License-Identifier: BSD-3-Clause
#include "study/wall_support_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/random.hpp"

namespace packbed::study {
namespace {

using continuum::CompressibleBed;
using continuum::PowerModulus;

constexpr double tolerance = 1e-10;  // of the integration within a fit
constexpr double near_collapse =
    0.999;  // of the critical velocity; beyond it the model is continued

struct ParameterInfo {
  BedParameter parameter;
  const char* name;
  double low, high;
  bool logarithmic;
};
constexpr std::array infos = {
    ParameterInfo{BedParameter::modulus, "B_Pa", 1e3, 1e8, true},
    ParameterInfo{BedParameter::bead_diameter, "bead_diameter_m", 1e-6, 1e-3, true},
    ParameterInfo{BedParameter::wall_friction, "wall_friction", 1e-3, 2.0, true},
    ParameterInfo{BedParameter::poisson, "poisson", 0.05, 0.4999, false},
    ParameterInfo{BedParameter::density_difference, "density_difference_kg_m3", 1.0, 2000.0, true},
    ParameterInfo{BedParameter::eps0, "settled_porosity", 0.3, 0.5, false},
    ParameterInfo{BedParameter::exponent, "exponent", 1.0, 4.0, false},
};

const ParameterInfo& info_of(BedParameter parameter) {
  return infos[static_cast<std::size_t>(parameter)];
}

void set_modulus(CompressibleBed& bed, double value) {
  if (auto* constant = std::get_if<continuum::ConstantModulus>(&bed.modulus))
    constant->modulus = value;
  if (auto* power = std::get_if<PowerModulus>(&bed.modulus)) power->modulus = value;
}

void set(CompressibleBed& bed, BedParameter parameter, double value) {
  switch (parameter) {
    case BedParameter::modulus:
      set_modulus(bed, value);
      return;
    case BedParameter::bead_diameter:
      bed.diameter = value;
      return;
    case BedParameter::wall_friction:
      bed.wall_friction = value;
      return;
    case BedParameter::poisson:
      bed.poisson = value;
      return;
    case BedParameter::density_difference:
      bed.density_difference = value;
      return;
    case BedParameter::eps0:
      bed.eps0 = value;
      return;
    case BedParameter::exponent:
      std::get<PowerModulus>(bed.modulus).exponent = value;
      return;
  }
}

continuum::WallSupportColumn column_of(const ColumnDatum& datum,
                                       const WallSupportFitOptions& options) {
  auto column = options.column;
  column.diameter = datum.diameter;
  column.height = datum.height;
  return column;
}

// Beyond collapse there is no model; the search needs one that leads back. Its values just below the critical
// velocity are raised with the distance.
ColumnModel continued(const CompressibleBed& bed,
                      const continuum::WallSupportColumn& column,
                      double u) {
  const double critical = continuum::critical_velocity(bed, column);
  const double distance = critical > 0.0 ? u / critical : 1e3;
  const auto r =
      continuum::try_wall_support(bed, column, std::min(u, near_collapse * critical), 2, tolerance);
  const double raise = std::min(1.0 + 5.0 * std::max(0.0, distance - near_collapse), 1e3);
  return r ? ColumnModel{r->pressure_drop_per_height * raise, r->compression * raise}
           : ColumnModel{1e9, 1.0};
}

ColumnModel model_at(const CompressibleBed& bed,
                     const ColumnDatum& datum,
                     const WallSupportFitOptions& options) {
  const auto column = column_of(datum, options);
  if (const auto r = continuum::try_wall_support(bed, column, datum.velocity, 2, tolerance)) {
    return {r->pressure_drop_per_height, r->compression};
  }
  return continued(bed, column, datum.velocity);
}

CompressibleBed bed_of(const CompressibleBed& bed,
                       const WallSupportFitOptions& options,
                       std::span<const double> values) {
  auto changed = bed;
  for (std::size_t i = 0; i < values.size(); ++i)
    set(changed, options.free[i].parameter, values[i]);
  return changed;
}

FitProblem problem_of(const CompressibleBed& bed,
                      const std::vector<ColumnDatum>& data,
                      const WallSupportFitOptions& options) {
  FitProblem problem;
  problem.known_errors = options.known_errors;
  for (const auto& datum : data)
    problem.rows += (datum.gradient ? 1U : 0U) + (datum.compression ? 1U : 0U);
  for (const auto& bound : options.free) {
    const auto& info = info_of(bound.parameter);
    const double start = value_of(bed, bound.parameter);
    if (!(start >= bound.low && start <= bound.high)) {
      throw ValueError(fmt::format("{} = {:.6g} does not lie between its bounds {:.6g} and {:.6g}",
                                   info.name, start, bound.low, bound.high));
    }
    problem.parameters.push_back({info.name, start, bound.low, bound.high, info.logarithmic});
  }
  problem.residuals = [&bed, &data, &options](std::span<const double> values, std::span<double> r) {
    const auto tried = bed_of(bed, options, values);
    std::size_t row = 0;
    for (const auto& datum : data) {
      const auto m = model_at(tried, datum, options);
      if (datum.gradient) r[row++] = (m.gradient - *datum.gradient) / datum.gradient_error;
      if (datum.compression)
        r[row++] = (m.compression - *datum.compression) / datum.compression_error;
    }
  };
  return problem;
}

// The bed given, and beds spread over a factor of four about it within the bounds, the same in every run.
std::vector<std::vector<double>> starts_of(const FitProblem& problem, int count) {
  std::vector<std::vector<double>> starts(1);
  for (const auto& p : problem.parameters) starts[0].push_back(p.start);
  for (int s = 1; s < count; ++s) {
    std::vector<double> start;
    for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
      const auto& p = problem.parameters[i];
      const double share = uniform(1, Stream::bead_size, static_cast<std::uint64_t>(s) * 64 + i);
      const double value = p.logarithmic ? p.start * std::pow(4.0, 2.0 * share - 1.0)
                                         : p.low + (p.high - p.low) * share;
      start.push_back(std::clamp(value, p.low * (p.logarithmic ? 1.01 : 1.0), p.high));
    }
    starts.push_back(std::move(start));
  }
  return starts;
}

void check(const CompressibleBed& bed, const WallSupportFitOptions& options) {
  const auto frees = [&](BedParameter p) {
    return std::ranges::find(options.free, p, &BedBound::parameter) != options.free.end();
  };
  if (frees(BedParameter::exponent) && !std::holds_alternative<PowerModulus>(bed.modulus)) {
    throw ValueError("the exponent can only be fitted with a stiffening bed (hertz or power)");
  }
  if (frees(BedParameter::modulus) &&
      std::holds_alternative<continuum::TabulatedModulus>(bed.modulus)) {
    throw ValueError(
        "a tabulated modulus is taken as it is; fit a constant or stiffening one, or leave the "
        "modulus out of the fit");
  }
  if (options.free.empty()) throw ValueError("no parameter is free");
}

void add_figures(const std::vector<ColumnDatum>& data,
                 const WallSupportFitOptions& options,
                 WallSupportFit& result) {
  std::vector<double> g, gm, l, lm;
  for (const auto& datum : data) {
    if (datum.velocity >= continuum::critical_velocity(result.bed, column_of(datum, options))) {
      throw DivergenceError(
          fmt::format("the best fit has no steady state at {:.4g} mm and {:.4g} cm/h, where there "
                      "are data; free more parameters, or let the bed stiffen",
                      datum.diameter * 1e3, datum.velocity * 3.6e5));
    }
    result.model.push_back(model_at(result.bed, datum, options));
    if (datum.gradient) {
      g.push_back(*datum.gradient);
      gm.push_back(result.model.back().gradient);
    }
    if (datum.compression) {
      l.push_back(*datum.compression);
      lm.push_back(result.model.back().compression);
    }
    result.largest_compression = std::max(
        result.largest_compression, datum.compression.value_or(result.model.back().compression));
  }
  if (!g.empty()) result.r2_gradient = r_squared(g, gm);
  if (!l.empty()) result.r2_compression = r_squared(l, lm);
  bool wall_is_free = false;
  for (const auto& b : options.free)
    wall_is_free = wall_is_free || b.parameter == BedParameter::wall_friction ||
                   b.parameter == BedParameter::poisson;
  if (!wall_is_free) return;
  // With mu_w and nu both free each is unknown, but not this: the error with the other one held.
  auto narrowed = options;
  std::erase_if(narrowed.free, [&](const BedBound& b) {
    return b.parameter == BedParameter::poisson &&
           std::ranges::find(options.free, BedParameter::wall_friction, &BedBound::parameter) !=
               options.free.end();
  });
  auto problem = problem_of(result.bed, data, narrowed);
  const auto fit = least_squares(problem);
  const auto coefficient = [&](std::span<const double> values) {
    const auto at = bed_of(result.bed, narrowed, values);
    return 4.0 * at.wall_friction * at.poisson / (1.0 - at.poisson);
  };
  result.wall_coefficient = derived(fit, "wall_coefficient", coefficient);
  if (options.intervals == Intervals::profile)
    profile_figure(problem, fit, coefficient, *result.wall_coefficient);
}

}  // namespace

std::string name_of(BedParameter parameter) { return info_of(parameter).name; }

double value_of(const CompressibleBed& bed, BedParameter parameter) {
  switch (parameter) {
    case BedParameter::modulus:
      if (const auto* c = std::get_if<continuum::ConstantModulus>(&bed.modulus)) return c->modulus;
      if (const auto* p = std::get_if<PowerModulus>(&bed.modulus)) return p->modulus;
      return 0.0;
    case BedParameter::bead_diameter:
      return bed.diameter;
    case BedParameter::wall_friction:
      return bed.wall_friction;
    case BedParameter::poisson:
      return bed.poisson;
    case BedParameter::density_difference:
      return bed.density_difference;
    case BedParameter::eps0:
      return bed.eps0;
    case BedParameter::exponent:
      break;
  }
  const auto* p = std::get_if<PowerModulus>(&bed.modulus);
  return p == nullptr ? 1.0 : p->exponent;
}

BedBound usual_bounds(BedParameter parameter) {
  const auto& info = info_of(parameter);
  return {parameter, info.low, info.high};
}

WallSupportFit fit_wall_support(const CompressibleBed& bed,
                                const std::vector<ColumnDatum>& data,
                                const WallSupportFitOptions& options) {
  check(bed, options);
  const auto problem = problem_of(bed, data, options);
  if (problem.rows <= problem.parameters.size()) least_squares(problem);  // refuses
  auto started = least_squares(problem, starts_of(problem, options.starts));
  WallSupportFit result;
  result.fit = std::move(started.fit);
  result.starts = started.starts;
  result.agreeing = started.agreeing;
  result.bed = bed_of(bed, options, result.fit.values());
  add_figures(data, options, result);
  if (options.intervals == Intervals::profile) profile_parameters(problem, result.fit);
  return result;
}

}  // namespace packbed::study
