// SPDX-License-Identifier: BSD-3-Clause
#include "resin/resin.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"

namespace packbed::resin {
namespace {

bool is_called(const Resin& resin, std::string_view name) {
  const auto same = [&](std::string_view other) { return edit_distance(other, name) == 0; };
  return same(resin.name) || std::ranges::any_of(resin.aliases, same);
}

template <class Item>
void replace_or_append(std::vector<Item>& items, Item item) {
  const auto old = std::ranges::find(items, item.name, &Item::name);
  if (old == items.end()) {
    items.push_back(std::move(item));
  } else {
    *old = std::move(item);
  }
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
  for (auto& source : other.sources) replace_or_append(sources, std::move(source));
  for (auto& resin : other.resins) replace_or_append(resins, std::move(resin));
}

}  // namespace packbed::resin
