// SPDX-License-Identifier: BSD-3-Clause
#include "io/frame_series.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "io/durable_file.hpp"

namespace packbed::io {
namespace {

/// Times of a list of frames, in its order. Throws DataError unless it is one of ours.
std::vector<double> times_of(const std::filesystem::path& list) {
  try {
    const auto json = nlohmann::json::parse(read_text_file(list));
    std::vector<double> times;
    for (const auto& entry : json.at("files")) times.push_back(entry.at("time").get<double>());
    return times;
  } catch (const nlohmann::json::exception& error) {
    throw DataError(fmt::format("{}: it is no list of frames ({})", list.string(), error.what()));
  }
}

}  // namespace

FrameSeries::FrameSeries(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {}

FrameSeries FrameSeries::resume(std::filesystem::path folder,
                                std::string name,
                                std::size_t frames) {
  FrameSeries series(std::move(folder), std::move(name));
  const bool is_there = std::filesystem::exists(series.list());
  if (is_there || frames > 0) series.times_ = times_of(series.list());
  if (series.size() < frames) {
    throw DataError(fmt::format("{}: it lists {} frames, but {} were written before the checkpoint",
                                series.list().string(), series.size(), frames));
  }
  series.times_.resize(frames);
  for (std::size_t k = 0; k < frames; ++k) {
    if (const auto frame = series.folder_ / series.frame_name(k); !std::filesystem::exists(frame)) {
      throw DataError(fmt::format("{}: this frame is missing, though {} lists it", frame.string(),
                                  series.list().string()));
    }
  }
  if (is_there) series.write_list();  // first, so that it never names a frame that is gone
  series.remove_later_frames();
  return series;
}

std::string FrameSeries::frame_name(std::size_t k) const {
  return fmt::format("{}_{:06}.hdf", name_, k);
}

std::filesystem::path FrameSeries::next() const { return folder_ / frame_name(size()); }

std::filesystem::path FrameSeries::list() const { return folder_ / (name_ + ".hdf.series"); }

void FrameSeries::add(double time) {
  assert(std::isfinite(time) && (times_.empty() || time >= times_.back()));
  times_.push_back(time);
  write_list();
}

void FrameSeries::write_list() const {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
  for (std::size_t k = 0; k < size(); ++k) {
    text += fmt::format("{}\n    {{\"name\": \"{}\", \"time\": {}}}", k > 0 ? "," : "",
                        frame_name(k), times_[k]);
  }
  write_durably(list(), text + "\n  ]\n}\n");
}

void FrameSeries::remove_later_frames() const {
  std::error_code none;
  // A run that was killed may have written one frame more than the list names, or half of it.
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none)) {
    const auto file = entry.path().filename().string();
    const auto stem = name_ + "_";
    if (!file.starts_with(stem)) continue;
    const auto digits_end = file.find_first_not_of("0123456789", stem.size());
    if (digits_end == std::string::npos || digits_end == stem.size()) continue;
    const auto ending = file.substr(digits_end);
    if (ending != ".hdf" && ending != ".hdf.part") continue;
    if (ending == ".hdf" && std::stoull(file.substr(stem.size())) < size()) continue;
    remove_file(entry.path());
  }
}

}  // namespace packbed::io
