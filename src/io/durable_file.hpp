// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Files that are whole or not there, also after a power failure: written under a temporary name,
/// brought to disk, renamed, and the folder brought to disk. All throw DataError saying why.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace packbed::io {

/// `file` with ".part" behind it.
std::filesystem::path part_of(const std::filesystem::path& file);

/// Writes all of it, or leaves what was there before.
void write_durably(const std::filesystem::path& file, std::span<const std::byte> content);
void write_durably(const std::filesystem::path& file, std::string_view content);

/// Makes an empty file, or empties the one that is there.
void make_empty(const std::filesystem::path& file);
/// Waits until the content of a file is on disk.
void sync_file(const std::filesystem::path& file);
/// Renames a file that is on disk, over an older one if there is one.
void publish(const std::filesystem::path& part, const std::filesystem::path& file);

void remove_file(const std::filesystem::path& file);
/// Makes a file end after `bytes` bytes.
void cut_file(const std::filesystem::path& file, std::uint64_t bytes);

/// Takes the disk space for a file that grows to `bytes`, so that a full disk shows here and not in
/// the middle of a library. It may become longer than it will be in the end: cut_file() gives the rest back.
void reserve(const std::filesystem::path& file, std::uint64_t bytes);

}  // namespace packbed::io
