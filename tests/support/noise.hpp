// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/random.hpp"

namespace packbed::test {

/// Normal deviates of mean 0 and deviation 1 (Box and Muller), the same in every run.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : seed_(seed) {}
  double operator()() {
    const double a = uniform(seed_, Stream::bead_size, next_++);
    const double b = uniform(seed_, Stream::bead_size, next_++);
    return std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * std::numbers::pi * b);
  }

 private:
  std::uint64_t seed_;
  std::uint64_t next_ = 0;
};

}  // namespace packbed::test
