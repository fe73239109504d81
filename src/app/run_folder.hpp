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

}  // namespace packbed::app
