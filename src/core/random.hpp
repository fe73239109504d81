// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Random numbers that depend on nothing but (seed, stream, index): the same for any order of
/// calls and any number of ranks. Philox4x32-10 of Salmon et al., SC 2011 (library Random123).

#include <cstdint>

namespace packbed {

/// Independent sequences of one seed. The numbers are part of the file format of restarts: new
/// streams go to the end.
enum class Stream : std::uint32_t { bead_size = 0, bead_position = 1, void_point = 2 };

/// Uniform in the open interval (0, 1), in steps of 2^-52.
double uniform(std::uint64_t seed, Stream stream, std::uint64_t index);

}  // namespace packbed
