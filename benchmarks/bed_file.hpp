// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beds as LAMMPS data files of atom style sphere ("id type diameter density x y z" after "Atoms"), which
/// LIGGGHTS and LAMMPS read too.

#include <string>

#include "benchmarks/beds.hpp"

namespace packbed::benchmarks {

/// Throws std::runtime_error if the file cannot be read.
Bed read_bed(const std::string& file);

void write_bed(const std::string& file, const Bed& bed);

}  // namespace packbed::benchmarks
