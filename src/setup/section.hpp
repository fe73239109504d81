// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// One table of a case file, read key by key. It checks types, units and ranges, fills defaults
/// in, keeps an echo of what counts, and refuses what it was never asked for. Every message is
/// "FILE:LINE: table.key = value ...; what is accepted".

#include <array>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "core/quantity.hpp"
#include "setup/echo.hpp"

namespace packbed::setup {

/// Values that a key accepts, in SI.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_belongs = false;
  bool high_belongs = false;
  std::string_view refusal;  ///< "must be positive"

  [[nodiscard]] constexpr bool contains(double value) const {
    return (low_belongs ? value >= low : value > low) &&
           (high_belongs ? value <= high : value < high);
  }
};

namespace bounds {
inline constexpr Bounds positive{.low = 0.0, .refusal = "must be positive"};
inline constexpr Bounds not_negative{
    .low = 0.0, .low_belongs = true, .refusal = "must not be negative"};
inline constexpr Bounds between_0_and_1{.low = 0.0, .high = 1.0, .refusal = "is outside (0, 1)"};
inline constexpr Bounds void_fraction{
    .low = 0.0, .high = 1.0, .high_belongs = true, .refusal = "is outside (0, 1]"};
inline constexpr Bounds restitution{
    .low = 0.0,
    .high = 1.0,
    .high_belongs = true,
    .refusal = "is outside (0, 1]; 1 is a bead that rebounds as fast as it came"};
inline constexpr Bounds poisson_ratio{
    .low = -1.0, .high = 0.5, .high_belongs = true, .refusal = "is outside (-1, 0.5]"};
inline constexpr Bounds at_least_1{
    .low = 1.0, .low_belongs = true, .refusal = "must be at least 1"};
}  // namespace bounds

/// What a key is if the user leaves it out.
struct Fallback {
  std::string text;  ///< as a user would write it: "20 degC", "0.1"
  std::string origin = "default";
};

/// What the tables of one file share.
struct Reading {
  const UnitSystem& units;
  std::filesystem::path file;  ///< as named in messages
  Echo echo;
  std::optional<double> full_load{};  ///< superficial velocity of "1 RHL", once it is known [m/s]
};

/// A flow as a superficial velocity [m/s]; `area` turns a flow rate into one [m2]. Throws ValueError.
double to_velocity(const std::string& text, double area, const Reading& reading);

class Section {
 public:
  /// A table found at `header` ("[resin.sizes]"), called `name` ("resin.sizes") in messages.
  Section(Reading& reading, const toml::table& table, std::string name, std::string header);

  [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }

  /// Numbers with units; the value in SI. Without a fallback the key is required.
  double quantity(std::string_view key,
                  Dimension dimension,
                  const Bounds& bounds,
                  const std::optional<Fallback>& fallback = {});
  std::optional<double> optional_quantity(std::string_view key,
                                          Dimension dimension,
                                          const Bounds& bounds);
  /// Three of them, as [ "4 mm", "4 mm", "20 mm" ].
  std::array<double, 3> three_quantities(std::string_view key,
                                         Dimension dimension,
                                         const Bounds& bounds);
  /// A quantity, or the word (then nothing is returned).
  std::optional<double> quantity_or_word(std::string_view key,
                                         Dimension dimension,
                                         const Bounds& bounds,
                                         std::string_view word,
                                         const Fallback& fallback);
  /// A superficial velocity, given as such, as a flow rate through `area` [m2], or as a relative hydrodynamic
  /// load ("0.75 RHL"); in m/s.
  double flow(std::string_view key, double area, const std::optional<Fallback>& fallback = {});

  std::optional<double> optional_flow(std::string_view key, double area);

  std::int64_t integer(std::string_view key,
                       std::int64_t low,
                       const std::optional<Fallback>& fallback = {});
  std::optional<std::int64_t> optional_integer(std::string_view key, std::int64_t low);
  bool boolean(std::string_view key, bool fallback);
  std::string word(std::string_view key, const std::optional<Fallback>& fallback = {});
  std::optional<std::string> optional_word(std::string_view key);
  /// A list of words; none if it is not there.
  std::vector<std::string> words(std::string_view key);
  /// Position of the word among `names`, the only ones accepted.
  std::size_t choice(std::string_view key,
                     std::initializer_list<std::string_view> names,
                     const std::optional<Fallback>& fallback = {});
  /// A file that exists, taken from the folder of the case, as messages should name it; the echo
  /// has its full path.
  std::optional<std::filesystem::path> optional_file(std::string_view key);
  /// Likewise the folder of a run that has ended.
  std::optional<std::filesystem::path> optional_run(std::string_view key);

  /// All keys that the table has.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The text of the quantity read last, as the user wrote it.
  [[nodiscard]] const std::string& last_text() const { return last_text_; }

  /// A table inside this one; an empty one if it is not there.
  Section table(std::string_view key);
  /// An array of tables inside this one, none if it is not there.
  std::vector<Section> tables(std::string_view key);

  /// Keys that this table may have; whatever else it has is a slip of the pen. Reading a key
  /// mentions it too.
  void mention(std::string_view key);
  void mention(std::initializer_list<std::string_view> keys);
  /// Refuses the key, saying why ("does not apply to shape = \"box\"").
  void refuse(std::string_view key, std::string_view why);
  /// Refuses keys that were never asked for. Call it last.
  void finish() const;

  /// ConfigError at a key, or where the key would stand: "FILE:LINE: name.key = value MESSAGE".
  [[noreturn]] void fail(std::string_view key, std::string_view message) const;
  /// ConfigError for a missing key.
  [[noreturn]] void fail_missing(std::string_view key, std::string_view message) const;
  /// ConfigError about the table as a whole.
  [[noreturn]] void fail_here(std::string_view message) const;

 private:
  const toml::node* find(std::string_view key);
  [[nodiscard]] std::string place(const toml::node* node) const;
  [[nodiscard]] std::optional<std::filesystem::path> path_at(std::string_view key);
  [[nodiscard]] std::string full(std::string_view key) const;
  [[nodiscard]] std::optional<std::string> quantity_text(std::string_view key,
                                                         Dimension dimension,
                                                         const std::optional<Fallback>& fallback);
  [[nodiscard]] double convert(std::string_view key,
                               const std::string& text,
                               Dimension dimension,
                               const Bounds& bounds) const;
  /// Keeps a value in the echo; `fallback` tells where it came from if it was not given.
  void note(EchoEntry entry, bool given, const std::optional<Fallback>& fallback);
  void note_word(std::string_view key,
                 const std::string& word,
                 bool given,
                 const std::optional<Fallback>& fallback);
  EchoTable& echo();

  Reading* reading_;
  const toml::table* table_;
  std::string name_;
  std::string header_;
  std::optional<std::size_t> echo_;  ///< place of this table in the echo, from its first key on
  std::vector<std::string> known_;
  std::string last_text_;
};

/// "give a length such as "90 um"", for messages about a key.
std::string such_as(std::string_view key, Dimension dimension);

}  // namespace packbed::setup
