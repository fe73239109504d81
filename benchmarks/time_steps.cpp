// SPDX-License-Identifier: BSD-3-Clause
// time_steps BED STEP WARM COUNT REPEATS: whole time steps of a bed, alone or under mpiexec, in blocks.
//
// Prints one line per block: million bead-steps per second of all ranks together, by wall time and by
// the processor time of the slowest rank; renewals; then the largest resident memory of rank 0.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include <sys/resource.h>

#include "benchmarks/beds.hpp"
#include "core/freed_memory.hpp"

namespace {

double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int time_steps(char** arguments) {
  const auto ranks = packbed::Ranks::all();
  auto dem = [&] {
    const auto bed = packbed::benchmarks::packed_bed(arguments[0]);
    return packbed::benchmarks::make_dem(bed, std::atof(arguments[1]), ranks);
  }();
  dem.run(std::atol(arguments[2]));
  const long count = std::atol(arguments[3]);
  for (long block = 0; block < std::atol(arguments[4]); ++block) {
    const auto renewals = dem.renewals();
    const double wall = wall_time();
    const double cpu = processor_time();
    dem.run(count);
    const double spent_wall = ranks.max(wall_time() - wall);
    const double spent_cpu = ranks.max(processor_time() - cpu);
    if (!ranks.is_first()) continue;
    const double work = 1e-6 * static_cast<double>(count * dem.bead_count());
    std::printf("%s ranks %d: %.3f M/s by wall time, %.3f by processor time, %ld renewals\n",
                arguments[0], ranks.size(), work / spent_wall, work / spent_cpu,
                static_cast<long>(dem.renewals() - renewals));
    std::fflush(stdout);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  if (ranks.is_first()) {
    std::printf(
        "%s: %lld beads, largest resident memory %ld KiB, %.3f pairs listed per bead\n",
        arguments[0], static_cast<long long>(dem.bead_count()), usage.ru_maxrss,
        static_cast<double>(dem.contacts().size()) / static_cast<double>(dem.particles().size()));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fputs("usage: time_steps BED STEP WARM COUNT REPEATS\n", stderr);
    return 1;
  }
  packbed::give_back_freed_memory();
  const packbed::MpiSession session;
  try {
    return time_steps(argv + 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "time_steps: %s\n", error.what());
    return 1;
  }
}
