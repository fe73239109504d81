// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Everything that packbed throws on purpose. `main` prints the message on one line and returns
/// the code of its kind (docs/manual/exit-codes.md).

#include <stdexcept>

namespace packbed {

/// Codes that the program returns to the shell.
enum class ExitCode { success = 0, input = 1, numerics = 2, files = 3, stopped = 4 };

struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
  [[nodiscard]] virtual ExitCode exit_code() const noexcept = 0;
};

/// The user's input is wrong: names file, line, key, value and what is accepted.
struct ConfigError : Error {
  using Error::Error;
  [[nodiscard]] ExitCode exit_code() const noexcept override { return ExitCode::input; }
};

/// A value is refused by code that does not know where it came from; the reader that does catches
/// it and throws a ConfigError with file, line and key.
struct ValueError : ConfigError {
  using ConfigError::ConfigError;
};

/// A file or folder is missing, unreadable or cannot be written.
struct DataError : Error {
  using Error::Error;
  [[nodiscard]] ExitCode exit_code() const noexcept override { return ExitCode::files; }
};

/// The numerics failed; names stage, step, time and the worst place.
struct DivergenceError : Error {
  using Error::Error;
  [[nodiscard]] ExitCode exit_code() const noexcept override { return ExitCode::numerics; }
};

/// A run was stopped by a signal after it had written a checkpoint; says how to go on.
struct Stopped : Error {
  using Error::Error;
  [[nodiscard]] ExitCode exit_code() const noexcept override { return ExitCode::stopped; }
};

}  // namespace packbed
