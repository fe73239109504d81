// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Frames of a run (io/frames.hpp) read back. Real numbers come in the precision in which they were stored,
/// 32 bits as a rule.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "io/frames.hpp"

namespace packbed::io {

/// A frame on the list of a run.
struct ListedFrame {
  std::size_t number = 0;  ///< of its file, the same in all series of a run at one instant
  double time = 0.0;       ///< [s]
  std::filesystem::path file;
};

/// All frames of NAME.hdf.series in `folder`, in their order. Throws DataError if the list is missing or broken, or
/// names a frame that is not there.
std::vector<ListedFrame> listed_frames(const std::filesystem::path& folder,
                                       const std::string& name);

// Each of these throws DataError, on one line with the file, if it cannot be read, is no such frame, lacks an array
// or has one of another length, or holds a value that is not finite.

/// Beads as frames hold them, one value each.
struct StoredBeads {
  double time = 0.0;           ///< [s]
  std::vector<Vec3> x;         ///< centers [m]
  std::vector<double> radius;  ///< [m]
  std::vector<std::int64_t> id;
  std::vector<Vec3> velocity;  ///< [m/s]
};
StoredBeads read_bead_frame(const std::filesystem::path& file);

struct StoredContacts {
  double time = 0.0;  ///< [s]
  std::vector<ContactLine> contacts;
  /// Frames of packbed up to 0.1.0 do not have ContactLine::tangential: it is zero there.
  bool has_tangential_vectors = true;
};
StoredContacts read_contact_frame(const std::filesystem::path& file);

/// Cells of the liquid, one value each.
struct StoredLiquid {
  double time = 0.0;  ///< [s]
  std::vector<Vec3> center;
  std::vector<double> volume;  ///< [m3]
  std::vector<double> void_fraction;
  std::vector<Vec3> velocity;    ///< interstitial [m/s]
  std::vector<double> pressure;  ///< without its hydrostatic part [Pa]
};
StoredLiquid read_liquid_frame(const std::filesystem::path& file);

}  // namespace packbed::io
