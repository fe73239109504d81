// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include "column/coupled_bed.hpp"
#include "column/protocol/plateau.hpp"
#include "io/series.hpp"
#include "mesh/column_shape.hpp"

namespace packbed::app {

struct RowFigures;

/// plateaus.csv, and profiles of the liquid at the end of each plateau. All ranks call; the first one writes.
class PlateauOutputs {
 public:
  /// Nothing is written before the first plateau.
  explicit PlateauOutputs(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Goes on after what `saved` (from save()) tells of; later rows are cut off.
  PlateauOutputs(std::filesystem::path folder, const nlohmann::ordered_json& saved);

  /// `figures`: of the row that was written at the end of the plateau.
  void write(const column::Plateau& plateau,
             const RowFigures& figures,
             const column::CoupledBed& liquid,
             std::int64_t stage);

  [[nodiscard]] nlohmann::ordered_json save() const;

 private:
  void write_profiles(const RowFigures& figures, const column::CoupledBed& liquid) const;

  std::filesystem::path folder_;
  std::int64_t count_ = 0;
  std::optional<io::SeriesWriter> series_;
};

}  // namespace packbed::app
