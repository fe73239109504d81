// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh_part.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace packbed::mesh {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Sum over the faces of each own cell of what they have, outward counted positive.
template <class T>
std::vector<T> outward_sums(const MeshPart& part, const std::vector<T>& of_face) {
  std::vector<T> sums(part.cell.size(), T{});
  for (std::int32_t f = 0; f < part.face_count(); ++f) {
    sums[at(part.owner[at(f)])] += of_face[at(f)];
    if (f < part.inner) sums[at(part.neighbor[at(f)])] -= of_face[at(f)];
  }
  return sums;
}

class Meshes : public testing::TestWithParam<test::NamedShape> {};

TEST_P(Meshes, FillTheColumn) {
  const auto part = whole(GetParam().mesh());

  // The five blocks are as large as the disc, so this holds for the round column too.
  const double column = cross_section(GetParam().shape) * height(GetParam().shape);
  EXPECT_NEAR(sum(part.volume) / column, 1.0, 1e-13);
  EXPECT_GT(*std::ranges::min_element(part.volume), 0.0);
}

TEST_P(Meshes, HaveClosedCells) {
  const auto part = whole(GetParam().mesh());

  std::vector<double> surface(part.cell.size(), 0.0);
  for (std::int32_t f = 0; f < part.face_count(); ++f) {
    surface[at(part.owner[at(f)])] += norm(part.area[at(f)]);
    if (f < part.inner) surface[at(part.neighbor[at(f)])] += norm(part.area[at(f)]);
  }
  const auto sums = outward_sums(part, part.area);
  for (std::size_t c = 0; c < sums.size(); ++c) {
    EXPECT_LT(norm(sums[c]), 1e-13 * surface[c]) << "cell " << c;
  }
}

// Gauss: sum of x_f . S_f is three times the volume, with faces of periodic sides seen from each cell.
TEST_P(Meshes, HaveTheVolumesThatTheirFacesEnclose) {
  const auto part = whole(GetParam().mesh());

  std::vector<double> enclosed(part.cell.size(), 0.0);
  for (std::int32_t f = 0; f < part.face_count(); ++f) {
    const auto& c = part.center;
    const Vec3 from_owner = part.face_center[at(f)] - c[at(part.owner[at(f)])];
    enclosed[at(part.owner[at(f)])] += dot(from_owner, part.area[at(f)]) / 3.0;
    if (f < part.inner) {
      const Vec3 from_neighbor = from_owner - part.delta[at(f)];
      enclosed[at(part.neighbor[at(f)])] -= dot(from_neighbor, part.area[at(f)]) / 3.0;
    }
  }
  for (std::size_t c = 0; c < enclosed.size(); ++c) {
    EXPECT_NEAR(enclosed[c] / part.volume[c], 1.0, 1e-12) << "cell " << c;
  }
}

TEST_P(Meshes, HaveFacesInOrderFromLowerToHigherCells) {
  const auto part = whole(GetParam().mesh());

  for (std::int32_t f = 0; f < part.inner; ++f) {
    EXPECT_LT(part.owner[at(f)], part.neighbor[at(f)]);
    EXPECT_GT(dot(part.area[at(f)], part.delta[at(f)]), 0.0);
    if (f > 0) {
      const auto pair = [&](std::int32_t g) {
        return std::pair(part.owner[at(g)], part.neighbor[at(g)]);
      };
      EXPECT_LE(pair(f - 1), pair(f));
    }
  }
  std::int32_t next = part.inner;
  for (const auto& patch : part.patches) {
    EXPECT_EQ(patch.first, next);
    next += patch.count;
    for (auto f = patch.first; f < next; ++f) {
      EXPECT_GT(dot(part.area[at(f)], part.delta[at(f)]), 0.0);
    }
  }
  EXPECT_EQ(next, part.face_count());
}

TEST_P(Meshes, HaveSixFacesPerCell) {
  const auto part = whole(GetParam().mesh());
  EXPECT_EQ(part.inner + part.face_count(), 6 * part.cell_count());
}

TEST_P(Meshes, HaveCornersAroundTheirCells) {
  const auto part = whole(GetParam().mesh());
  for (std::size_t c = 0; c < part.cell.size(); ++c) {
    // The z-area of the lower side by the shoelace rule, times the height.
    const auto corner = [&](std::size_t k) { return part.points[at(part.corners[c][k])]; };
    double area = 0.0;
    for (std::size_t k = 0; k < 4; ++k) area += 0.5 * cross(corner(k), corner((k + 1) % 4)).z;
    EXPECT_NEAR(area * (corner(4).z - corner(0).z) / part.volume[c], 1.0, 1e-11);
  }
}

