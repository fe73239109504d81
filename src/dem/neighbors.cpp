// SPDX-License-Identifier: BSD-3-Clause
#include "dem/neighbors.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "dem/cell_grid.hpp"

namespace packbed::dem {
namespace {

/// j and image in one number that sorts alike.
std::uint64_t partner(const PairKey& p) {
  const auto turns = [&](std::size_t axis) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(p.image[axis]) + 128);
  };
  return static_cast<std::uint64_t>(p.j) << 24U | turns(0) << 16U | turns(1) << 8U | turns(2);
}

/// Pairs sorted by their key: first counted into place by i, then each bead's few by j and image.
template <class Pair>
void sort_by_key(std::vector<Pair>& pairs, std::size_t beads) {
  std::vector<std::uint32_t> next(beads + 2);
  for (const auto& p : pairs) ++next[static_cast<std::size_t>(p.i) + 2];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Pair> result(pairs.size());
  for (const auto& p : pairs) result[next[static_cast<std::size_t>(p.i) + 1]++] = p;
  pairs = std::move(result);
  for (std::size_t i = 0; i < beads; ++i) {
    std::sort(pairs.begin() + next[i], pairs.begin() + next[i + 1],
              [](const Pair& a, const Pair& b) { return partner(a) < partner(b); });
  }
}

/// The same pair seen from its other end.
void turn_key(PairKey& p) {
  std::swap(p.i, p.j);
  for (auto& turns : p.image) turns = static_cast<std::int8_t>(-turns);
}

}  // namespace

void turn_around(PairContact& p) {
  turn_key(p);
  p.history.spring = -p.history.spring;
  p.history.angle = -p.history.angle;
}

// Each pair is looked for from its larger bead, within that bead's own diameter: the cost of a contact
// does not grow with the ratio of sizes.
std::vector<PairKey> find_pairs(const Particles& particles, const Domain& domain, double skin) {
  const std::size_t count = particles.size();
  if (count < 2) return {};
  std::vector<PairKey> pairs;
  pairs.reserve(4 * count);
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += 2.0 * particles.radius(i);
    const CellGrid grid(particles, domain, sum / static_cast<double>(count) + skin);
    for (std::size_t i = 0; i < count; ++i) {
      const double radius = particles.radius(i);
      grid.for_smaller_near(particles.motion[i].x, radius, skin,
                            [&](std::size_t j, const Image& image) {
                              if (j == i || (j < i && particles.radius(j) == radius))
                                return;  // j finds i
                              if (!particles.is_own(i) && !particles.is_own(j)) return;
                              PairKey p{.i = static_cast<std::int32_t>(i),
                                        .j = static_cast<std::int32_t>(j),
                                        .image = image};
                              if (j < i) turn_key(p);
                              pairs.push_back(p);
                            });
    }
  }
  sort_by_key(pairs, count);
  return pairs;
}

KnownPair renamed(std::int32_t i, std::int32_t j, const Image& image, std::int32_t old) {
  KnownPair p{{.i = i, .j = j, .image = image}, old};
  if (i > j) {
    turn_key(p);
    p.old = -1 - old;
  }
  return p;
}

std::vector<KnownPair> carry_over(const ContactList& old,
                                  const std::vector<std::int32_t>& place,
                                  const std::vector<Image>& wraps) {
  std::vector<KnownPair> pairs;
  pairs.reserve(old.size());
  for (std::size_t k = 0; k < old.size(); ++k) {
    const auto key = old.key(k);
    const auto i = static_cast<std::size_t>(key.i);
    const auto j = static_cast<std::size_t>(key.j);
    if (place[i] < 0 || place[j] < 0) continue;
    Image image = key.image;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      image[axis] = static_cast<std::int8_t>(image[axis] + wraps[i][axis] - wraps[j][axis]);
    }
    pairs.push_back(renamed(place[i], place[j], image, static_cast<std::int32_t>(k)));
  }
  return pairs;
}

void sort_pairs(std::vector<KnownPair>& pairs, std::size_t beads) { sort_by_key(pairs, beads); }

}  // namespace packbed::dem
