// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/vec3.hpp"

namespace packbed::dem {

/// The box in which beads are looked for. Sides that are not periodic do not bound; walls do that.
struct Domain {
  std::array<double, 3> low{};   ///< [m]
  std::array<double, 3> size{};  ///< [m]
  std::array<bool, 3> periodic{};
};

/// How often a bead was taken over a periodic side, or which image of a neighbor is meant.
using Image = std::array<std::int8_t, 3>;

inline Vec3 offset(const Domain& domain, const Image& image) {
  return {domain.size[0] * image[0], domain.size[1] * image[1], domain.size[2] * image[2]};
}

}  // namespace packbed::dem
