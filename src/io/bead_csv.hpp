// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Beads from and to CSV files: header `x_m,y_m,z_m,diameter_m` and, where wanted, velocity, spin,
/// `fixed`, material and resin of each bead (docs/manual/bead-files.md).

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace packbed::io {

/// Columns of a bead file. SI units. Optional columns are empty or have one value per bead.
struct BeadTable {
  std::vector<std::array<double, 3>> x;      ///< center [m]
  std::vector<double> diameter;              ///< of the bead as simulated [m]
  std::vector<std::array<double, 3>> v;      ///< velocity [m/s]; zero where not given
  std::vector<std::array<double, 3>> omega;  ///< spin [rad/s]; zero where not given
  std::vector<std::int64_t> id;              ///< optional; the row, from 0, where not given
  std::vector<bool> fixed;                   ///< optional
  std::vector<double> density;               ///< optional [kg/m3]
  std::vector<double> youngs_modulus;        ///< optional [Pa]
  std::vector<double> poisson_ratio;         ///< optional
  std::vector<std::string> resin;            ///< optional, names of the library
  std::filesystem::path file;                ///< as named in messages
  std::vector<std::size_t> line;             ///< of each bead in the file

  [[nodiscard]] std::size_t size() const { return diameter.size(); }
  /// "beads.csv:12", for messages about a bead.
  [[nodiscard]] std::string place(std::size_t bead) const;
  bool operator==(const BeadTable&) const = default;
};

/// Throws DataError if the file cannot be read; ConfigError naming line, column and value for a
/// missing or unknown column, a value that is not a finite number, or one out of range.
BeadTable read_bead_csv(const std::filesystem::path& file);

/// One bead as it is written.
struct BeadRow {
  std::int64_t id;
  std::array<double, 3> x, v, w;  ///< [m], [m/s], [rad/s]
  double diameter;                ///< [m]
  bool fixed;
  double density;         ///< [kg/m3]
  double youngs_modulus;  ///< [Pa]
  double poisson_ratio;
  std::array<double, 3> force, torque;  ///< of contacts and walls [N], [N m]
};

/// Writes beads in full double precision, in a form that read_bead_csv takes. Throws DataError if the
/// file cannot be written.
void write_bead_csv(const std::filesystem::path& file, const std::vector<BeadRow>& rows);

}  // namespace packbed::io
