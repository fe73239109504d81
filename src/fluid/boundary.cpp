// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/boundary.hpp"

namespace packbed::fluid {

const BoundaryCondition& Boundaries::at(mesh::Patch patch) const {
  switch (patch) {
    case mesh::Patch::inlet:
      return inlet;
    case mesh::Patch::outlet:
      return outlet;
    case mesh::Patch::wall:
      return wall;
    case mesh::Patch::x_low:
      return x_low;
    case mesh::Patch::x_high:
      return x_high;
    case mesh::Patch::y_low:
      return y_low;
    case mesh::Patch::y_high:
      break;
  }
  return y_high;
}

}  // namespace packbed::fluid
