// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "resin/resin.hpp"
#include "setup/resin_file.hpp"

namespace packbed::app {

/// Throws ConfigError naming the nearest one.
const resin::Resin& find_resin(const resin::Library& library, const std::string& name);

/// A value of a resin in SI. Throws ConfigError telling the option that would give it instead.
double property(const resin::Resin& resin, const std::string& key, const std::string& option);

}  // namespace packbed::app
