// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Gradients of a vector field in cells, and a vector field in cells from fluxes through faces.

#include <span>
#include <vector>

#include "fluid/border.hpp"
#include "fluid/domain.hpp"

namespace packbed::fluid {

/// eps u of each cell.
inline std::vector<Vec3> superficial(std::span<const double> eps, std::span<const Vec3> u) {
  std::vector<Vec3> all(u.size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = eps[c] * u[c];
  return all;
}

/// Least squares over the faces of each cell, weights 1/distance^2; exact for linear fields. `u` in all cells,
/// `at_border` at each border face. Halo values are brought up to date.
std::vector<Tensor> gradient(Domain& domain,
                             std::span<const Vec3> u,
                             std::span<const Vec3> at_border);

/// Vector in own cells whose normal parts fit `q`, one per face, best: sum |S| n (n.v - q) = 0. On cells with
/// parallel sides the mean of opposite faces. `lean`, if not empty, is the gradient of the field, by which
/// values at face centers are brought to the cell's: then exact for linear fields on any cell.
std::vector<Vec3> reconstruct(const Domain& domain,
                              std::span<const double> q,
                              std::span<const Tensor> lean);

/// Part of q that velocities of cells do not see, one per inner face: with D q = q - n.(interpolated velocity of
/// cells that fit q) it is D (D q). 0 to fourth order where q is smooth, q itself where it changes sign from face to
/// face. `v`: velocity of all cells that fits q; `grad_v` of it where cells lean, or empty.
std::vector<double> unseen(Domain& domain,
                           std::span<const double> q,
                           std::span<const Vec3> v,
                           std::span<const Tensor> grad_v);

}  // namespace packbed::fluid
