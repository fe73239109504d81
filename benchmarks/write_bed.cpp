// SPDX-License-Identifier: BSD-3-Clause
// write_bed NAME FILE: a bed of benchmarks/beds.hpp as a LAMMPS data file.
#include <cstdio>
#include <exception>

#include "benchmarks/bed_file.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: write_bed NAME FILE\n", stderr);
    return 1;
  }
  try {
    packbed::benchmarks::write_bed(argv[2], packbed::benchmarks::packed_bed(argv[1]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_bed: %s\n", error.what());
    return 1;
  }
}
