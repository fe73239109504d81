// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "io/durable_file.hpp"
#include "io/on_all.hpp"

namespace packbed::io {
namespace {

/// What all ranks together write in one call: MPI-IO counts in int.
constexpr std::size_t bytes_at_once = std::size_t{1} << 28U;
/// Disk space taken beyond the arrays: for texts, and what HDF5 notes about all of it.
constexpr std::uint64_t taken_at_start = std::uint64_t{1} << 20U;

void prepare(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw DataError(
        fmt::format("{}: the folder cannot be made ({})", folder.string(), failed.message()));
  }
  remove_unfinished_checkpoints(folder);
}

hdf5::Object create(const std::filesystem::path& part, const Ranks& ranks) {
  std::optional<hdf5::Object> made;
  on_all(ranks, [&] {
    made.emplace(hdf5::create_file(part, seal_bytes, ranks));
    for (const auto* group : {"arrays", "numbers", "texts"}) made->create_group(group).close();
  });
  on_first(ranks, [&] { reserve(part, taken_at_start); });
  return std::move(*made);
}

/// The file that is written first, open on all ranks.
hdf5::Object open_part(const std::filesystem::path& part, const Ranks& ranks) {
  on_first(ranks, [&] {
    prepare(part.parent_path());
    make_empty(part);  // so that a folder that cannot be written is told in plain words
  });
  try {
    return create(part, ranks);
  } catch (const DataError&) {
    std::error_code ignored;
    if (ranks.is_first()) std::filesystem::remove(part, ignored);
    throw;
  }
}

template <class T>
T of_first(T value, const Ranks& ranks) {
  std::vector<std::vector<T>> to_each(static_cast<std::size_t>(ranks.size()));
  if (ranks.is_first()) std::ranges::fill(to_each, std::vector{value});
  return ranks.exchange(to_each).at(0).at(0);
}

/// Rows of each rank.
std::vector<std::int64_t> rows_of_ranks(std::int64_t mine, const Ranks& ranks) {
  const std::vector<std::vector<std::int64_t>> to_each(static_cast<std::size_t>(ranks.size()),
                                                       {mine});
  std::vector<std::int64_t> rows;
  for (const auto& one : ranks.exchange(to_each)) rows.push_back(one.at(0));
  return rows;
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::filesystem::path& folder,
                                   std::int64_t number,
                                   const Ranks& ranks)
    : file_(checkpoint_file(folder, number)),
      part_(part_of(file_)),
      ranks_(ranks),
      content_(open_part(part_, ranks)),
      taken_(taken_at_start),
      may_close_(ranks.size() == 1) {}

CheckpointWriter::~CheckpointWriter() {
  if (is_committed_) return;
  // Closing is done by all ranks together. If one of them fell out of line, it would wait for ever.
  if (!may_close_) {
    content_.abandon();
    return;
  }
  try {
    content_.close();
  } catch (const DataError&) {  // NOLINT(bugprone-empty-catch): what went wrong is told already
  }
  if (!ranks_.is_first()) return;
  std::error_code ignored;
  std::filesystem::resize_file(part_, 0, ignored);  // HDF5 keeps a file open that it cannot close
  std::filesystem::remove(part_, ignored);
}

template <class Act>
void CheckpointWriter::together(Act act) {
  try {
    on_all(ranks_, act);
  } catch (const DataError&) {
    may_close_ = true;
    throw;
  }
}

void CheckpointWriter::array_of(const std::string& name, hdf5::ArrayForm mine, const void* values) {
  const auto rows = rows_of_ranks(mine.rows, ranks_);
  auto first = std::accumulate(rows.begin(), rows.begin() + ranks_.rank(), std::int64_t{0});
  auto all = mine;
  all.rows = std::accumulate(rows.begin(), rows.end(), std::int64_t{0});
  const auto row_bytes = mine.width * hdf5::bytes_of(mine.element);
  // Before HDF5 knows of it: an HDF5 file that cannot be written any more cannot be closed either.
  taken_ += static_cast<std::uint64_t>(all.rows) * row_bytes;
  together([&] {
    if (ranks_.is_first()) reserve(part_, taken_);
  });
  std::optional<hdf5::Object> array;
  together([&] { array.emplace(content_.create_array("arrays/" + name, all)); });

  const auto at_once = static_cast<std::int64_t>(std::max<std::size_t>(
      1, bytes_at_once / row_bytes / static_cast<std::size_t>(ranks_.size())));
  const auto* next = static_cast<const std::byte*>(values);
  for (std::int64_t done = 0; done < std::ranges::max(rows); done += at_once) {
    auto now = mine;
    now.rows = std::clamp<std::int64_t>(mine.rows - done, 0, at_once);
    together([&] { array->write_rows(first, now, next, ranks_.size() > 1); });
    first += now.rows;
    next += static_cast<std::size_t>(now.rows) * row_bytes;
  }
  together([&] { array->close(); });
}

namespace {

template <class T>
hdf5::ArrayForm form_of(std::span<const T> values, std::size_t width) {
  assert(width > 0 && values.size() % width == 0);
  return {.element = hdf5::element_of<T>(),
          .rows = static_cast<std::int64_t>(values.size() / width),
          .width = width};
}

}  // namespace

void CheckpointWriter::array(const std::string& name,
                             std::span<const double> values,
                             std::size_t width) {
  array_of(name, form_of(values, width), values.data());
}
void CheckpointWriter::array(const std::string& name,
                             std::span<const std::int64_t> values,
                             std::size_t width) {
  array_of(name, form_of(values, width), values.data());
}
void CheckpointWriter::array(const std::string& name,
                             std::span<const std::int32_t> values,
                             std::size_t width) {
  array_of(name, form_of(values, width), values.data());
}
void CheckpointWriter::array(const std::string& name,
                             std::span<const std::int8_t> values,
                             std::size_t width) {
  array_of(name, form_of(values, width), values.data());
}
void CheckpointWriter::array(const std::string& name,
                             std::span<const std::uint8_t> values,
                             std::size_t width) {
  array_of(name, form_of(values, width), values.data());
}
void CheckpointWriter::array(const std::string& name, std::span<const Vec3> values) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  array_of(name,
           {.element = hdf5::Element::float64,
            .rows = static_cast<std::int64_t>(values.size()),
            .width = 3},
           values.data());
}

