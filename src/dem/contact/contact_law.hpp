// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The list of contact laws. To add one: write its header, put it in the variant, give it an
/// example in contact_laws_test.cpp, name it in setup/. The compiler reports whatever is forgotten.

#include <variant>

#include "dem/contact/hertz_mindlin.hpp"
#include "dem/contact/hooke.hpp"
#include "dem/contact/viscous_hooke.hpp"

namespace packbed::dem {

using ContactLaw = std::variant<Hooke, HertzMindlin, ViscousHooke>;

}  // namespace packbed::dem
