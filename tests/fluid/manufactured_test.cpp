// SPDX-License-Identifier: BSD-3-Clause
// F4: manufactured solutions with a void fraction that changes in space and time.
#include "tests/support/manufactured.hpp"

#include <gtest/gtest.h>

namespace packbed::fluid {
namespace {

using namespace test;  // NOLINT

TEST(Manufactured, OrderTwoOnABox) {
  std::vector<double> h;
  std::vector<double> u;
  std::vector<double> p;
  for (const int n : {4, 8, 16, 32}) {
    const BoxCase box{{1e-3, 0.25e-3, 1e-3},
                      {n, 1, n},
                      {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
    const auto e = manufactured_errors(manufactured_box(1e-3), box.mesh(), 5e-3, n * n / 16);
    h.push_back(1.0 / n);
    u.push_back(e.u);
    p.push_back(e.p);
  }

  EXPECT_NEAR(fitted_order(h, u), 2.0, 0.1);
  EXPECT_NEAR(fitted_order(h, p), 2.0, 0.2);
  EXPECT_LT(u.back(), 5e-3);
}

// Two meshes here; `./packbed validate liquid` fits over three halvings.
TEST(Manufactured, ConvergesOnFiveBlocks) {
  std::vector<double> h;
  std::vector<double> u;
  std::vector<double> p;
  for (const int n : {4, 8}) {
    const mesh::ColumnMesh mesh(mesh::Cylinder{.inner_diameter = 1e-3, .height = 1e-3},
                                {.core = n, .ring = n / 2, .layers = 2 * n});
    const auto e = manufactured_errors(manufactured_cylinder(0.5e-3), mesh, 2e-3, n * n / 8);
    h.push_back(1.0 / n);
    u.push_back(e.u);
    p.push_back(e.p);
  }

  EXPECT_GT(fitted_order(h, u), 1.7);
  EXPECT_GT(fitted_order(h, p), 1.5);
}

}  // namespace
}  // namespace packbed::fluid
