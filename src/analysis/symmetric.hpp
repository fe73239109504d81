// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Symmetric tensor of second order.

#include "core/vec3.hpp"

namespace packbed::analysis {

struct Symmetric {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;

  constexpr Symmetric& operator+=(const Symmetric& b) {
    return *this = {xx + b.xx, yy + b.yy, zz + b.zz, xy + b.xy, xz + b.xz, yz + b.yz};
  }
  [[nodiscard]] constexpr double trace() const { return xx + yy + zz; }
  bool operator==(const Symmetric&) const = default;
};

constexpr Symmetric operator*(double s, const Symmetric& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
}

/// (a b^T + b a^T) / 2.
constexpr Symmetric symmetric_product(const Vec3& a, const Vec3& b) {
  return {a.x * b.x,
          a.y * b.y,
          a.z * b.z,
          0.5 * (a.x * b.y + a.y * b.x),
          0.5 * (a.x * b.z + a.z * b.x),
          0.5 * (a.y * b.z + a.z * b.y)};
}

}  // namespace packbed::analysis
