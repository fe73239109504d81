// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The head of a checkpoint: the first 512 bytes, which HDF5 leaves to us (its "user block"). It is
/// text, says what the file is, how long it must be and the checksum (XXH3, 64 bits) of all that
/// follows, and has a checksum of its own:
///
///     packbed checkpoint
///     head    8c5a0d1be1e4bd2f     checksum of the 512 bytes after this line
///     format  2
///     bytes   123456               length of the file
///     xxh3    0123456789abcdef     checksum of the bytes from 512 on
///     program packbed 0.1.0
///
/// (without the remarks) and spaces up to a last line end. The first two lines stay as they are in
/// every format to come.

#include <cstddef>
#include <filesystem>

namespace packbed::io {

inline constexpr std::size_t seal_bytes = 512;

/// Writes the head of a file that is complete otherwise. Throws DataError.
void seal(const std::filesystem::path& file, int format);

/// Throws DataError unless the file is complete, not a bit of it was changed since seal(), and it has
/// this format.
void check_seal(const std::filesystem::path& file, int format);

}  // namespace packbed::io
