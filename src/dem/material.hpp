// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Elastic constants of bodies, and effective values of pairs.

namespace packbed::dem {

struct Material {
  double youngs_modulus = 0.0;  ///< [Pa]
  double poisson_ratio = 0.0;
  bool operator==(const Material&) const = default;
};

/// Y* of two bodies in contact [Pa]. Thesis eq. 3.2 (there E*).
constexpr double effective_modulus(const Material& i, const Material& j) {
  const auto compliance = [](const Material& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
  };
  return 1.0 / (compliance(i) + compliance(j));
}

/// G* of two bodies in contact [Pa]. Thesis eq. 4.16.
constexpr double effective_shear_modulus(const Material& i, const Material& j) {
  const auto compliance = [](const Material& m) {
    return 2.0 * (2.0 - m.poisson_ratio) * (1.0 + m.poisson_ratio) / m.youngs_modulus;
  };
  return 1.0 / (compliance(i) + compliance(j));
}

/// a b / (a + b): effective radius or mass of two bodies.
constexpr double effective(double a, double b) { return a * b / (a + b); }

}  // namespace packbed::dem
