// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The edge of rigidity: a packing of spheres is shrunk, state by state at rest, until hardly any
/// pressure is left.

#include "tests/support/sphere_box.hpp"
#include "validation/support/validation.hpp"

namespace packbed::validation {

struct EdgePath {
  double exponent;      ///< pressure ~ excess^exponent: 1 (Hooke), 1.5 (Hertz)
  double at_rest;       ///< unbalanced / contact force of a state
  double least_excess;  ///< of solid fraction over the edge, where the path ends
  double step = 0.5;    ///< from state to state, over the excess
};

/// From a packing under pressure down to the edge, by a share of the excess from state to
/// state, and by at most 0.005.
/// Columns: solid_fraction, pressure, coordination, carrying, unbalanced (test::PackingFigures).
Table path_to_edge(test::SphereBox& box, const EdgePath& path);

/// Figures of a path: where p^(1/exponent), a straight line through its last two states, is 0; power
/// of the pressure; coordination at the edge and its rise with sqrt(excess). The last three by fits
/// over excesses from `low` to `high`.
struct EdgeFigures {
  double solid_fraction, exponent, coordination, coordination_slope;
};
EdgeFigures edge_figures(const Table& path, double exponent, double low, double high);

}  // namespace packbed::validation
