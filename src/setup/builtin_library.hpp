// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace packbed::setup {
/// The text of resins/library.toml, put into the program when it is built.
extern const char* const builtin_library_text;
}  // namespace packbed::setup
