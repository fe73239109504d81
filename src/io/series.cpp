// SPDX-License-Identifier: BSD-3-Clause
#include "io/series.hpp"

#include <cassert>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed::io {

SeriesWriter::SeriesWriter(const std::filesystem::path& file,
                           const std::vector<std::string>& columns)
    : file_(file), stream_(file, std::ios::binary), columns_(columns.size()) {
  stream_ << fmt::format("{}\n", fmt::join(columns, ",")) << std::flush;
  check();
}

void SeriesWriter::row(const std::vector<Cell>& cells) {
  assert(cells.size() == columns_);
  std::vector<std::string> texts;
  texts.reserve(cells.size());
  for (const auto& cell : cells) {
    texts.push_back(std::visit([](const auto& value) { return fmt::format("{}", value); }, cell));
  }
  stream_ << fmt::format("{}\n", fmt::join(texts, ",")) << std::flush;
  check();
}

void SeriesWriter::check() const {
  if (!stream_) {
    throw DataError(
        fmt::format("{}: cannot be written ({})", file_.string(), std::strerror(errno)));
  }
}

}  // namespace packbed::io
