// SPDX-License-Identifier: BSD-3-Clause
#include "io/series.hpp"

#include <cassert>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/durable_file.hpp"

namespace packbed::io {
namespace {

std::string header(const std::vector<std::string>& columns) {
  return fmt::format("{}\n", fmt::join(columns, ","));
}

/// Throws DataError unless a series with these columns has a row that ends after `bytes` bytes.
void check_resumable(const std::filesystem::path& file,
                     const std::string& header,
                     std::int64_t bytes) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw DataError(fmt::format("{}: cannot be opened ({})", file.string(), std::strerror(errno)));
  }
  std::string there;
  std::getline(stream, there);
  if (there + '\n' != header) {
    throw DataError(fmt::format(
        "{}: its columns are not those of this case, so that it cannot be continued; it "
        "begins with \"{}\", not with \"{}\"",
        file.string(), there.substr(0, 500), header.substr(0, header.size() - 1)));
  }
  const auto length = static_cast<std::int64_t>(std::filesystem::file_size(file));
  if (length < bytes) {
    throw DataError(
        fmt::format("{}: {} bytes are there, but {} were when the checkpoint was written",
                    file.string(), length, bytes));
  }
  stream.clear();
  stream.seekg(bytes - 1);
  if (bytes < static_cast<std::int64_t>(header.size()) || stream.get() != '\n') {
    throw DataError(
        fmt::format("{}: no row ends after {} bytes, so that it cannot be cut there; was "
                    "it changed since the checkpoint was written?",
                    file.string(), bytes));
  }
}

}  // namespace

SeriesWriter::SeriesWriter(const std::filesystem::path& file,
                           const std::vector<std::string>& columns)
    : file_(file), stream_(file, std::ios::binary), columns_(columns.size()) {
  append(header(columns));
}

SeriesWriter::SeriesWriter(std::filesystem::path file, std::size_t columns, std::int64_t bytes)
    : file_(std::move(file)),
      stream_(file_, std::ios::binary | std::ios::app),
      columns_(columns),
      bytes_(bytes) {}

SeriesWriter SeriesWriter::resume(const std::filesystem::path& file,
                                  const std::vector<std::string>& columns,
                                  std::int64_t bytes) {
  check_resumable(file, header(columns), bytes);
  cut_file(file, static_cast<std::uint64_t>(bytes));
  return {file, columns.size(), bytes};
}

void SeriesWriter::row(const std::vector<Cell>& cells) {
  assert(cells.size() == columns_);
  std::vector<std::string> texts;
  texts.reserve(cells.size());
  for (const auto& cell : cells) {
    texts.push_back(std::visit([](const auto& value) { return fmt::format("{}", value); }, cell));
  }
  append(fmt::format("{}\n", fmt::join(texts, ",")));
}

void SeriesWriter::append(const std::string& line) {
  errno = 0;
  stream_ << line << std::flush;
  if (stream_) {
    bytes_ += static_cast<std::int64_t>(line.size());
    return;
  }
  const std::string why = std::strerror(errno);
  // Take back what was written of the line. The stream may then be used again, should there be space.
  stream_.clear();
  stream_.close();
  std::error_code ignored;
  std::filesystem::resize_file(file_, static_cast<std::uintmax_t>(bytes_), ignored);
  stream_.open(file_, std::ios::binary | std::ios::app);
  throw DataError(fmt::format("{}: cannot be written ({})", file_.string(), why));
}

void SeriesWriter::sync() const { sync_file(file_); }

}  // namespace packbed::io
