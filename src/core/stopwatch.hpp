// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace packbed {

/// Adds up the wall time of pieces of work. For reports: nothing that is simulated may depend on it.
class Stopwatch {
 public:
  /// Does the work, and counts the time also if it throws.
  template <class Work>
  decltype(auto) time(Work&& work) {
    const Lap lap(seconds_);
    return work();
  }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  class Lap {
   public:
    explicit Lap(double& sum) : sum_(sum) {}
    ~Lap() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Lap(const Lap&) = delete;
    Lap& operator=(const Lap&) = delete;
    Lap(Lap&&) = delete;
    Lap& operator=(Lap&&) = delete;

   private:
    double& sum_;
    Clock::time_point start_ = Clock::now();
  };

  double seconds_ = 0.0;
};

}  // namespace packbed
