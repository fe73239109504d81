// SPDX-License-Identifier: BSD-3-Clause
#include "dem/partition.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace packbed::dem {
namespace {

std::variant<RowUnits, CellUnits> units_of(const Domain& domain,
                                           double cell,
                                           std::shared_ptr<const mesh::ColumnMesh> mesh) {
  if (mesh) return CellUnits(domain, std::move(mesh));
  return RowUnits(domain, cell);
}

std::int64_t count(const std::variant<RowUnits, CellUnits>& units) {
  return std::visit([](const auto& u) { return u.count(); }, units);
}

}  // namespace

Partition::Partition(const Domain& domain,
                     double cell,
                     const Ranks& ranks,
                     std::shared_ptr<const mesh::ColumnMesh> mesh)
    : units_(units_of(domain, cell, std::move(mesh))),
      ranks_(ranks),
      runs_(count(units_), ranks.size()) {}

int Partition::owner(const Vec3& x) const {
  return std::visit([&](const auto& units) { return runs_.owner(units.unit(x)); }, units_);
}

std::vector<int> Partition::owners_within(const Vec3& x, double reach) const {
  std::vector<int> owners;
  const auto add = [&](const std::vector<UnitRange>& ranges) {
    for (const auto& r : ranges) {
      for (int o = runs_.owner(r.first); o <= runs_.owner(r.last); ++o) owners.push_back(o);
    }
    std::ranges::sort(owners);
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
  };
  std::visit(
      [&](const auto& units) {
        add(units.slabs_within(x, reach));
        if (owners.size() == 1) return;  // far from the next rank, as most are
        owners.clear();
        add(units.within(x, reach));
      },
      units_);
  return owners;
}

double Partition::fullest_over_mean(const std::vector<Vec3>& own,
                                    const std::vector<std::int64_t>& work) const {
  std::vector<std::int64_t> loads(static_cast<std::size_t>(ranks_.size()), 0);
  for (std::size_t k = 0; k < own.size(); ++k) {
    loads[static_cast<std::size_t>(owner(own[k]))] += work[k];
  }
  ranks_.sum(loads);
  const auto total = std::accumulate(loads.begin(), loads.end(), std::int64_t{0});
  const auto fullest = *std::ranges::max_element(loads);
  return total > 0 ? static_cast<double>(fullest) * ranks_.size() / static_cast<double>(total)
                   : 1.0;
}

double Partition::balance(const std::vector<Vec3>& own,
                          const std::vector<std::int64_t>& work,
                          double tolerance,
                          bool always) {
  if (ranks_.size() == 1) return 1.0;
  double worst = 1.0;
  if (!always) {
    worst = fullest_over_mean(own, work);
    if (worst <= tolerance) return worst;
  }
  std::visit([&](auto& units) { units.fit(own, ranks_); }, units_);
  std::vector<std::int64_t> loads(static_cast<std::size_t>(count(units_)), 0);
  std::visit(
      [&](const auto& units) {
        for (std::size_t k = 0; k < own.size(); ++k) {
          loads[static_cast<std::size_t>(units.unit(own[k]))] += work[k];
        }
      },
      units_);
  ranks_.sum(loads);
  runs_ = mesh::CellPartition(count(units_), ranks_.size());
  runs_.cut(loads);
  return worst;
}

}  // namespace packbed::dem