void CheckpointWriter::number(const std::string& name, double value) {
  const double first = of_first(value, ranks_);
  together([&] { content_.open_group("numbers").write_attribute(name, first); });
}

void CheckpointWriter::integer(const std::string& name, std::int64_t value) {
  const std::int64_t first = of_first(value, ranks_);
  together([&] { content_.open_group("numbers").write_attribute(name, std::span(&first, 1)); });
}

void CheckpointWriter::text(const std::string& name, std::string_view value) {
  assert(value.find('\0') == std::string_view::npos);
  const auto first = first_said(ranks_, ranks_.is_first() ? std::string(value) : "");
  taken_ += first.size();
  together([&] {
    if (ranks_.is_first()) reserve(part_, taken_);
  });
  together([&] { content_.write_text("texts/" + name, first, ranks_.is_first()); });
}

std::filesystem::path CheckpointWriter::commit() {
  assert(!is_committed_);
  together([&] { content_.flush(); });
  // MPI-IO cuts what was taken and not used by itself when it closes the file.
  const bool must_cut = ranks_.size() == 1;
  const auto length = must_cut ? content_.end() : 0;
  together([&] { content_.close(); });
  together([&] {
    if (!ranks_.is_first()) return;
    if (must_cut) cut_file(part_, length);
    seal(part_, checkpoint_format);
    sync_file(part_);
    publish(part_, file_);
  });
  is_committed_ = true;
  return file_;
}

}  // namespace packbed::io
