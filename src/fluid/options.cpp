// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/options.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::fluid {
namespace {

void require(bool good, const char* name, double value, const char* accepted) {
  if (good) return;
  throw ValueError(
      fmt::format("{} = {} of the liquid is refused; accepted: {}", name, value, accepted));
}

}  // namespace

void FluidOptions::check() const {
  const auto in = [](double value, double low, double high) { return value > low && value < high; };
  require(in(rho_f, 0.0, 1e6), "rho_f", rho_f, "above 0 kg/m3");
  require(in(mu_f, 0.0, 1e6), "mu_f", mu_f, "above 0 Pa s");
  require(crank_nicolson >= 0.0 && crank_nicolson <= 1.0, "crank_nicolson", crank_nicolson,
          "0 (Euler) to 1 (Crank-Nicolson)");
  require(correctors >= 1 && correctors <= 100, "correctors", correctors, "1 to 100");
  require(in(pressure_tolerance, 0.0, 1.0), "pressure_tolerance", pressure_tolerance,
          "above 0, below 1");
  require(in(momentum_tolerance, 0.0, 1.0), "momentum_tolerance", momentum_tolerance,
          "above 0, below 1");
  require(most_iterations >= 1, "most_iterations", most_iterations, "at least 1");
}

}  // namespace packbed::fluid
