// SPDX-License-Identifier: BSD-3-Clause
#include "io/frame_series.hpp"

#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "io/durable_file.hpp"

namespace packbed::io {
FrameSeries::FrameSeries(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {}

FrameSeries FrameSeries::resume(std::filesystem::path folder,
                                std::string name,
                                const Extent& extent) {
  FrameSeries series(std::move(folder), std::move(name));
  const bool is_there = std::filesystem::exists(series.list());
  if (is_there || extent.frames > 0) series.read_list();
  if (series.size() < extent.frames) {
    throw DataError(fmt::format("{}: it lists {} frames, but {} were written before the checkpoint",
                                series.list().string(), series.size(), extent.frames));
  }
  series.times_.resize(extent.frames);
  series.numbers_.resize(extent.frames);
  series.next_number_ = extent.next_number;
  series.check_files();
  if (is_there) series.write_list();  // first, so that it never names a frame that is gone
  series.remove_later_frames();
  return series;
}

FrameSeries FrameSeries::read(std::filesystem::path folder, std::string name) {
  FrameSeries series(std::move(folder), std::move(name));
  series.read_list();
  series.check_files();
  return series;
}

void FrameSeries::check_files() const {
  for (const auto number : numbers_) {
    if (std::filesystem::exists(file(number))) continue;
    throw DataError(fmt::format("{}: this frame is missing, though {} lists it",
                                file(number).string(), list().string()));
  }
}

// Throws DataError unless it is one of ours.
void FrameSeries::read_list() {
  try {
    const auto json = nlohmann::json::parse(read_text_file(list()));
    for (const auto& entry : json.at("files")) {
      const auto frame = entry.at("name").get<std::string>();
      const auto number = number_in(frame);
      if (!number || frame_name(*number) != frame || *number < next_number_) {
        throw DataError(
            fmt::format("{}: it is no list of frames (\"{}\" is none that could stand there)",
                        list().string(), frame));
      }
      times_.push_back(entry.at("time").get<double>());
      numbers_.push_back(*number);
      next_number_ = *number + 1;
    }
  } catch (const nlohmann::json::exception& error) {
    throw DataError(fmt::format("{}: it is no list of frames ({})", list().string(), error.what()));
  }
}

std::string FrameSeries::frame_name(std::size_t number) const {
  return fmt::format("{}_{:06}.hdf", name_, number);
}

// Of a name that begins as those of our frames do.
std::optional<std::size_t> FrameSeries::number_in(const std::string& file) const {
  std::size_t number = 0;
  const auto begin = name_.size() + 1;
  if (!file.starts_with(name_ + "_")) return {};
  const auto* end = file.data() + file.size();
  if (std::from_chars(file.data() + begin, end, number).ec != std::errc()) return {};
  return number;
}

std::filesystem::path FrameSeries::next() const { return folder_ / frame_name(next_number_); }

std::filesystem::path FrameSeries::list() const { return folder_ / (name_ + ".hdf.series"); }

void FrameSeries::add(double time) {
  assert(std::isfinite(time) && (times_.empty() || time >= times_.back()));
  times_.push_back(time);
  numbers_.push_back(next_number_++);
  write_list();
}

void FrameSeries::write_list() const {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
  for (std::size_t k = 0; k < size(); ++k) {
    text += fmt::format("{}\n    {{\"name\": \"{}\", \"time\": {}}}", k > 0 ? "," : "",
                        frame_name(numbers_[k]), times_[k]);
  }
  write_durably(list(), text + "\n  ]\n}\n");
}

void FrameSeries::remove_later_frames() const {
  std::error_code none;
  // A run that was killed may have written one frame more than the list names, or half of it.
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none)) {
    const auto file = entry.path().filename().string();
    const auto number = number_in(file);
    const auto digits_end = file.find_first_not_of("0123456789", name_.size() + 1);
    if (!number || digits_end == std::string::npos) continue;
    const auto ending = file.substr(digits_end);
    if (ending != ".hdf" && ending != ".hdf.part") continue;
    if (ending == ".hdf" && *number < next_number_) continue;
    remove_file(entry.path());
  }
}

}  // namespace packbed::io
