// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What the liquid wants to know of faces and cells beyond mesh::MeshPart. SI units.

#include <vector>

#include "core/vec3.hpp"
#include "mesh/mesh_part.hpp"

namespace packbed::fluid {

/// Symmetric 3 x 3 matrix.
struct Symmetric {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;
  void add(double weight, const Vec3& d);  ///< weight d d^T
};
Vec3 operator*(const Symmetric& m, const Vec3& v);
/// Throws nothing; the matrix must be regular.
Symmetric inverse(const Symmetric& m);

/// Rows: gradients of the components of a vector, (row i)_j = d u_i / d x_j.
struct Tensor {
  Vec3 x{}, y{}, z{};
  Tensor& operator+=(const Tensor& b);
};
Tensor operator+(Tensor a, const Tensor& b);
Tensor operator*(double s, const Tensor& t);
inline Vec3 operator*(const Tensor& t, const Vec3& v) {
  return {dot(t.x, v), dot(t.y, v), dot(t.z, v)};
}
inline Vec3 transposed_times(const Tensor& t, const Vec3& v) {
  return v.x * t.x + v.y * t.y + v.z * t.z;
}
inline double trace(const Tensor& t) { return t.x.x + t.y.y + t.z.z; }

struct Geometry {
  // --- faces
  std::vector<double> area;        ///< |S_f| [m2]
  std::vector<Vec3> normal;        ///< S_f / |S_f|
  std::vector<double> d_owner;     ///< distance of the owner's center from the face's plane [m]
  std::vector<double> d_neighbor;  ///< the same of the neighbor; 0 at the border [m]
  std::vector<Vec3> along;         ///< part of delta_f in the plane of the face [m]
  std::vector<Vec3> from_owner;    ///< from the owner's center to the face's center [m]
  std::vector<Vec3> skew;          ///< from where delta_f cuts the face to its center [m]
  // --- own cells
  std::vector<Symmetric> reconstruct;        ///< inverse of sum |S| n n^T [1/m2]
  std::vector<Symmetric> reconstruct_inner;  ///< the same, of faces between cells
  std::vector<Symmetric> least_squares;      ///< inverse of sum d d^T / d^2 over faces

  /// Whether no delta_f and no line from a center to a face leans: boxes and slices.
  bool orthogonal = true;

  /// Weight of the owner in a linear interpolation to a face.
  [[nodiscard]] double owner_weight(std::size_t f) const {
    return d_neighbor[f] / (d_owner[f] + d_neighbor[f]);
  }
};

Geometry geometry(const mesh::MeshPart& part);

}  // namespace packbed::fluid
