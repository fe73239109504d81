// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "dem/dem.hpp"
#include "io/frame_series.hpp"

namespace packbed::app {

/// frames/beads_N.hdf and contacts_N.hdf with their lists for ParaView. All ranks call; the first writes.
class FrameWriter {
 public:
  explicit FrameWriter(const std::filesystem::path& folder);
  /// Goes on after the first `frames` of them; later ones are taken away.
  FrameWriter(const std::filesystem::path& folder, std::size_t frames);

  void write(const dem::Dem& dem);
  [[nodiscard]] std::size_t size() const { return beads_.size(); }

 private:
  io::FrameSeries beads_;
  io::FrameSeries contacts_;
};

}  // namespace packbed::app