// Brute force: two cells are neighbors if they share a point of space, periodic images included.
TEST_P(Meshes, KnowTheirVertexNeighbors) {
  const auto mesh = GetParam().mesh();
  const auto part = whole(mesh);
  const auto& size = std::get_if<Box>(&GetParam().shape);
  const auto* slice = std::get_if<Slice>(&GetParam().shape);
  const auto folded = [&](double a, bool periodic, double low, double length) {
    const auto steps =
        std::llround((a - low) / length * 5040.0);  // 2^4 3^2 5 7: all counts here divide it
    return periodic && steps == 5040 ? 0LL : steps;
  };
  using Place = std::array<long long, 3>;
  std::map<Place, std::set<std::int64_t>> cells_at;
  const auto place = [&](const Vec3& p) -> Place {
    if (size != nullptr) {
      const auto is = [&](std::size_t axis) {
        return size->boundaries[axis] == Boundary::periodic;
      };
      return {folded(p.x, is(0), 0, size->size[0]), folded(p.y, is(1), 0, size->size[1]),
              folded(p.z, is(2), 0, size->size[2])};
    }
    if (slice != nullptr) {
      return {std::llround(p.x * 1e9), folded(p.y, true, -0.5 * slice->depth, slice->depth),
              std::llround(p.z * 1e9)};
    }
    return {std::llround(p.x * 1e9), std::llround(p.y * 1e9), std::llround(p.z * 1e9)};
  };
  for (std::size_t c = 0; c < part.cell.size(); ++c) {
    for (const auto corner : part.corners[c]) {
      cells_at[place(part.points[at(corner)])].insert(part.cell[c]);
    }
  }
  for (std::size_t c = 0; c < part.cell.size(); ++c) {
    std::set<std::int64_t> near;
    for (const auto corner : part.corners[c]) {
      near.merge(std::set(cells_at[place(part.points[at(corner)])]));
    }
    EXPECT_EQ(mesh.vertex_neighbors(part.cell[c]), std::vector(near.begin(), near.end()));
  }
}

TEST_P(Meshes, ComeInPartsThatFitTheWhole) {
  const auto mesh = GetParam().mesh();
  const auto all = whole(mesh);
  const auto cells = mesh.cell_count();
  std::int64_t inner = 0;
  std::int64_t border = 0;
  for (std::int64_t rank = 0; rank < 3; ++rank) {
    const auto first = cells * rank / 3;
    const auto part = mesh_part(mesh, first, cells * (rank + 1) / 3);
    std::map<std::int64_t, Vec3> sums;
    for (std::int32_t f = 0; f < part.face_count(); ++f) {
      const auto owner = part.cell[at(part.owner[at(f)])];
      sums[owner] += part.area[at(f)];
      if (f >= part.inner) {
        ++border;
        continue;
      }
      const auto neighbor = part.cell[at(part.neighbor[at(f)])];
      sums[neighbor] -= part.area[at(f)];
      EXPECT_LT(owner, neighbor);
      // A face between two ranks is on both, and is counted where its owner is.
      inner += part.owner[at(f)] < part.own ? 1 : 0;
    }
    for (std::int32_t c = 0; c < part.own; ++c) {
      EXPECT_EQ(part.cell[at(c)], first + c);
      EXPECT_LT(norm(sums[first + c]), 1e-18);  // of areas of 1e-7 m2
      EXPECT_EQ(part.volume[at(c)], all.volume[static_cast<std::size_t>(first + c)]);
    }
  }
  EXPECT_EQ(inner, all.inner);
  EXPECT_EQ(border, all.face_count() - all.inner);
}

