// SPDX-License-Identifier: BSD-3-Clause
// The same bits on any number of ranks. Run under mpiexec; every rank also runs the bed alone.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <tuple>

#include "core/random.hpp"
#include "tests/support/beads.hpp"

namespace packbed::dem {
namespace {

using namespace test;  // NOLINT

/// A cloud of beads of 50 to 140 um that is thrown about and falls: dense below, empty above.
std::vector<BeadStart> cloud(int count) {
  std::vector<BeadStart> beads;
  const double pitch = 150e-6;
  for (int k = 0; k < count; ++k) {
    const auto u = [&](std::uint64_t n) {
      return uniform(17, Stream::bead_position, 10U * static_cast<std::uint64_t>(k) + n);
    };
    const int row = k / 8 % 8;
    const int layer = k / 64;
    const Vec3 x{(k % 8 + 0.3 + 0.1 * u(0)) * pitch, (row + 0.3 + 0.1 * u(1)) * pitch,
                 (layer + 0.5 + 0.02 * u(2)) * pitch};
    const Vec3 v{u(3) - 0.5, u(4) - 0.5, u(5) - 0.5};
    beads.push_back(with_weight(bead(k, x, v, (50 + 90 * u(6)) * 1e-6), 2000.0));
  }
  return beads;
}

/// Who owns which bead, and where a new cut is made.
struct Sharing {
  const char* name;
  double load_tolerance;
  std::shared_ptr<mesh::ColumnMesh> mesh = {};
};

std::shared_ptr<mesh::ColumnMesh> mesh_of(const mesh::ColumnShape& shape) {
  return std::make_shared<mesh::ColumnMesh>(shape, mesh::cell_counts(shape, {.cell = 0.11e-3}));
}

DemOptions options_of_bed(const Sharing& sharing) {
  auto o = options(hooke(0.7, false), 2e-7, 0.3, ElasticPlastic{0.2});
  o.domain = {.low = {0, 0, 0}, .size = {1.2e-3, 1.2e-3, 1.0}, .periodic = {true, true, false}};
  o.load_tolerance = sharing.load_tolerance;
  o.mesh = sharing.mesh;
  return o;
}

Dem bed(int count, const Sharing& sharing, const Ranks& ranks) {
  return {options_of_bed(sharing), cloud(count), {floor_at(0, 0.3)}, ranks};
}

/// A liquid that pulls on each bead otherwise.
void put_into_liquid(Dem& dem) {
  dem.set_in_liquid(true);
  for (std::size_t i = 0; i < dem.drag().size(); ++i) {
    const auto id = static_cast<double>(dem.particles().properties[i].id);
    dem.drag()[i] = {{0.01 * std::sin(id), 0.01 * std::cos(id), 0.0}, 1e-7 * (2.0 + std::sin(id))};
  }
}

using Named = std::tuple<std::int64_t, std::int64_t, Image, Vec3, Vec3>;

/// Springs of all contacts of this rank by the ids of their beads.
std::vector<Named> histories(const Dem& dem) {
  std::vector<Named> all;
  const auto& p = dem.particles();
  for (const auto& c : dem.contacts().pairs()) {
    const auto id = [&](std::int32_t k) { return p.properties[static_cast<std::size_t>(k)].id; };
    all.emplace_back(id(c.i), id(c.j), c.image, c.history.spring, c.history.angle);
  }
  std::sort(all.begin(), all.end(), [](const Named& a, const Named& b) {
    return std::tie(std::get<0>(a), std::get<1>(a), std::get<2>(a)) <
           std::tie(std::get<0>(b), std::get<1>(b), std::get<2>(b));
  });
  return all;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

bool same(const Named& a, const Named& b) { return a == b; }

/// Number of differences between a run on all ranks and one alone.
int compare(const Dem& shared, const Dem& alone, const Ranks& ranks) {
  int wrong = 0;
  const auto expect = [&](bool ok, const char* what) {
    if (ok) return;
    ++wrong;
    std::printf("rank %d: %s differ\n", ranks.rank(), what);
  };
  const auto s = shared.snapshot();
  const auto t = alone.snapshot();
  if (ranks.is_first()) {
    expect(same_bits(s.x, t.x), "positions");
    expect(same_bits(s.v, t.v), "velocities");
    expect(same_bits(s.w, t.w), "spins");
    expect(same_bits(s.force, t.force), "forces");
    expect(same_bits(s.torque, t.torque), "torques");
    expect(same_bits(s.drag, t.drag), "drags");
  }
  expect(same_bits(s.wall_force, t.wall_force), "wall forces");
  expect(s.kinetic_energy == t.kinetic_energy, "kinetic energies");
  expect(s.elastic_energy == t.elastic_energy, "elastic energies");
  expect(s.mean_overlap == t.mean_overlap, "mean overlaps");
  expect(s.coordination_number == t.coordination_number, "coordination numbers");
  expect(s.max_overlap_ratio == t.max_overlap_ratio, "largest overlaps");
  expect(s.mean_unbalanced_force == t.mean_unbalanced_force, "unbalanced forces");
  expect(s.mean_contact_force == t.mean_contact_force, "contact forces");
  expect(shared.stable().step == alone.stable().step, "stable steps");
  expect(shared.stable().bead == alone.stable().bead, "beads that set the stable step");
  const auto all = histories(alone);
  const auto mine = histories(shared);
  expect(std::ranges::all_of(mine,
                             [&](const Named& c) {
                               return std::ranges::any_of(
                                   all, [&](const Named& d) { return same(c, d); });
                             }),
         "springs");
  return wrong;
}

int check(int count, std::int64_t steps, const Sharing& sharing) {
  const auto ranks = Ranks::all();
  auto shared = bed(count, sharing, ranks);
  auto alone = bed(count, sharing, Ranks::alone());
  for (int look = 0; look < 4; ++look) {
    shared.run(steps / 4);
    alone.run(steps / 4);
    if (look == 0) {
      for (auto* dem : {&shared, &alone}) {
        dem->scale_diameters(1.01);
        dem->set_velocities(
            {{.id = 3, .v = {0.1, 0.0, -0.2}}, {.id = count - 1, .v = {-0.3, 0.1, 0.0}}});
      }
    }
    if (look == 2) {
      for (auto* dem : {&shared, &alone}) put_into_liquid(*dem);
    }
    if (look == 1) {  // what one rank leaves all can take over, and the other way round
      const auto state = whole(shared.state(), ranks);
      shared = Dem(options_of_bed(sharing), alone.state(), Dem::Lists::as_saved, ranks);
      alone = Dem(options_of_bed(sharing), state, Dem::Lists::as_saved);
    }
  }
  std::vector<std::int64_t> wrong = {compare(shared, alone, ranks)};
  // The bed falls together, so rows must have been dealt anew where that is allowed, and beads touch.
  const bool may_trade = ranks.size() > 1 && sharing.load_tolerance < 2.0;
  if ((shared.repartitions() > 0) != may_trade || histories(alone).empty()) ++wrong[0];
  ranks.sum(wrong);
  if (ranks.is_first()) {
    std::printf(
        "%d ranks by %s, %d beads, %lld steps, %lld renewals, %lld repartitions: %lld "
        "differences\n",
        ranks.size(), sharing.name, count, static_cast<long long>(shared.steps()),
        static_cast<long long>(shared.renewals()), static_cast<long long>(shared.repartitions()),
        static_cast<long long>(wrong[0]));
  }
  return wrong[0] == 0 ? 0 : 1;
}

int check_all(int count, std::int64_t steps) {
  using enum mesh::Boundary;
  // Of the domain below, and lower than the cloud; and one whose axis is a corner of the domain, so that
  // most beads are outside of it and some cells at the wall own the beads beyond.
  const mesh::Box box{.size = {1.2e-3, 1.2e-3, 1.5e-3}, .boundaries = {periodic, periodic, open}};
  const mesh::Cylinder cylinder{.inner_diameter = 1.3e-3, .height = 1.5e-3};
  return check(count, steps, {"rows", 1.2}) | check(count, steps, {"rows", 1e9}) |
         check(count, steps / 2, {"cells", 1.05, mesh_of(box)}) |
         check(count, steps / 2, {"cells of a cylinder", 1.05, mesh_of(cylinder)});
}

}  // namespace
}  // namespace packbed::dem

// ranks_test [BEADS STEPS]
int main(int argc, char** argv) {
  const packbed::MpiSession session;
  const int count = argc > 1 ? std::atoi(argv[1]) : 700;
  const long steps = argc > 2 ? std::atol(argv[2]) : 4000;
  return packbed::dem::check_all(count, steps);
}
