// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The checkpoints of a folder: their names, the newest, and taking old ones away.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace packbed::io {

/// `folder`/checkpoint_000000012345.h5 for number = 12345, usually the step.
std::filesystem::path checkpoint_file(const std::filesystem::path& folder, std::int64_t number);
/// Complete checkpoints of a folder, the oldest first. Empty if there are none or no such folder.
std::vector<std::filesystem::path> checkpoints(const std::filesystem::path& folder);
/// The newest of them. It is not looked into: CheckpointReader does that.
std::optional<std::filesystem::path> latest_checkpoint(const std::filesystem::path& folder);
/// Removes all but the newest `keep` (at least 1). One rank calls it, after commit().
/// Throws DataError if one cannot be removed.
void prune_checkpoints(const std::filesystem::path& folder, std::size_t keep = 2);
/// Removes what a killed run left half written. One rank calls it. Throws DataError.
void remove_unfinished_checkpoints(const std::filesystem::path& folder);

}  // namespace packbed::io
