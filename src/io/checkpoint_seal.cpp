// SPDX-License-Identifier: BSD-3-Clause
#include "io/checkpoint_seal.hpp"

#include <cassert>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <xxhash.h>

#include "core/error.hpp"
#include "core/version.hpp"

namespace packbed::io {
namespace {

constexpr std::string_view magic = "packbed checkpoint\n";
constexpr std::size_t head_line = 25;  ///< length of "head    " with 16 digits and line end
constexpr std::size_t after_head = magic.size() + head_line;

std::string hex(std::uint64_t checksum) { return fmt::format("{:016x}", checksum); }

/// The head without its first two lines.
std::string body(int format, std::uint64_t bytes, const std::string& checksum) {
  auto text = fmt::format("format  {}\nbytes   {}\nxxh3    {}\nprogram packbed {}\n", format, bytes,
                          checksum, version);
  text.resize(seal_bytes - after_head - 1, ' ');
  return text + '\n';
}

std::string head_of(std::string_view rest) {
  return fmt::format("{}head    {}\n", magic, hex(XXH3_64bits(rest.data(), rest.size())));
}

/// Value of "key     value" in the head; empty if it is not there.
std::string value_of(const std::string& head, std::string_view key) {
  const auto line = fmt::format("\n{:<8}", key);
  const auto start = head.find(line);
  if (start == std::string::npos) return "";
  const auto first = start + line.size();
  return head.substr(first, head.find('\n', first) - first);
}

template <class Stream>
void require(const Stream& stream, const std::filesystem::path& file, const char* what) {
  if (!stream) {
    throw DataError(
        fmt::format("{}: cannot be {} ({})", file.string(), what, std::strerror(errno)));
  }
}

/// Checksum of all bytes after the head.
std::string checksum_of(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(seal_bytes);
  require(stream, file, "read");
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              XXH3_freeState);
  XXH3_64bits_reset(state.get());
  std::vector<char> block(std::size_t{1} << 16U);
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    XXH3_64bits_update(state.get(), block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw DataError(fmt::format("{}: reading it failed", file.string()));
  return hex(XXH3_64bits_digest(state.get()));
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw DataError(fmt::format("{}: {}; take another checkpoint", file.string(), why));
}

/// The head, once its own checksum is right.
std::string checked_head(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw DataError(fmt::format("{}: it is a folder, not a checkpoint", file.string()));
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  require(stream, file, "opened");
  std::string head(seal_bytes, '\0');
  stream.read(head.data(), seal_bytes);
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const auto common = std::min(head.size(), magic.size());
  if (head.compare(0, common, magic, 0, common) != 0) {
    throw DataError(fmt::format("{}: it is no checkpoint of packbed, or its first line is damaged",
                                file.string()));
  }
  if (head.size() < seal_bytes) {
    refuse(file, fmt::format("the checkpoint is truncated: {} bytes are there, less than its head",
                             head.size()));
  }
  if (head.compare(0, after_head, head_of(std::string_view(head).substr(after_head))) != 0) {
    refuse(file, "the checkpoint is altered: the checksum of its head is wrong");
  }
  return head;
}

}  // namespace

void seal(const std::filesystem::path& file, int format) {
  const auto rest = body(format, std::filesystem::file_size(file), checksum_of(file));
  errno = 0;
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream << head_of(rest) << rest << std::flush;
  stream.close();
  require(stream, file, "written");
}

void check_seal(const std::filesystem::path& file, int format) {
  const auto head = checked_head(file);
  if (const auto found = value_of(head, "format"); found != std::to_string(format)) {
    throw DataError(fmt::format(
        "{}: the checkpoint has format {}, written by {}; packbed {} reads format {}: go "
        "on with the program that wrote it",
        file.string(), found, value_of(head, "program"), version, format));
  }
  const auto bytes = std::to_string(std::filesystem::file_size(file));
  if (const auto needed = value_of(head, "bytes"); bytes != needed) {
    refuse(file,
           fmt::format("the checkpoint is truncated or has grown: {} bytes are there, {} were "
                       "written",
                       bytes, needed));
  }
  const auto found = checksum_of(file);
  if (const auto needed = value_of(head, "xxh3"); found != needed) {
    refuse(file, fmt::format("the checkpoint is altered: the checksum of its content is {}, not {}",
                             found, needed));
  }
}

}  // namespace packbed::io
