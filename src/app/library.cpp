// SPDX-License-Identifier: BSD-3-Clause
#include "app/library.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace packbed::app {

const resin::Resin& find_resin(const resin::Library& library, const std::string& name) {
  if (const auto* resin = library.find(name)) return *resin;
  const auto near = nearest(name, library.names());
  throw ConfigError(fmt::format("resin \"{}\" is not in the library{}; `packbed resins` lists it",
                                name, near ? fmt::format(", did you mean \"{}\"?", *near) : ""));
}

double property(const resin::Resin& resin, const std::string& key, const std::string& option) {
  if (const auto* p = resin.find(key)) return p->si;
  throw ConfigError(
      fmt::format("the library has no {} of \"{}\"; give {}", key, resin.name, option));
}

}  // namespace packbed::app
