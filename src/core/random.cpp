// SPDX-License-Identifier: BSD-3-Clause
#include "core/random.hpp"

#include <Random123/philox.h>

namespace packbed {

double uniform(std::uint64_t seed, Stream stream, std::uint64_t index) {
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32U); };
  const r123::Philox4x32::key_type key{{low(seed), high(seed)}};
  const r123::Philox4x32::ctr_type counter{
      {low(index), high(index), static_cast<std::uint32_t>(stream), 0}};
  const auto words = r123::Philox4x32{}(counter, key);
  const std::uint64_t bits = (static_cast<std::uint64_t>(words[0]) << 32U) | words[1];
  // The middle of one of 2^52 equal cells: exact in double, never 0 or 1.
  return (static_cast<double>(bits >> 12U) + 0.5) * 0x1.0p-52;
}

}  // namespace packbed
