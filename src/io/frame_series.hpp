// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The frames of a run in their order: `beads.hdf.series`, which ParaView opens as one thing in time.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace packbed::io {

/// Frames NAME_000000.hdf, NAME_000001.hdf ... of a folder and the list of them with their times,
/// NAME.hdf.series. Numbers may be left out: frames of one instant have one number in all series of a run. One
/// process keeps it. A frame is first written to next(), then added: the list
/// never names a file that is not whole.
class FrameSeries {
 public:
  /// An empty series; a list and frames of that name that are there are left alone until they are
  /// replaced. Nothing is written before the first add().
  FrameSeries(std::filesystem::path folder, std::string name);

  /// How far a series goes.
  struct Extent {
    std::size_t frames = 0;       ///< that are there
    std::size_t next_number = 0;  ///< at least `frames`
  };

  /// Goes on with a series where it was `extent` long. Later frames are taken away, from the list and from
  /// the folder. Throws DataError if the list is missing (and frames > 0), broken, or shorter, if one of
  /// those frames is gone, or if the folder cannot be written.
  static FrameSeries resume(std::filesystem::path folder, std::string name, const Extent& extent);
  /// The same for a series that leaves no number out.
  static FrameSeries resume(std::filesystem::path folder, std::string name, std::size_t frames) {
    return resume(std::move(folder), std::move(name), Extent{frames, frames});
  }

  /// A series as it stands, to be read. Throws DataError as resume() does; a missing list too.
  static FrameSeries read(std::filesystem::path folder, std::string name);

  /// Where the next frame goes.
  [[nodiscard]] std::filesystem::path next() const;
  /// Puts the frame that was written to next() on the list, at this time [s], not before the last
  /// one. The list is replaced at once. Throws DataError if it cannot be written.
  void add(double time);
  /// Leaves the number of next() out.
  void skip() { ++next_number_; }

  [[nodiscard]] std::size_t size() const { return times_.size(); }
  [[nodiscard]] Extent extent() const { return {size(), next_number_}; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const std::vector<std::size_t>& numbers() const { return numbers_; }  ///< likewise
  [[nodiscard]] std::filesystem::path file(std::size_t number) const {
    return folder_ / frame_name(number);
  }
  [[nodiscard]] std::filesystem::path list() const;

 private:
  [[nodiscard]] std::string frame_name(std::size_t number) const;
  [[nodiscard]] std::optional<std::size_t> number_in(const std::string& file) const;
  void read_list();
  void check_files() const;
  void write_list() const;
  void remove_later_frames() const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<double> times_;
  std::vector<std::size_t> numbers_;  ///< ascending, one per time
  std::size_t next_number_ = 0;
};

}  // namespace packbed::io
