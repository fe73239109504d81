// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Viscoelastic beads: every model is a relaxing shear modulus
///   G(t) = G_inf + sum_i G_i exp(-t / tau_i)
/// and one superposition integral, thesis eqs 3.23 and C.20:
///   F(t) = sqrt(2R) / (3 (1 - nu)) integral_0^t 2 G(t - s) d(Delta^(3/2)(s))
/// Derivations: docs/theory/bead.md.

#include <vector>

#include "continuum/bead/loading.hpp"
#include "continuum/bead/plate_contact.hpp"

namespace packbed::continuum {

struct RelaxationTerm {
  double modulus = 0.0;  ///< G_i [Pa]
  double time = 0.0;     ///< tau_i [s]
};

struct ShearRelaxation {
  double relaxed = 0.0;  ///< G_inf [Pa]
  std::vector<RelaxationTerm> terms;

  [[nodiscard]] double at(double t) const;
  [[nodiscard]] double instantaneous() const { return at(0.0); }
};

/// Spring G0 beside a spring G1 and dashpot eta in series: G0 + G1 exp(-t G1/eta). Thesis eqs 3.25, C.19.
/// (Its text calls G1 "modulus of the dashpot"; it is that of the spring in the Maxwell arm. Table 6.4
/// prints eta in Pa s for MPa s.)
ShearRelaxation sls_maxwell(double g0, double g1, double eta);

/// Spring G0 in series with a spring G1 beside a dashpot eta:
///   G0/(G0+G1) (G1 + G0 exp(-t (G0+G1)/eta)). Thesis eqs C.14, C.15; the time constant of eqs C.22 to C.33
/// is this one, not eta/G1.
ShearRelaxation sls_kelvin(double g0, double g1, double eta);

/// Prony series C_0 + sum C_i exp(-t/tau_i), which stands for 2 G(t): moduli are halves of the C. Thesis
/// eqs 3.27, 3.32, 3.33.
ShearRelaxation prony(double c0, const std::vector<RelaxationTerm>& c);

/// What remains of a unit stress put on by a ramp Delta ~ t over x relaxation times, at its end:
///   j(x) = 3/(2x) (1 - Dawson(sqrt x) / sqrt x),  j(0) = 1,  j -> 3/(2x)
/// This is the bracket of eq. 3.26 with (sqrt(pi)/2) exp(-x) erfi(sqrt x) = Dawson(sqrt x), which does not
/// overflow. Accurate to some 1e-14 for any x >= 0.
double ramp_remainder(double x);

struct ViscoelasticBead {
  BeadShape shape;
  ShearRelaxation relaxation;

  /// F at time t since first touch. While loading, thesis eq. 3.26; while held, the same terms decay;
  /// while unloading, Ting's solution (J. Appl. Mech. 33 (1966) 845) for a shrinking contact: the force
  /// is that of the loading up to the time at which the contact had the present radius, and 0 once the
  /// plate has left the bead.
  [[nodiscard]] double force(const Loading& loading, double t) const;
};

}  // namespace packbed::continuum
