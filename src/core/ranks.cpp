// SPDX-License-Identifier: BSD-3-Clause
#include "core/ranks.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

#include <mpi.h>

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
  if (size_ == 1) return value;
  // Infinity stands for NaN on the way, since MPI_MAX need not pass NaN on.
  double worst = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return std::isinf(worst) && worst > 0.0 ? std::numeric_limits<double>::quiet_NaN() : worst;
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

std::vector<std::vector<std::byte>> Ranks::exchange_bytes(
    const std::vector<std::vector<std::byte>>& to_each) const {
  if (size_ == 1) return to_each;
  const auto n = static_cast<std::size_t>(size_);
  std::vector<int> out_counts(n);
  std::vector<int> in_counts(n);
  for (std::size_t r = 0; r < n; ++r) out_counts[r] = static_cast<int>(to_each[r].size());
  MPI_Alltoall(out_counts.data(), 1, MPI_INT, in_counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
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
