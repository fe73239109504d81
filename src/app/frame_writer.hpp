// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "column/coupled_bed.hpp"
#include "dem/dem.hpp"
#include "io/frame_series.hpp"

namespace packbed::app {

/// frames/beads_N.hdf and contacts_N.hdf, and liquid_N.hdf where there is a liquid, with their lists for
/// ParaView. One N is one instant. All ranks call; the first writes.
class FrameWriter {
 public:
  explicit FrameWriter(const std::filesystem::path& folder);
  /// Goes on after what `saved` (from save()) tells of; later frames are taken away.
  FrameWriter(const std::filesystem::path& folder, const nlohmann::ordered_json& saved);

  /// `liquid` may be null.
  void write(const dem::Dem& dem, const column::CoupledBed* liquid);
  [[nodiscard]] nlohmann::ordered_json save() const;

 private:
  void write_beads(const dem::Dem& dem);
  void write_points(const dem::Dem& dem, const std::vector<dem::ContactReport>& contacts);
  void write_liquid(const fluid::Fluid& fluid, double time);

  io::FrameSeries beads_;
  io::FrameSeries contacts_;
  io::FrameSeries liquid_;
};

}  // namespace packbed::app
