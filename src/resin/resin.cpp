// SPDX-License-Identifier: BSD-3-Clause
#include "resin/resin.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/text.hpp"

namespace packbed::resin {
namespace {

bool is_called(const Resin& resin, std::string_view name) {
  const auto same = [&](std::string_view other) { return edit_distance(other, name) == 0; };
  return same(resin.name) || std::ranges::any_of(resin.aliases, same);
}

}  // namespace

const Property* Resin::find(std::string_view key) const {
  const auto found = std::ranges::find(properties, key, &Property::key);
  return found == properties.end() ? nullptr : &*found;
}

const Resin* Library::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(resins, [&](const Resin& resin) { return is_called(resin, name); });
  return found == resins.end() ? nullptr : &*found;
}

std::vector<std::string> Library::names() const {
  std::vector<std::string> all;
  for (const auto& resin : resins) {
    all.push_back(resin.name);
    all.insert(all.end(), resin.aliases.begin(), resin.aliases.end());
  }
  return all;
}

void Library::add(Library other) {
  // The user's stand first, so that their names and aliases are found before ours.
  std::erase_if(resins, [&](const Resin& ours) {
    return std::ranges::any_of(other.resins,
                               [&](const Resin& own) { return is_called(own, ours.name); });
  });
  std::erase_if(sources, [&](const Source& ours) {
    return std::ranges::find(other.sources, ours.name, &Source::name) != other.sources.end();
  });
  std::ranges::move(resins, std::back_inserter(other.resins));
  std::ranges::move(sources, std::back_inserter(other.sources));
  *this = std::move(other);
}

}  // namespace packbed::resin
