// SPDX-License-Identifier: BSD-3-Clause
#include "io/durable_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packbed::io {
namespace {

/// `shown` is the name for messages: the file that the user knows, not its temporary.
[[noreturn]] void refuse(const std::filesystem::path& shown, int reason) {
  throw DataError(fmt::format("{}: cannot be written ({})", shown.string(), std::strerror(reason)));
}

/// A descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags, const std::filesystem::path& shown)
      : fd_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (fd_ < 0) refuse(shown, errno);
  }
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;

  [[nodiscard]] int get() const { return fd_; }
  /// 0, or the reason why it failed: some file systems tell only here that the disk is full.
  int close() {
    const int failed = ::close(fd_);
    fd_ = -1;
    return failed != 0 ? errno : 0;
  }

 private:
  int fd_;
};

/// 0, or the reason why it failed.
int write_all(int fd, std::span<const std::byte> content) {
  while (!content.empty()) {
    const auto written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content = content.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

void sync_folder(const std::filesystem::path& file) {
  const auto parent = file.parent_path();
  const Descriptor folder(parent.empty() ? "." : parent, O_RDONLY | O_DIRECTORY, file);
  // EINVAL: a file system that does not know how; nothing can be done about it.
  if (::fsync(folder.get()) != 0 && errno != EINVAL) refuse(file, errno);
}

}  // namespace

std::filesystem::path part_of(const std::filesystem::path& file) {
  auto part = file;
  part += ".part";
  return part;
}

void make_empty(const std::filesystem::path& file) {
  const Descriptor made(file, O_WRONLY | O_CREAT | O_TRUNC, file);
}

void sync_file(const std::filesystem::path& file) {
  Descriptor open_file(file, O_RDONLY, file);
  if (::fsync(open_file.get()) != 0) refuse(file, errno);
  if (const int failed = open_file.close()) refuse(file, failed);
}

void publish(const std::filesystem::path& part, const std::filesystem::path& file) {
  if (::rename(part.c_str(), file.c_str()) != 0) refuse(file, errno);
  sync_folder(file);
}

void write_durably(const std::filesystem::path& file, std::span<const std::byte> content) {
  const auto part = part_of(file);
  Descriptor out(part, O_WRONLY | O_CREAT | O_TRUNC, file);
  int failed = write_all(out.get(), content);
  if (failed == 0 && ::fsync(out.get()) != 0) failed = errno;
  const int failed_at_end = out.close();
  if (failed == 0) failed = failed_at_end;
  if (failed == 0 && ::rename(part.c_str(), file.c_str()) != 0) failed = errno;
  if (failed != 0) {
    ::unlink(part.c_str());
    refuse(file, failed);
  }
  sync_folder(file);
}

void write_durably(const std::filesystem::path& file, std::string_view content) {
  write_durably(file, std::as_bytes(std::span(content.data(), content.size())));
}

void remove_file(const std::filesystem::path& file) {
  std::error_code failed;
  std::filesystem::remove(file, failed);
  if (failed) {
    throw DataError(fmt::format("{}: cannot be removed ({})", file.string(), failed.message()));
  }
}

void cut_file(const std::filesystem::path& file, std::uint64_t bytes) {
  std::error_code failed;
  std::filesystem::resize_file(file, bytes, failed);
  if (failed) refuse(file, failed.value());
}

void reserve(const std::filesystem::path& file, std::uint64_t bytes) {
  const Descriptor open_file(file, O_WRONLY, file);
  const int failed = ::posix_fallocate(open_file.get(), 0, static_cast<off_t>(bytes));
  // A file system that cannot reserve says so in one of these ways; then the writes must tell.
  if (failed == 0 || failed == EOPNOTSUPP || failed == EINVAL) return;
  refuse(file, failed);
}

}  // namespace packbed::io
