// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/cell_halo.hpp"

namespace packbed::fluid {

CellHalo::CellHalo(const mesh::MeshPart& part,
                   const mesh::CellPartition& partition,
                   const Ranks& ranks)
    : ranks_(ranks) {
  if (ranks.size() == 1) return;
  const auto n = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<std::int64_t>> wanted(n);
  std::vector<std::size_t> first(n, 0);
  // The halo is in the order of cells and ranks own runs of cells: what one of them owns is a run.
  for (auto k = static_cast<std::size_t>(part.own); k < part.cell.size(); ++k) {
    const auto owner = static_cast<std::size_t>(partition.owner(part.cell[k]));
    if (wanted[owner].empty()) first[owner] = k;
    wanted[owner].push_back(part.cell[k]);
  }
  const auto asked = ranks.exchange(wanted);
  const auto first_own = partition.first(ranks.rank());
  for (std::size_t r = 0; r < n; ++r) {
    if (wanted[r].empty() && asked[r].empty()) continue;
    auto& with = neighbors_.emplace_back();
    with.rank = static_cast<int>(r);
    with.first = first[r];
    with.count = wanted[r].size();
    for (const auto cell : asked[r])
      with.send.push_back(static_cast<std::uint32_t>(cell - first_own));
  }
}

}  // namespace packbed::fluid
