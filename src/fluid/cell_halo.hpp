// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Values of the halo cells of a part of a mesh, from the ranks that own them.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ranks.hpp"
#include "mesh/cell_partition.hpp"
#include "mesh/mesh_part.hpp"

namespace packbed::fluid {

class CellHalo {
 public:
  /// All ranks make theirs at once.
  CellHalo(const mesh::MeshPart& part, const mesh::CellPartition& partition, const Ranks& ranks);

  /// Brings the halo of a field up to date; one value per cell of the part, own cells first.
  template <class T>
  void refresh(std::vector<T>& field) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (neighbors_.empty()) return;
    std::vector<Ranks::Mail> mails;
    mails.reserve(neighbors_.size());
    for (auto& with : neighbors_) {
      with.out.resize(with.send.size() * sizeof(T));
      for (std::size_t k = 0; k < with.send.size(); ++k) {
        std::memcpy(with.out.data() + k * sizeof(T), &field[with.send[k]], sizeof(T));
      }
      const auto to = std::span(field).subspan(with.first, with.count);
      mails.push_back({.rank = with.rank, .out = with.out, .in = std::as_writable_bytes(to)});
    }
    ranks_.trade(mails);
  }

 private:
  /// With one other rank: own cells that it wants, and the run of the halo that it owns.
  struct Neighbor {
    int rank = 0;
    std::vector<std::uint32_t> send;
    std::size_t first = 0, count = 0;
    std::vector<std::byte> out;
  };
  Ranks ranks_;
  std::vector<Neighbor> neighbors_;
};

}  // namespace packbed::fluid
