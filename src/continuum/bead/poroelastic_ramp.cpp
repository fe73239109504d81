// SPDX-License-Identifier: BSD-3-Clause
#include "continuum/bead/poroelastic_ramp.hpp"

#include <algorithm>

#include <boost/math/quadrature/gauss_kronrod.hpp>

namespace packbed::continuum {

double poroelastic_excess(double rate, double t, double ramp_time) {
  const double loaded = std::min(t, ramp_time);
  if (loaded <= 0.0) return poroelastic_relaxation(rate * std::max(t, 0.0));
  // x = 1 - w^2: smooth where g falls with the square root of the time, at the end of the ramp.
  const auto share = [&](double w) {
    const double x = (1.0 - w) * (1.0 + w);
    return 3.0 * w * std::sqrt(x) * poroelastic_relaxation(rate * ((t - loaded) + loaded * w * w));
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(share, 0.0, 1.0, 15, 1e-11);
}

double poroelastic_force(const PoroelasticBead& bead, const Loading& loading, double t) {
  const double approach = loading.approach(t);
  if (!(approach > 0.0)) return 0.0;
  const double a = contact_radius(bead.shape, approach);
  const double f_inf = bead.final_force(approach);
  return f_inf + (bead.initial_force(approach) - f_inf) *
                     poroelastic_excess(bead.diffusivity / (a * a), t, loading.ramp_time);
}

}  // namespace packbed::continuum
