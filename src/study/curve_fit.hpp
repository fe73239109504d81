// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Models of continuum/bead fitted to measured curves. Names of figures end in their SI unit: "G0_Pa".

#include <optional>
#include <string>
#include <vector>

#include "continuum/bead/curve.hpp"
#include "study/least_squares.hpp"
#include "study/profile.hpp"

namespace packbed::study {

/// One curve fitted.
struct CurveFit {
  std::string curve;
  Fit fit;                        ///< parameters as they were fitted
  std::vector<Estimate> figures;  ///< what follows: moduli, viscosity
  std::vector<std::pair<std::string, double>>
      facts;  ///< known, not fitted: "ramp_time_s", "depth_m"
  int starts = 1;
  int agreeing = 1;
  double r2 = 0.0;
  std::vector<double> x;      ///< of the rows used: time [s] or displacement [m]
  std::vector<double> data;   ///< force [N]
  std::vector<double> model;  ///< force [N]
  FitProblem problem;         ///< what `fit` solves; it holds copies of the data
  std::vector<std::function<double(std::span<const double>)>>
      figures_of;  ///< each figure from the parameters
};

/// Adds a figure that follows from the parameters, with its error.
void add_figure(CurveFit& fit,
                const std::string& name,
                const std::function<double(std::span<const double>)>& figure);

/// Makes all intervals anew by profile likelihood (profile.hpp). Some dozen fits per figure.
void profile_intervals(CurveFit& fit);

/// By name among parameters and figures. Null if it has none.
const Estimate* find(const CurveFit& fit, const std::string& name);

/// A fact by name, if the fit has it.
std::optional<double> fact(const CurveFit& fit, const std::string& name);

/// How C_i follows from the amplitude B_i that is left of a term when the ramp of length T ends,
/// C_i = B_i / (factor c(T / tau_i)); see docs/theory/bead.md, section 4.
enum class RampCorrection {
  exact,    ///< c = j, for Delta ~ t (viscoelastic.hpp)
  mattice,  ///< c = (1 - exp(-x)) / x: eq. 3.31 with time from first touch; takes Delta^(3/2) ~ t
  thesis,  ///< c = (exp(x) - 1) / x: eq. 3.31 with time from the END of the ramp, as table 6.5 was made
  none,  ///< c = 1: a step
};
double ramp_correction(RampCorrection kind, double x);

struct PronyOptions {
  double poisson = 0.0;
  std::optional<int> terms = {};  ///< 1 to 4; by default as many as the criterion (BIC) asks for
  std::optional<double> ramp_time = {};  ///< [s]; by default from the displacements
  RampCorrection correction = RampCorrection::exact;
};

/// F = B_0 + sum B_i exp(-t/tau_i) with t from the end of the ramp (thesis eq. 3.28), tau_1 > tau_2 > ..., fitted
/// while the displacement is held; and the moduli of eqs 3.29 to 3.33. Parameters B0_N, B1_N, tau1_s, ...
struct PronyFit {
  CurveFit best;
  int terms = 0;
  std::vector<double> bic;  ///< of 1, 2, ... terms, where the number was chosen here
};
PronyFit fit_prony(const continuum::BeadCurve& curve, const PronyOptions& options);

/// The same for rows of time since the end of the ramp and force: what fit_prony does within.
CurveFit fit_prony_terms(const std::vector<double>& time,
                         const std::vector<double>& force,
                         int terms);

enum class SolidForm { maxwell, kelvin };
/// Thesis eq. 3.26 (or C.33 with tau_K = eta/(G0+G1)) fitted to the loading at constant speed.
CurveFit fit_standard_linear_solid(const continuum::BeadCurve& curve,
                                   double poisson,
                                   SolidForm form);

/// Hertz's law fitted to the loading: E_Pa.
CurveFit fit_hertz(const continuum::BeadCurve& curve, double poisson);

/// The linear spring of eq. 4.21: stiffness_N_m, and the E that belongs to the velocity.
struct HookeOptions {
  double poisson = 0.0;
  double density = 0.0;                  ///< [kg/m3]
  double characteristic_velocity = 0.0;  ///< [m/s]
};
CurveFit fit_hooke(const continuum::BeadCurve& curve, const HookeOptions& options);

/// F = F_end (Delta / Delta_end)^exponent fitted to the loading: exponent, force_at_end_N.
CurveFit fit_power_law(const continuum::BeadCurve& curve);

/// The part of a curve in which the plates close at constant speed: Delta = speed (t - touch).
struct Ramp {
  double touch = 0.0;      ///< [s]
  double speed = 0.0;      ///< [m/s]
  double depth = 0.0;      ///< mean Delta while it is held, or the largest [m]
  std::size_t end = 0;     ///< first row at which Delta is largest, but for noise
  double deviation = 0.0;  ///< largest departure from the straight line, share of depth
};
/// Throws ValueError if fewer than three rows rise through the middle of the depth.
Ramp find_ramp(const continuum::BeadCurve& curve);

}  // namespace packbed::study
