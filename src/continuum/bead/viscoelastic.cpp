// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/bead/viscoelastic.hpp"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/roots.hpp>
#include <gsl/gsl_sf_dawson.h>

namespace packbed::continuum {
namespace {

// 2 G at the end of a ramp of length `ramp`, `later` after it: the remainder of each term decays.
double doubled_modulus(const ShearRelaxation& g, double ramp, double later) {
  double sum = g.relaxed;
  for (const auto& [modulus, tau] : g.terms) {
    sum += modulus * ramp_remainder(ramp / tau) * std::exp(-later / tau);
  }
  return 2.0 * sum;
}

// integral of G(t - s) ds from a to b, a <= b <= t.
double impulse(const ShearRelaxation& g, double t, double a, double b) {
  double sum = g.relaxed * (b - a);
  for (const auto& [modulus, tau] : g.terms) {
    sum += modulus * tau * std::exp(-(t - b) / tau) * -std::expm1(-(b - a) / tau);
  }
  return sum;
}

// Ting: the contact at time t of the unloading is as large as it was at the time t1 of the ramp for which
//   integral_t1^t G(t - s) dDelta(s) = 0. Negative if the plate has left the bead.
double time_of_same_contact(const ShearRelaxation& g, const Loading& loading, double t) {
  const double back = impulse(g, t, loading.unload_start(), t);
  const auto excess = [&](double t1) { return impulse(g, t, t1, loading.ramp_time) - back; };
  const double at_start = excess(0.0);
  if (at_start <= 0.0) return -1.0;
  const double at_end = excess(loading.ramp_time);
  if (at_end >= 0.0) return loading.ramp_time;
  std::uintmax_t steps = 200;
  const auto [low, high] =
      boost::math::tools::toms748_solve(excess, 0.0, loading.ramp_time, at_start, at_end,
                                        boost::math::tools::eps_tolerance<double>(50), steps);
  return 0.5 * (low + high);
}

}  // namespace

double ShearRelaxation::at(double t) const {
  double sum = relaxed;
  for (const auto& [modulus, tau] : terms) sum += modulus * std::exp(-t / tau);
  return sum;
}

ShearRelaxation sls_maxwell(double g0, double g1, double eta) {
  return {.relaxed = g0, .terms = {{.modulus = g1, .time = eta / g1}}};
}

ShearRelaxation sls_kelvin(double g0, double g1, double eta) {
  const double sum = g0 + g1;
  return {.relaxed = g0 * g1 / sum, .terms = {{.modulus = g0 * g0 / sum, .time = eta / sum}}};
}

ShearRelaxation prony(double c0, const std::vector<RelaxationTerm>& c) {
  ShearRelaxation g{.relaxed = 0.5 * c0, .terms = c};
  for (auto& term : g.terms) term.modulus *= 0.5;
  return g;
}

double ramp_remainder(double x) {
  if (x > 0.5) {
    const double root = std::sqrt(x);
    return 1.5 / x * (1.0 - gsl_sf_dawson(root) / root);
  }
  // The series of Dawson's function, sum (-2x)^n / (2n+1)!!, where the difference above cancels.
  double term = 1.0;
  double sum = 1.0;
  for (int n = 1; std::abs(term) > 1e-17; ++n) {
    term *= -2.0 * x / (2.0 * n + 3.0);
    sum += term;
  }
  return sum;
}

double ViscoelasticBead::force(const Loading& loading, double t) const {
  if (t <= 0.0 && loading.ramp_time > 0.0) return 0.0;
  const auto times_delta = [&](double approach) {
    return shape.factor() * approach * std::sqrt(approach);
  };
  if (t < loading.ramp_time) {
    return times_delta(loading.approach(t)) * doubled_modulus(relaxation, t, 0.0);
  }
  if (t <= loading.unload_start()) {
    return times_delta(loading.depth) *
           doubled_modulus(relaxation, loading.ramp_time, t - loading.ramp_time);
  }
  const double t1 = time_of_same_contact(relaxation, loading, t);
  if (t1 <= 0.0) return 0.0;
  return times_delta(loading.speed() * t1) * doubled_modulus(relaxation, t1, t - t1);
}

}  // namespace packbed::continuum
