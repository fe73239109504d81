// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fluid/fluid.hpp"

namespace packbed::test {

/// A liquid on the usual mesh of a shape whose cells have the void fraction and the downward velocity
/// (interstitial) [m/s] that two functions of their centers tell.
template <class VoidFraction, class Downward>
fluid::Fluid liquid_of(const mesh::ColumnShape& shape,
                       VoidFraction eps,
                       Downward velocity,
                       const Ranks& ranks = Ranks::alone()) {
  const mesh::ColumnMesh mesh(shape, mesh::cell_counts(shape, {}));
  fluid::Fluid fluid({}, mesh, mesh::CellPartition(mesh.cell_count(), ranks.size()), ranks);
  fluid::Bed bed;
  std::vector<Vec3> u;
  for (std::size_t c = 0; c < fluid.domain().own(); ++c) {
    const auto& x = fluid.domain().part.center[c];
    bed.eps.push_back(eps(x));
    u.push_back({0.0, 0.0, -velocity(x)});
  }
  fluid.start(bed, u, 0.0);
  return fluid;
}

}  // namespace packbed::test
