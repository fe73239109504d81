// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace packbed::app {

/// run.log: what was done, line by line. Nothing is written but on the first rank.
class RunLog {
 public:
  /// Begins the file, or goes on with it. Throws DataError if it cannot be written, here and later.
  RunLog(const std::filesystem::path& file, bool go_on);

  /// A line; it is on disk when this returns.
  void line(std::string_view text);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace packbed::app
