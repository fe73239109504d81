// SPDX-License-Identifier: BSD-3-Clause
#include "core/file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "core/error.hpp"

namespace packbed {

std::string read_text_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw DataError(fmt::format("{}: it is a folder, not a file", file.string()));
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw DataError(fmt::format("{}: cannot be opened ({})", file.string(), std::strerror(errno)));
  }
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw DataError(fmt::format("{}: reading it failed", file.string()));
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

void write_text_file(const std::filesystem::path& file, std::string_view text) {
  auto temporary = file;
  temporary += ".part";
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code failed;
  if (stream) std::filesystem::rename(temporary, file, failed);
  if (!stream || failed) {
    const std::string why = failed ? failed.message() : std::strerror(errno);
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw DataError(fmt::format("{}: cannot be written ({})", file.string(), why));
  }
}

}  // namespace packbed
