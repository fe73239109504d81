// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/wall_support/wall_support.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "continuum/wall_support/bed_law.hpp"
#include "core/error.hpp"

namespace packbed::continuum {
namespace {

constexpr double finest = 1e-12;             // relative tolerance of the integration
constexpr unsigned long most_steps = 20000;  // between two rows of the profile

struct DriverDeleter {
  void operator()(gsl_odeiv2_driver* d) const noexcept { gsl_odeiv2_driver_free(d); }
};

/// The unknowns over the depth s that is given (Z or z): sigma, pressure lost, the other depth (z or Z), and the integral
/// of lambda.
enum Unknown : std::size_t { stress, pressure, other_depth, lambda_sum, unknowns };

template <class Law>
struct System {
  detail::BedBalance<Law> balance;
  double u;
};

template <class Law>
int derivatives(double /*s*/, const double y[], double dy[], void* context) {
  const auto& [balance, u] = *static_cast<const System<Law>*>(context);
  const double lambda = balance.law.compression(std::max(y[stress], 0.0));
  if (!(lambda < balance.bed.eps0))
    return GSL_EDOM;  // tried too long a step: GSL takes a shorter one
  const double shrink = balance.shrink(lambda);
  dy[stress] = shrink * balance.rise(lambda, y[stress], u);
  dy[pressure] = shrink * balance.resistance(lambda) * u;
  dy[other_depth] =
      balance.column.reading == Reading::material ? 1.0 - lambda : 1.0 / (1.0 - lambda);
  dy[lambda_sum] = lambda;
  return GSL_SUCCESS;
}

template <class Law>
std::optional<WallSupportResult> integrate(System<Law> system, int points, double tolerance) {
  const auto& column = system.balance.column;
  gsl_odeiv2_system ode{derivatives<Law>, nullptr, unknowns, &system};
  // Scales of the unknowns, below which errors do not count.
  const double scale =
      column.height * (system.balance.resistance(0.0) * system.u + system.balance.weight(0.0));
  const std::array<double, unknowns> size{std::max(scale, 1e-9), std::max(scale, 1e-9),
                                          column.height, column.height};
  const std::unique_ptr<gsl_odeiv2_driver, DriverDeleter> driver(
      gsl_odeiv2_driver_alloc_scaled_new(&ode, gsl_odeiv2_step_rk8pd, 1e-3 * column.height,
                                         tolerance, tolerance, 1.0, 0.0, size.data()));
  gsl_odeiv2_driver_set_hmin(driver.get(), 1e-14 * column.height);
  gsl_odeiv2_driver_set_nmax(driver.get(), most_steps);
  std::array<double, unknowns> y{};
  double s = 0.0;
  WallSupportResult r;
  for (int i = 0; i < points; ++i) {
    const double to = column.height * i / (points - 1);
    if (i > 0 && gsl_odeiv2_driver_apply(driver.get(), &s, to, y.data()) != GSL_SUCCESS) return {};
    const double lambda = system.balance.law.compression(std::max(y[stress], 0.0));
    const bool material = column.reading == Reading::material;
    r.profile.push_back({.z = material ? y[other_depth] : s,
                         .settled = material ? s : y[other_depth],
                         .stress = y[stress],
                         .compression = lambda,
                         .porosity = system.balance.porosity(lambda),
                         .pressure = y[pressure]});
  }
  const auto& bottom = r.profile.back();
  r.height = bottom.z;
  r.settled_height = bottom.settled;
  r.compression = y[lambda_sum] / column.height;
  r.pressure_drop = bottom.pressure;
  r.pressure_drop_per_height = r.pressure_drop / r.height;
  r.bottom_stress = bottom.stress;
  r.bottom_compression = bottom.compression;
  return r;
}

}  // namespace

std::optional<WallSupportResult> try_wall_support(const CompressibleBed& bed,
                                                  const WallSupportColumn& column,
                                                  double u,
                                                  int points,
                                                  double tolerance) {
  auto* before = gsl_set_error_handler_off();
  auto result = std::visit(
      [&](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        return integrate(System<Law>{{bed, column, law}, u}, points, tolerance);
      },
      bed.modulus);
  gsl_set_error_handler(before);
  return result;
}

WallSupportResult wall_support(const CompressibleBed& bed,
                               const WallSupportColumn& column,
                               double u,
                               int points) {
  constexpr double cm_h = 3.6e5;  // of 1 m/s
  const double critical = critical_velocity(bed, column);
  if (u >= critical) {
    throw DivergenceError(
        fmt::format("no steady state above u_crit = {:.6g} cm/h (asked for {:.6g} cm/h): the pores "
                    "close at the bottom of the bed",
                    critical * cm_h, u * cm_h));
  }
  auto result = try_wall_support(bed, column, u, points, finest);
  if (!result) {
    throw DivergenceError(
        fmt::format("the bed is too near collapse to be integrated: u_crit = {:.12g} cm/h, asked "
                    "for {:.12g} cm/h",
                    critical * cm_h, u * cm_h));
  }
  return std::move(*result);
}

}  // namespace packbed::continuum
