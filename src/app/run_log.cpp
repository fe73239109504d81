// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_log.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/ranks.hpp"

namespace packbed::app {

RunLog::RunLog(const std::filesystem::path& file, bool go_on) : file_(file) {
  if (Ranks::all().is_first()) {
    stream_.open(file, go_on ? std::ios::app | std::ios::binary : std::ios::binary);
  }
}

void RunLog::line(std::string_view text) {
  if (!Ranks::all().is_first()) return;
  stream_ << text << '\n' << std::flush;
  if (!stream_) {
    throw DataError(
        fmt::format("{}: cannot be written ({})", file_.string(), std::strerror(errno)));
  }
}

}  // namespace packbed::app
