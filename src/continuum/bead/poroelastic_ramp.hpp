// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "continuum/bead/loading.hpp"
#include "continuum/bead/poroelastic.hpp"

namespace packbed::continuum {

/// Share of the excess F_0 - F_inf that is left at time t of a ramp Delta ~ t of length T and a hold after it:
///   phi = 3/2 integral_0^1 sqrt(x) g(D (t - x t') / a(t')^2) dx,   t' = min(t, T)
/// Superposition of steps in Delta^(3/2), each relaxing by g of the PRESENT contact radius. AN APPROXIMATION: the
/// contact grows during the ramp, and neither its size at the time of a step nor the present one is right for that
/// step. Exact are: a step (T = 0: g itself), the fast ramp (1), the slow one (0), and that phi does not change during
/// a ramp, for D t/a^2 = D/(R v), v = Delta'/2. With the radius at the time of each step phi would be smaller, by 0.14
/// at most: a measure of the error, no bound; docs/theory/bead.md, section 3.
/// `rate` is D/a(t')^2 [1/s]; times in s.
double poroelastic_excess(double rate, double t, double ramp_time);

/// Force at time t of a ramp and the hold after it. Not for unloading: the contact shrinks.
double poroelastic_force(const PoroelasticBead& bead, const Loading& loading, double t);

}  // namespace packbed::continuum
