// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Small text functions of messages and readers.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace packbed {

/// Without spaces, tabs and line ends at both sides.
std::string_view trimmed(std::string_view text);

/// Number of characters to insert, delete, replace or swap with their neighbor to turn a into b
/// (optimal string alignment distance), letters of both cases alike.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `name`, if it is near enough to be a slip of the pen.
std::optional<std::string> nearest(std::string_view name, std::span<const std::string> known);

/// "a, b or c".
std::string either_of(std::span<const std::string> names);

/// The whole of `text` as a finite decimal number, independent of the locale; nothing otherwise.
std::optional<double> to_number(std::string_view text);

/// Shortest text that reads back to the same double: "9e-05", "0.38", "1e+10".
std::string shortest(double value);

}  // namespace packbed
