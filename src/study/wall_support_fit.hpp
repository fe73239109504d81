// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The wall-support model fitted to pressure drops and compressions of columns of several diameters at several
/// velocities. Thesis section 7.4.3 did this with Matlab's fmincon; docs/theory/wall_support.md.

#include <optional>
#include <string>
#include <vector>

#include "continuum/wall_support/wall_support.hpp"
#include "study/least_squares.hpp"
#include "study/profile.hpp"

namespace packbed::study {

/// One measured column at one velocity. SI units.
struct ColumnDatum {
  double diameter = 0.0;
  double velocity = 0.0;
  double height = 0.0;                     ///< settled
  std::optional<double> gradient = {};     ///< pressure drop per height under flow [Pa/m]
  std::optional<double> compression = {};  ///< (H0 - H) / H0
  double gradient_error = 0.0;             ///< standard deviation [Pa/m]
  double compression_error = 0.0;          ///< standard deviation [-]
};

/// What of the bed may be fitted.
enum class BedParameter {
  modulus,
  bead_diameter,
  wall_friction,
  poisson,
  density_difference,
  eps0,
  exponent
};

struct BedBound {
  BedParameter parameter;
  double low, high;
};

struct WallSupportFitOptions {
  std::vector<BedBound>
      free;  ///< parameters to fit, between their bounds; the others stay as in `bed`
  continuum::WallSupportColumn
      column;                 ///< liquid, gravity, reading; diameter and height come from the data
  bool known_errors = false;  ///< errors of the data are standard deviations, not mere weights
  int starts = 8;             ///< the bed given, and others spread over the bounds
  Intervals intervals = Intervals::linear;
};

/// Model at a datum; not steady: nothing.
struct ColumnModel {
  double gradient, compression;
};

struct WallSupportFit {
  Fit fit;
  continuum::CompressibleBed bed;  ///< fitted
  int starts = 0, agreeing = 0;
  std::vector<ColumnModel> model;  ///< one per datum
  double r2_gradient = 0.0, r2_compression = 0.0;
  /// Wall term 4 mu_w nu / (1 - nu) with its error: what the data know of mu_w and nu.
  std::optional<Estimate> wall_coefficient;
  double largest_compression = 0.0;  ///< of the data or, without, of the model: what is calibrated
};

/// Names as in WallSupportFit::fit: "B_Pa", "bead_diameter_m", "wall_friction", "poisson", "density_difference_kg_m3",
/// "settled_porosity", "exponent".
std::string name_of(BedParameter parameter);
double value_of(const continuum::CompressibleBed& bed, BedParameter parameter);
/// Bounds that are wide for any resin.
BedBound usual_bounds(BedParameter parameter);

/// Throws ValueError: fewer data than parameters, an exponent without PowerModulus, a start out of bounds; and
/// DivergenceError if the best fit has no steady state at a datum.
WallSupportFit fit_wall_support(const continuum::CompressibleBed& bed,
                                const std::vector<ColumnDatum>& data,
                                const WallSupportFitOptions& options);

}  // namespace packbed::study
