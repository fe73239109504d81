// SPDX-License-Identifier: BSD-3-Clause
// C13, P1, I7: lattices of beads S in periodic boxes.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

constexpr double d = diameter_s;
constexpr double k_n = 37.209127;  // N/m, two beads S

/// A block of n x n x n cells, periodic.
struct Lattice {
  std::vector<Vec3> basis;
  Vec3 cell;
  int n = 3;

  [[nodiscard]] Vec3 size() const { return static_cast<double>(n) * cell; }
  [[nodiscard]] DemOptions options() const {
    auto o = test::options(hooke(0.5), 1e-8);
    o.domain = {.low = {}, .size = {size().x, size().y, size().z}, .periodic = {true, true, true}};
    return o;
  }
  [[nodiscard]] std::vector<BeadStart> beads(Vec3 shift = {}) const {
    std::vector<BeadStart> list;
    for (int k = 0; k < n * n * n; ++k) {
      const Vec3 corner{(k % n) * cell.x, (k / n % n) * cell.y, (k / n / n) * cell.z};
      for (const auto& at : basis) {
        list.push_back(bead(static_cast<std::int64_t>(list.size()), corner + at + shift));
      }
    }
    return list;
  }
};

Lattice simple_cubic(double pitch_xy, double pitch_z) {
  return {{{0, 0, 0}}, {pitch_xy, pitch_xy, pitch_z}};
}
Lattice face_centered(double pitch) {
  const double a = std::sqrt(2.0) * pitch;
  return {{{0, 0, 0}, {a / 2, a / 2, 0}, {a / 2, 0, a / 2}, {0, a / 2, a / 2}}, {a, a, a}};
}

/// Normal stresses from the pair forces: sum of force times branch over the volume [Pa].
Vec3 stress(const Lattice& lattice) {
  const Dem dem(lattice.options(), lattice.beads(), {});
  const auto& p = dem.particles();
  const Vec3 box = dem.contacts().box();
  Vec3 sum;
  for (const auto& c : dem.contacts().pairs()) {
    const Vec3 shift{box.x * c.image[0], box.y * c.image[1], box.z * c.image[2]};
    const Vec3 r = p.motion[static_cast<std::size_t>(c.i)].x -
                   p.motion[static_cast<std::size_t>(c.j)].x - shift;
    const double force = hooke(0.5)(d - norm(r), 0.0, c.coefficients).f_n;
    sum += (force / norm(r)) * Vec3{r.x * r.x, r.y * r.y, r.z * r.z};
  }
  return 1.0 / (box.x * box.y * box.z) * sum;
}

constexpr double strain = 1e-6;

// C13: uniaxial modulus of the simple cubic lattice k_n / d = 428183.28 Pa.
TEST(Lattice, SimpleCubicHasItsUniaxialModulus) {
  const auto s = stress(simple_cubic(d, d * (1.0 - strain)));
  EXPECT_NEAR(s.z / strain / 428183.28, 1.0, 1e-5);
  EXPECT_NEAR(s.x / s.z, 0.0, 1e-5);  // the others only just touch
}

// C13: bulk modulus z phi k_n / (3 pi d).
TEST(Lattice, HasItsBulkModulus) {
  const auto bulk = [](const Lattice& lattice) {
    const auto s = stress(lattice);
    EXPECT_NEAR(s.x / s.z, 1.0, 1e-8);
    return (s.x + s.y + s.z) / 3.0 / (3.0 * strain);
  };
  const double pitch = d * (1.0 - strain);
  EXPECT_NEAR(bulk(simple_cubic(pitch, pitch)) / 142727.76, 1.0, 1e-5);
  EXPECT_NEAR(bulk(face_centered(pitch)) / 403694.8, 1.0, 1e-5);
}