TEST_P(Meshes, HaveTheHaloOfAllVertexNeighbors) {
  const auto mesh = GetParam().mesh();
  const auto cells = mesh.cell_count();
  for (const auto& [first, last] : {std::pair<std::int64_t, std::int64_t>{0, cells},
                                    {cells / 5, cells - cells / 7},
                                    {cells / 3, cells / 3 + 1}}) {
    std::set<std::int64_t> expected;
    for (auto c = first; c < last; ++c) {
      for (const auto n : mesh.vertex_neighbors(c)) {
        if (n < first || n >= last) expected.insert(n);
      }
    }
    const auto once = halo_cells(mesh, first, last);
    EXPECT_EQ(once, std::vector(expected.begin(), expected.end()));
    for (const auto c : once) {
      for (const auto n : mesh.vertex_neighbors(c)) {
        if (n < first || n >= last) expected.insert(n);
      }
    }
    EXPECT_EQ(halo_cells(mesh, first, last, 2), std::vector(expected.begin(), expected.end()));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         Meshes,
                         testing::ValuesIn(test::mesh_shapes()),
                         [](const auto& param) { return param.param.name; });

class MeshesWithATop : public testing::TestWithParam<test::NamedShape> {};

/// What the faces of each own cell sweep, without sign.
std::vector<double> swept_sizes(const MeshPart& part, const std::vector<double>& swept) {
  std::vector<double> sizes(static_cast<std::size_t>(part.own), 0.0);
  for (std::size_t f = 0; f < swept.size(); ++f) {
    for (const auto* side : {&part.owner, &part.neighbor}) {
      if (f >= side->size()) continue;
      const auto c = static_cast<std::size_t>((*side)[f]);
      if (c < sizes.size()) sizes[c] += std::abs(swept[f]);
    }
  }
  return sizes;
}

// The space conservation law, to rounding: 1e-15 of the cell and of what its faces sweep. Moves from a thousandth of a
// layer to one of many layers.
TEST_P(MeshesWithATop, GrowByWhatTheirFacesSweep) {
  auto mesh = GetParam().mesh();
  auto part = whole(mesh);
  for (const double factor : {1.0 - 1e-4, 1.0 + 1e-3, 0.98, 0.83, 1.31}) {
    const double before = mesh.top();
    const double after = factor * before;
    const auto old_volume = part.volume;

    const auto faces = swept_volumes(mesh, part, before, after);
    mesh.set_top(after);
    update_metrics(mesh, part);

    const auto swept = outward_sums(part, faces);
    const auto sizes = swept_sizes(part, faces);
    for (std::size_t c = 0; c < swept.size(); ++c) {
      EXPECT_NEAR(part.volume[c] - old_volume[c], swept[c], 1e-15 * (part.volume[c] + sizes[c]));
    }
    EXPECT_NEAR(sum(swept), sum(part.volume) - sum(old_volume), 1e-13 * sum(part.volume));
  }
}

TEST_P(MeshesWithATop, AreTheSameStretchedOrMadeThatWay) {
  auto mesh = GetParam().mesh();
  auto part = whole(mesh);
  mesh.set_top(0.7 * mesh.top());
  update_metrics(mesh, part);

  const auto made = whole(mesh);

  EXPECT_EQ(part.center, made.center);
  EXPECT_EQ(part.points, made.points);
  EXPECT_EQ(part.area, made.area);
  EXPECT_EQ(part.delta, made.delta);
}

std::vector<test::NamedShape> shapes_with_a_top() {
  auto shapes = test::mesh_shapes();
  std::erase_if(shapes, [](const auto& s) { return s.mesh().is_periodic_in_z(); });
  return shapes;
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         MeshesWithATop,
                         testing::ValuesIn(shapes_with_a_top()),
                         [](const auto& param) { return param.param.name; });

TEST(MeshPart, NamesTheSidesOfTheColumn) {
  const auto sides = [](const ColumnShape& shape, const MeshOptions& options) {
    std::string names;
    const auto part = whole({shape, cell_counts(shape, options)});
    for (const auto& p : part.patches) {
      names += std::string(patch_names[static_cast<std::size_t>(p.patch)]) + " ";
    }
    return names;
  };
  const Slice slice{.inner_diameter = 4e-3, .depth = 1e-3, .height = 6e-3};
  EXPECT_EQ(sides(slice, {}), "inlet outlet x_low x_high y_low y_high ");
  EXPECT_EQ(sides(slice, {.cells_y = 2}), "inlet outlet x_low x_high ");
  EXPECT_EQ(sides(Cylinder{.inner_diameter = 4e-3, .height = 2e-3}, {}), "inlet outlet wall ");
  const Box box{.size = {1e-3, 1e-3, 1e-3},
                .boundaries = {Boundary::periodic, Boundary::wall, Boundary::periodic}};
  EXPECT_EQ(sides(box, {}), "y_low y_high ");
}

TEST(MeshPart, HasInletAtTheTopAndOutletAtTheBottom) {
  const Cylinder cylinder{.inner_diameter = 4e-3, .height = 2e-3};
  const auto part = whole({cylinder, cell_counts(cylinder, {})});

  for (const auto& [side, z] : {std::pair{0, 2e-3}, std::pair{1, 0.0}}) {
    const auto& patch = part.patches[at(side)];
    Vec3 area{};
    for (auto f = patch.first; f < patch.first + patch.count; ++f) {
      EXPECT_EQ(part.face_center[at(f)].z, z);
      area += part.area[at(f)];
    }
    EXPECT_NEAR(area.z / cross_section(cylinder), side == 0 ? 1.0 : -1.0, 1e-13);
  }
}

}  // namespace
}  // namespace packbed::mesh
