// SPDX-License-Identifier: BSD-3-Clause
#include "io/checkpoint_files.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "io/durable_file.hpp"

namespace packbed::io {
namespace {

constexpr std::string_view prefix = "checkpoint_";
constexpr std::string_view ending = ".h5";

bool is_checkpoint_name(const std::string& name, std::string_view end) {
  if (!name.starts_with(prefix) || !name.ends_with(end)) return false;
  if (name.size() <= prefix.size() + end.size()) return false;
  return std::all_of(name.begin() + prefix.size(),
                     name.end() - static_cast<std::ptrdiff_t>(end.size()),
                     [](char c) { return c >= '0' && c <= '9'; });
}

/// Files checkpoint_*END of a folder, by number: names with more digits are larger.
std::vector<std::filesystem::path> named(const std::filesystem::path& folder,
                                         std::string_view end) {
  std::vector<std::filesystem::path> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (is_checkpoint_name(entry.path().filename().string(), end)) files.push_back(entry.path());
  }
  std::ranges::sort(files, {}, [](const std::filesystem::path& file) {
    const auto name = file.filename().string();
    return std::pair(name.size(), name);
  });
  return files;
}

}  // namespace

std::filesystem::path checkpoint_file(const std::filesystem::path& folder, std::int64_t number) {
  assert(number >= 0);
  return folder / fmt::format("{}{:012}{}", prefix, number, ending);
}

std::vector<std::filesystem::path> checkpoints(const std::filesystem::path& folder) {
  return named(folder, ending);
}

std::optional<std::filesystem::path> latest_checkpoint(const std::filesystem::path& folder) {
  const auto all = checkpoints(folder);
  if (all.empty()) return {};
  return all.back();
}

void prune_checkpoints(const std::filesystem::path& folder, std::size_t keep) {
  assert(keep > 0);
  auto all = checkpoints(folder);
  while (all.size() > keep) {
    remove_file(all.front());
    all.erase(all.begin());
  }
}

void remove_unfinished_checkpoints(const std::filesystem::path& folder) {
  for (const auto& part : named(folder, ".h5.part")) remove_file(part);
}

}  // namespace packbed::io
