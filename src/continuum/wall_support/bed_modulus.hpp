// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// How the axial stress of a bed grows with its compression. Every law has
///   stress(lambda)     sigma [Pa], 0 at 0, rising
///   slope(lambda)      d sigma / d lambda [Pa]
///   compression(sigma) the inverse of stress
/// lambda is local, per undeformed length.

#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

namespace packbed::continuum {

/// sigma = B lambda. Thesis eq. 7.8.
struct ConstantModulus {
  static constexpr std::string_view name = "constant";
  double modulus = 0.0;  ///< B [Pa]

  [[nodiscard]] double stress(double lambda) const { return modulus * lambda; }
  [[nodiscard]] double slope(double /*lambda*/) const { return modulus; }
  [[nodiscard]] double compression(double sigma) const { return sigma / modulus; }
};

/// Stiffening: sigma = B lambda (lambda / reference)^(exponent - 1). B is the secant modulus at the reference
/// compression. Exponent 3/2 is that of Hertz's contacts, 1 is the constant modulus.
struct PowerModulus {
  static constexpr std::string_view name = "hertz";
  double modulus = 0.0;     ///< B [Pa]
  double reference = 0.05;  ///< [-]
  double exponent = 1.5;

  [[nodiscard]] double stress(double lambda) const {
    return modulus * reference * std::pow(lambda / reference, exponent);
  }
  [[nodiscard]] double slope(double lambda) const {
    return modulus * exponent * std::pow(lambda / reference, exponent - 1.0);
  }
  [[nodiscard]] double compression(double sigma) const {
    return reference * std::pow(sigma / (modulus * reference), 1.0 / exponent);
  }
};

/// Measured secant moduli B(lambda) = sigma / lambda; the stress is straight between the rows and from 0 to the first
/// one, and goes on with the last slope beyond the last.
class TabulatedModulus {
 public:
  static constexpr std::string_view name = "table";

  /// Throws ValueError (naming the row, from 1) unless compressions ascend from above 0 to below 1, moduli are
  /// positive and the stress rises from row to row.
  static TabulatedModulus from(const std::vector<double>& compressions,
                               const std::vector<double>& moduli);

  [[nodiscard]] double stress(double lambda) const;
  [[nodiscard]] double slope(double lambda) const;
  [[nodiscard]] double compression(double sigma) const;
  /// Compressions of the rows, 0 among them.
  [[nodiscard]] const std::vector<double>& rows() const { return lambda_; }

 private:
  std::vector<double> lambda_;  ///< from 0
  std::vector<double> sigma_;   ///< [Pa]
};

using BedModulus = std::variant<ConstantModulus, PowerModulus, TabulatedModulus>;

}  // namespace packbed::continuum
