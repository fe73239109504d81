// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <string>

#include <sys/wait.h>

#include "core/file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::test {

struct Outcome {
  int code;
  std::string out;
  std::string err;
};

/// Runs a shell command line in a folder and keeps what it printed.
inline Outcome run_shell(const std::string& command, const std::filesystem::path& folder) {
  const TemporaryFolder scratch;
  const auto out = scratch.path() / "out";
  const auto err = scratch.path() / "err";
  const auto line = "cd '" + folder.string() + "' && { " + command + "; } >'" + out.string() +
                    "' 2>'" + err.string() + "'";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text_file(out), read_text_file(err)};
}

/// Runs the program that was built, with arguments as a shell reads them.
inline Outcome run_packbed(const std::string& arguments,
                           const std::filesystem::path& folder = PACKBED_SOURCE_DIR) {
  return run_shell(std::string(PACKBED_PROGRAM) + " " + arguments, folder);
}

/// The same on some ranks, with or without a flow. Open MPI keeps memory to its end, which is no leak of ours.
inline Outcome run_on_ranks(int ranks,
                            const std::string& arguments,
                            const std::filesystem::path& folder = PACKBED_SOURCE_DIR) {
  return run_shell("ASAN_OPTIONS=detect_leaks=0 " + std::string(PACKBED_PROGRAM) + " " + arguments +
                       " -n " + std::to_string(ranks),
                   folder);
}

}  // namespace packbed::test
