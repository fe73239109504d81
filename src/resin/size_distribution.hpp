// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How the diameters of the beads of a resin are distributed. To add one: write its struct here
/// or beside this file, put it in the variant, name it in setup/, give an example to the family
/// test.
///
/// Every distribution is a distribution of NUMBER over diameter d, with density f on
/// [smallest, largest], and answers exactly (closed form, no sampling):
///   partial_moment(k, x) = integral of t^k f(t) dt from smallest to x      [m^k]
///   quantile(u)          = the diameter below which the share u of all beads lies

#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace packbed::resin {

/// All beads alike.
struct Monodisperse {
  static constexpr std::string_view name = "monodisperse";
  double diameter;  ///< [m]

  [[nodiscard]] double smallest() const { return diameter; }
  [[nodiscard]] double largest() const { return diameter; }
  [[nodiscard]] double partial_moment(int k, double x) const;
  [[nodiscard]] double quantile(double u) const;
  bool operator==(const Monodisperse&) const = default;
};

/// Normal distribution cut to a range. `mean` and `standard_deviation` are those of the curve
/// before it is cut, which is how measured distributions are usually quoted.
class TruncatedNormal {
 public:
  static constexpr std::string_view name = "normal";

  /// Lengths in m. Throws ValueError unless 0 < minimum < maximum, the deviation is positive and
  /// at least 1e-6 of the uncut curve lies in the range.
  static TruncatedNormal from(double mean,
                              double standard_deviation,
                              double minimum,
                              double maximum);

  [[nodiscard]] double smallest() const { return minimum_; }
  [[nodiscard]] double largest() const { return maximum_; }
  [[nodiscard]] double partial_moment(int k, double x) const;
  [[nodiscard]] double quantile(double u) const;
  bool operator==(const TruncatedNormal&) const = default;

 private:
  double mean_ = 0.0, sd_ = 0.0, minimum_ = 0.0, maximum_ = 0.0;
  double share_ = 0.0;  ///< of the uncut curve that lies in the range
};

/// Log-normal distribution cut to a range: ln d is normal with mean ln(median) and deviation
/// ln(geometric_standard_deviation), both before it is cut.
class Lognormal {
 public:
  static constexpr std::string_view name = "lognormal";

  /// Lengths in m. Throws ValueError unless 0 <= minimum < maximum (which may be infinite),
  /// median > 0, deviation > 1, and at least 1e-6 of the uncut curve lies in the range.
  static Lognormal from(double median,
                        double geometric_standard_deviation,
                        double minimum,
                        double maximum);

  [[nodiscard]] double smallest() const { return minimum_; }
  [[nodiscard]] double largest() const { return maximum_; }
  [[nodiscard]] double partial_moment(int k, double x) const;
  [[nodiscard]] double quantile(double u) const;
  bool operator==(const Lognormal&) const = default;

 private:
  [[nodiscard]] double standardized(double x) const;
  double log_median_ = 0.0, sigma_ = 0.0, minimum_ = 0.0, maximum_ = 0.0, share_ = 0.0;
};

/// One bin of a measured histogram.
struct Bin {
  double lower;  ///< [m]
  double upper;  ///< [m]
  double share;  ///< of all beads or of all volume, in any scale
  bool operator==(const Bin&) const = default;
};

enum class Weighting { number, volume };

/// Histogram; inside a bin the number density is constant. A share by volume is turned into one
/// by number with the mean cube of the bin's diameters, so that the volume share is kept exactly.
class Histogram {
 public:
  static constexpr std::string_view name = "histogram";

  /// Throws ValueError (naming the bin, counted from 1) unless the bins ascend without overlap,
  /// 0 < lower < upper, no share is negative and some are positive.
  static Histogram from(std::span<const Bin> bins, Weighting weighting);

  [[nodiscard]] double smallest() const { return bins_.front().lower; }
  [[nodiscard]] double largest() const { return bins_.back().upper; }
  [[nodiscard]] double partial_moment(int k, double x) const;
  [[nodiscard]] double quantile(double u) const;
  bool operator==(const Histogram&) const = default;

 private:
  std::vector<Bin> bins_;  ///< shares by number, with sum 1; none is 0
};

/// Measured diameters; each is as probable as any other.
class Measured {
 public:
  static constexpr std::string_view name = "measured";

  /// Throws ValueError if there is none, or one is not positive.
  static Measured from(std::span<const double> diameters);

  [[nodiscard]] double smallest() const { return diameters_.front(); }
  [[nodiscard]] double largest() const { return diameters_.back(); }
  [[nodiscard]] double partial_moment(int k, double x) const;
  [[nodiscard]] double quantile(double u) const;
  bool operator==(const Measured&) const = default;

 private:
  std::vector<double> diameters_;  ///< ascending
};

using SizeDistribution =
    std::variant<Monodisperse, TruncatedNormal, Lognormal, Histogram, Measured>;

}  // namespace packbed::resin
