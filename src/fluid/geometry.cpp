// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/geometry.hpp"

#include <cmath>

namespace packbed::fluid {

void Symmetric::add(double weight, const Vec3& d) {
  xx += weight * d.x * d.x;
  yy += weight * d.y * d.y;
  zz += weight * d.z * d.z;
  xy += weight * d.x * d.y;
  xz += weight * d.x * d.z;
  yz += weight * d.y * d.z;
}

Vec3 operator*(const Symmetric& m, const Vec3& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

Symmetric inverse(const Symmetric& m) {
  const double xx = m.yy * m.zz - m.yz * m.yz;
  const double xy = m.xz * m.yz - m.xy * m.zz;
  const double xz = m.xy * m.yz - m.xz * m.yy;
  const double determinant = m.xx * xx + m.xy * xy + m.xz * xz;
  const double s = 1.0 / determinant;
  return {.xx = s * xx,
          .yy = s * (m.xx * m.zz - m.xz * m.xz),
          .zz = s * (m.xx * m.yy - m.xy * m.xy),
          .xy = s * xy,
          .xz = s * xz,
          .yz = s * (m.xy * m.xz - m.xx * m.yz)};
}

Tensor& Tensor::operator+=(const Tensor& b) {
  x += b.x;
  y += b.y;
  z += b.z;
  return *this;
}

Tensor operator+(Tensor a, const Tensor& b) { return a += b; }
Tensor operator*(double s, const Tensor& t) { return {s * t.x, s * t.y, s * t.z}; }

namespace {

// Lengths along a face below this share of delta are rounding.
constexpr double rounding = 1e-9;

void add_faces(const mesh::MeshPart& part, Geometry& g) {
  const auto faces = part.owner.size();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto owner = static_cast<std::size_t>(part.owner[f]);
    const double area = norm(part.area[f]);
    const Vec3 n = (1.0 / area) * part.area[f];
    const Vec3 arm = part.face_center[f] - part.center[owner];
    const double d_owner = dot(arm, n);
    const double across = dot(part.delta[f], n);
    const Vec3 along = part.delta[f] - across * n;
    const Vec3 lean = arm - d_owner * n;
    if (norm(along) + norm(lean) > rounding * across) g.orthogonal = false;
    g.area.push_back(area);
    g.normal.push_back(n);
    g.d_owner.push_back(d_owner);
    g.d_neighbor.push_back(f < part.neighbor.size() ? across - d_owner : 0.0);
    g.along.push_back(along);
    g.from_owner.push_back(arm);
    g.skew.push_back(arm - (d_owner / across) * part.delta[f]);
  }
}

}  // namespace

Geometry geometry(const mesh::MeshPart& part) {
  Geometry g;
  add_faces(part, g);
  const auto own = static_cast<std::size_t>(part.own);
  std::vector<Symmetric> reconstruct(part.cell.size());
  std::vector<Symmetric> inner(part.cell.size());
  std::vector<Symmetric> least_squares(part.cell.size());
  for (std::size_t f = 0; f < part.owner.size(); ++f) {
    const Vec3& d = part.delta[f];
    const double weight = 1.0 / dot(d, d);
    const auto add = [&](std::int32_t cell) {
      reconstruct[static_cast<std::size_t>(cell)].add(g.area[f], g.normal[f]);
      least_squares[static_cast<std::size_t>(cell)].add(weight, d);
      if (f < part.neighbor.size()) {
        inner[static_cast<std::size_t>(cell)].add(g.area[f], g.normal[f]);
      }
    };
    add(part.owner[f]);
    if (f < part.neighbor.size()) add(part.neighbor[f]);
  }
  for (std::size_t c = 0; c < own; ++c) {
    g.reconstruct.push_back(inverse(reconstruct[c]));
    g.least_squares.push_back(inverse(least_squares[c]));
    // A direction without inner faces has no flux either; the matrix only must not be singular.
    const double little = 1e-9 * (reconstruct[c].xx + reconstruct[c].yy + reconstruct[c].zz);
    inner[c].xx += little;
    inner[c].yy += little;
    inner[c].zz += little;
    g.reconstruct_inner.push_back(inverse(inner[c]));
  }
  return g;
}

}  // namespace packbed::fluid
