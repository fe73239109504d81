// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The processes that share a run, over MPI. A program that was not started by mpiexec is one rank
/// and never touches MPI.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace packbed {

/// Starts MPI if the program runs under mpiexec, and ends it. Make one in main, first of all.
class MpiSession {
 public:
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
  MpiSession(MpiSession&&) = delete;
  MpiSession& operator=(MpiSession&&) = delete;

  /// Whether the program was started by mpiexec, even with one rank.
  [[nodiscard]] static bool is_started();

 private:
  bool started_ = false;
};

/// All ranks of the program, or this process alone.
class Ranks {
 public:
  /// One rank, whatever else runs.
  static Ranks alone() { return {0, 1}; }
  /// All ranks of the session; one without MPI.
  static Ranks all();

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_first() const { return rank_ == 0; }

  /// The largest of all ranks' values. A NaN of any rank gives NaN.
  [[nodiscard]] double max(double value) const;
  /// The same for several values at once, element by element.
  void max(std::span<double> values) const;
  /// Sums of integers, element by element: the same in any order.
  void sum(std::span<std::int64_t> values) const;

  /// Ends all ranks at once with this exit code.
  [[noreturn]] void abort(int code) const;

  /// One message to and one from another rank; both know the sizes. Nothing is copied on this side.
  struct Mail {
    int rank = 0;
    std::span<const std::byte> out{};
    std::span<std::byte> in{};
  };
  /// Sends and receives all of them; ranks that are not named take no part.
  void trade(std::span<const Mail> mails) const;

  /// Sends to_each[r] to rank r and returns what each rank sent here, by rank.
  template <class T>
  [[nodiscard]] std::vector<std::vector<T>> exchange(
      const std::vector<std::vector<T>>& to_each) const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (size_ == 1) return to_each;
    std::vector<std::vector<std::byte>> out(to_each.size());
    for (std::size_t r = 0; r < to_each.size(); ++r) {
      const auto bytes = std::as_bytes(std::span(to_each[r]));
      out[r].assign(bytes.begin(), bytes.end());
    }
    const auto in = exchange_bytes(out);
    std::vector<std::vector<T>> received(in.size());
    for (std::size_t r = 0; r < in.size(); ++r) {
      received[r].resize(in[r].size() / sizeof(T));
      if (!in[r].empty()) std::memcpy(received[r].data(), in[r].data(), in[r].size());
    }
    return received;
  }

  /// All ranks' values on rank 0, in the order of ranks; nothing on the others.
  template <class T>
  [[nodiscard]] std::vector<T> gather(std::vector<T> values) const {
    if (size_ == 1) return values;
    std::vector<std::vector<T>> to_each(static_cast<std::size_t>(size_));
    to_each[0] = std::move(values);
    std::vector<T> all;
    for (const auto& part : exchange(to_each)) all.insert(all.end(), part.begin(), part.end());
    return all;
  }

 private:
  Ranks(int rank, int size) : rank_(rank), size_(size) {}
  [[nodiscard]] std::vector<std::vector<std::byte>> exchange_bytes(
      const std::vector<std::vector<std::byte>>& to_each) const;

  int rank_;
  int size_;
};

}  // namespace packbed
