// SPDX-License-Identifier: BSD-3-Clause
#include "core/ranks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <mpi.h>

#include "core/error.hpp"

namespace packbed {
namespace {

// mpiexec of Open MPI, and others through PMI, tell the number of ranks in the environment.
bool started_by_mpiexec() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr;
}

bool mpi_runs() {
  int started = 0;
  int ended = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&ended);
  return started != 0 && ended == 0;
}

/// MPI counts in int.
void check_size(std::int64_t total) {
  if (total <= std::numeric_limits<int>::max()) return;
  throw DataError(fmt::format(
      "a rank would exchange {} bytes at once, more than MPI can count; take more ranks with -n",
      total));
}

std::int64_t total_of(const std::vector<std::int64_t>& bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), std::int64_t{0});
}

std::vector<int> offsets(const std::vector<int>& counts) {
  std::vector<int> starts(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  return starts;
}

}  // namespace

MpiSession::MpiSession() {
  if (!started_by_mpiexec()) return;
  MPI_Init(nullptr, nullptr);
  started_ = true;
}

MpiSession::~MpiSession() {
  if (started_) MPI_Finalize();
}

bool MpiSession::is_started() { return mpi_runs(); }

Ranks Ranks::all() {
  if (!mpi_runs()) return alone();
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  return {rank, size};
}

double Ranks::max(double value) const {
  max(std::span(&value, 1));
  return value;
}

// Infinity stands for NaN on the way, since MPI_MAX need not pass NaN on.
void Ranks::max(std::span<double> values) const {
  if (size_ == 1) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (double& value : values) value = std::isnan(value) ? infinity : value;
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX,
                MPI_COMM_WORLD);
  for (double& value : values) {
    if (value == infinity) value = std::numeric_limits<double>::quiet_NaN();
  }
}

void Ranks::sum(std::span<std::int64_t> values) const {
  if (size_ == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_SUM,
                MPI_COMM_WORLD);
}

void Ranks::abort(int code) const {
  if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, code);
  std::exit(code);
}

void Ranks::trade(std::span<const Mail> mails) const {
  std::vector<MPI_Request> requests;
  requests.reserve(2 * mails.size());
  for (const auto& mail : mails) {
    check_size(static_cast<std::int64_t>(std::max(mail.in.size(), mail.out.size())));
    MPI_Irecv(mail.in.data(), static_cast<int>(mail.in.size()), MPI_BYTE, mail.rank, 0,
              MPI_COMM_WORLD, &requests.emplace_back());
  }
  for (const auto& mail : mails) {
    MPI_Isend(mail.out.data(), static_cast<int>(mail.out.size()), MPI_BYTE, mail.rank, 0,
              MPI_COMM_WORLD, &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

std::vector<std::vector<std::byte>> Ranks::exchange_bytes(
    const std::vector<std::vector<std::byte>>& to_each) const {
  if (size_ == 1) return to_each;
  const auto n = static_cast<std::size_t>(size_);
  std::vector<std::int64_t> out_bytes(n);
  std::vector<std::int64_t> in_bytes(n);
  for (std::size_t r = 0; r < n; ++r) out_bytes[r] = static_cast<std::int64_t>(to_each[r].size());
  MPI_Alltoall(out_bytes.data(), 1, MPI_INT64_T, in_bytes.data(), 1, MPI_INT64_T, MPI_COMM_WORLD);
  check_size(total_of(out_bytes));
  check_size(total_of(in_bytes));
  const std::vector<int> out_counts(out_bytes.begin(), out_bytes.end());
  const std::vector<int> in_counts(in_bytes.begin(), in_bytes.end());
  const auto out_starts = offsets(out_counts);
  const auto in_starts = offsets(in_counts);
  std::vector<std::byte> out;
  for (const auto& part : to_each) out.insert(out.end(), part.begin(), part.end());
  std::vector<std::byte> in(static_cast<std::size_t>(in_starts.back() + in_counts.back()));
  MPI_Alltoallv(out.data(), out_counts.data(), out_starts.data(), MPI_BYTE, in.data(),
                in_counts.data(), in_starts.data(), MPI_BYTE, MPI_COMM_WORLD);
  std::vector<std::vector<std::byte>> received(n);
  for (std::size_t r = 0; r < n; ++r) {
    const auto first = in.begin() + in_starts[r];
    received[r].assign(first, first + in_counts[r]);
  }
  return received;
}

}  // namespace packbed