// P1: porosity and contacts of the regular packings (thesis table 3.1).
TEST(Lattice, RegularPackingsHaveTheirPorosityAndContacts) {
  const double h = 0.5 * std::sqrt(3.0);
  const struct {
    const char* name;
    std::vector<Vec3> basis;
    Vec3 cell;
    double porosity, contacts;
  } rows[] = {{"simple cubic", {{0, 0, 0}}, {1, 1, 1}, 0.4764, 6},
              {"orthorhombic", {{0, 0, 0}, {0.5, h, 0}}, {1, 2 * h, 1}, 0.3954, 8},
              {"tetragonal-sphenoidal",
               {{0, 0, 0}, {0.5, h, 0}, {0.5, 0, h}, {0, h, h}},
               {1, 2 * h, 2 * h},
               0.3019,
               10},
              {"rhombohedral", face_centered(1.0).basis, face_centered(1.0).cell, 0.2595, 12}};
  constexpr double pressed = 0.99999;  // so that neighbors touch
  for (const auto& row : rows) {
    Lattice lattice{row.basis, pressed * d * row.cell};
    for (auto& at : lattice.basis) at *= pressed * d;
    const auto s = Dem(lattice.options(), lattice.beads(), {}).snapshot();
    const Vec3 size = lattice.size();
    const double volume = static_cast<double>(s.x.size()) * std::numbers::pi / 6.0 * d * d * d;
    EXPECT_NEAR(1.0 - volume / (size.x * size.y * size.z), row.porosity, 1e-4) << row.name;
    EXPECT_EQ(s.coordination_number, row.contacts) << row.name;
  }
}

// I7: forces of a disturbed lattice moved by any vector; 1e-13 of k_n d, the rounding of places.
TEST(Lattice, MovedByAnyVectorHasTheSameForces) {
  const auto lattice = simple_cubic(0.98 * d, 0.97 * d);
  const auto forces = [&](Vec3 shift) {
    auto beads = lattice.beads(shift);
    beads[4].x += Vec3{1e-6, -2e-6, 3e-6};
    beads[13].x += Vec3{-2e-6, 1e-6, 1e-6};
    return Dem(lattice.options(), beads, {}).snapshot().force;
  };
  const auto at_home = forces({});
  EXPECT_GT(norm(at_home[4]), 1e-2 * k_n * d * 0.01);
  for (const Vec3 shift : {Vec3{0.3 * d, -0.7 * d, 1.2 * d}, Vec3{-2.9 * d, 2.5 * d, 0.1 * d}}) {
    const auto moved = forces(shift);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      EXPECT_LT(norm(moved[i] - at_home[i]), 1e-13 * k_n * d) << i;
    }
  }
}

// I7: a bead in the corner of the box with a neighbor in each of the eight octants, hence across all sides.
TEST(Lattice, BeadInTheCornerMeetsEightImages) {
  const double side = 8 * d;
  const auto forces = [&](Vec3 center) {
    auto o = options(hooke(0.5), 1e-8);
    o.domain = {.low = {}, .size = {side, side, side}, .periodic = {true, true, true}};
    std::vector<BeadStart> beads = {bead(0, center)};
    for (int k = 0; k < 8; ++k) {
      const Vec3 to{k % 2 ? 1.0 : -1.0, k / 2 % 2 ? 1.0 : -1.0, k / 4 ? 1.0 : -1.0};
      const double apart = d * (0.95 + 0.005 * k);
      beads.push_back(bead(k + 1, center + (apart / std::sqrt(3.0)) * to));
    }
    for (auto& b : beads) {  // into the box
      for (double* a : {&b.x.x, &b.x.y, &b.x.z}) *a -= side * std::floor(*a / side);
    }
    const auto s = Dem(o, beads, {}).snapshot();
    EXPECT_GT(s.coordination_number, 16.0 / 9.0 - 1e-12);
    return s.force;
  };
  const auto inside = forces({4 * d, 4 * d, 4 * d});
  const auto corner = forces({1e-9, 1e-9, 1e-9});
  for (std::size_t i = 0; i < inside.size(); ++i) {
    EXPECT_LT(norm(inside[i] - corner[i]), 1e-13 * k_n * d) << i;
  }
}

}  // namespace
}  // namespace packbed::dem
