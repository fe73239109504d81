// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace packbed::app {

/// Makes `folder` and takes away what an earlier run wrote there, nothing else. `inputs` are the
/// files that this run reads. Throws ConfigError if one of them would be taken away, or if there are
/// results and `overwrite` is false; DataError if the folder cannot be made or cleaned.
void make_run_folder(const std::filesystem::path& folder,
                     bool overwrite,
                     const std::vector<std::filesystem::path>& inputs);

/// Keeps other runs out of a folder that exists for as long as it lives, also if this process is killed.
/// Throws ConfigError if there is one.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  int descriptor_;
};

}  // namespace packbed::app
