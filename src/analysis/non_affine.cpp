// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <vector>

#include "analysis/by_id.hpp"
#include "analysis/rearrangement.hpp"

namespace packbed::analysis {
namespace {

constexpr std::size_t fewest_neighbors = 4;
// Of det(X) to (trace(X) / 3)^3, which is 1 for neighbors on all sides and 0 for those in a plane.
constexpr double flattest = 1e-6;

struct Neighbor {
  Vec3 branch;    ///< in the first state
  Vec3 relative;  ///< displacement of the neighbor less that of the bead
};

/// Three rows of a matrix.
using Matrix = std::array<Vec3, 3>;

constexpr Vec3 operator*(const Matrix& m, const Vec3& a) {
  return {dot(m[0], a), dot(m[1], a), dot(m[2], a)};
}

double determinant(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }

/// Of a symmetric matrix.
Matrix inverse(const Matrix& m) {
  const double s = 1.0 / determinant(m);
  return {s * cross(m[1], m[2]), s * cross(m[2], m[0]), s * cross(m[0], m[1])};
}

void add_product(Matrix& m, const Vec3& a, const Vec3& b) {
  m[0] += a.x * b;
  m[1] += a.y * b;
  m[2] += a.z * b;
}

/// l' - F l = relative - (F - 1) l, and F - 1 = Y X^-1 with X = sum l l^T, Y = sum relative l^T. In the
/// branches' unit of length X is of order 1 and a small strain keeps all its digits.
bool fits(std::span<const Neighbor> neighbors, double& square) {
  Matrix x{};
  Matrix y{};
  for (const auto& n : neighbors) {
    add_product(x, n.branch, n.branch);
    add_product(y, n.relative, n.branch);
  }
  const double mean = (x[0].x + x[1].y + x[2].z) / 3.0;
  if (!(determinant(x) > flattest * mean * mean * mean)) return false;
  const Matrix inverted = inverse(x);
  square = 0.0;
  for (const auto& n : neighbors) {
    const Vec3 rest = n.relative - y * (inverted * n.branch);
    square += dot(rest, rest) / static_cast<double>(neighbors.size());
  }
  return true;
}

std::vector<std::vector<Neighbor>> neighborhoods(std::span<const MovedBead> beads,
                                                 std::span<const ContactForce> contacts,
                                                 std::int64_t& left_out) {
  std::vector<std::vector<Neighbor>> all(beads.size());
  for (const auto& c : contacts) {
    if (c.with_wall()) continue;
    const auto i = place_of(beads, c.i);
    const auto j = place_of(beads, c.j);
    if (i == beads.size() || j == beads.size()) {
      ++left_out;
      continue;
    }
    const Vec3 relative = beads[j].moved - beads[i].moved;
    all[i].push_back({c.branch, relative});
    all[j].push_back({-c.branch, -relative});
  }
  return all;
}

}  // namespace

NonAffineMotion non_affine_motion(const Displacements& displacements,
                                  std::span<const ContactForce> contacts) {
  const auto& beads = displacements.beads;
  NonAffineMotion motion;
  const auto neighbors = neighborhoods(beads, contacts, motion.contacts_left_out);
  double sum = 0.0;
  for (std::size_t k = 0; k < beads.size(); ++k) {
    double square = 0.0;
    if (neighbors[k].size() < fewest_neighbors || !fits(neighbors[k], square)) {
      ++motion.left_out;
      continue;
    }
    motion.beads.push_back({.id = beads[k].id, .x = beads[k].x, .square = square});
    sum += square;
  }
  if (!motion.beads.empty()) motion.mean_square = sum / static_cast<double>(motion.beads.size());
  return motion;
}

}  // namespace packbed::analysis
