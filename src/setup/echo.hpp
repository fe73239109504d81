// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What was read: every key of a case with the value that counts, given or filled in. It is
/// written as a case file again (`packbed check`, runs/<case>/case.toml) and as JSON.

#include <optional>
#include <string>
#include <vector>

#include "core/quantity.hpp"

namespace packbed::setup {

struct EchoEntry {
  std::string key = {};
  std::string toml = {};                    ///< the value as it stands in a case file
  std::vector<double> si = {};              ///< its number or numbers in SI; none for words
  std::optional<Dimension> dimension = {};  ///< of these numbers; none for pure ones
  std::vector<std::string> words = {};      ///< the plain text of a word or list of words
  bool is_list = false;
  std::string origin = {};  ///< "default", "library: ..."; empty if the user gave it
};

struct EchoTable {
  std::string header;  ///< "[column]", "[[protocol]]"; empty for the top of the file
  std::vector<EchoEntry> entries;
};

using Echo = std::vector<EchoTable>;

/// A case file with every value filled in; SI and origin stand in comments.
std::string to_toml(const Echo& echo);

/// One value of a case, by its full key: {"protocol[2].to", "0.007675"}; numbers in SI with all digits.
struct FlatValue {
  std::string key;
  std::string value;
  bool operator==(const FlatValue&) const = default;
};

/// All values of a case, so that two cases can be compared whatever units they are written in.
std::vector<FlatValue> flat_values(const Echo& echo);

/// Text as a TOML string.
std::string toml_string(const std::string& text);

}  // namespace packbed::setup
