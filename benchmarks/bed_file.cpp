// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/bed_file.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace packbed::benchmarks {

Bed read_bed(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  Bed bed;
  bool atoms = false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double low = 0.0;
    double high = 0.0;
    if (line.find("xlo") != std::string::npos && words >> low >> high) bed.width_x = high - low;
    if (line.find("ylo") != std::string::npos && words >> low >> high) bed.width_y = high - low;
    if (line.find("walls in x") != std::string::npos) bed.walls_in_x = true;
    if (line.starts_with("Atoms")) atoms = true;
    std::size_t id = 0;
    int type = 0;
    double d = 0.0;
    double rho = 0.0;
    Vec3 x;
    if (atoms && words >> id >> type >> d >> rho >> x.x >> x.y >> x.z) {
      bed.beads.push_back(bead(bed.beads.size(), d, x));
    }
  }
  return bed;
}

void write_bed(const std::string& file, const Bed& bed) {
  double top = 0.0;
  for (const auto& b : bed.beads) top = std::max(top, b.x.z);
  std::ofstream out(file);
  out.precision(12);
  out << "bed" << (bed.walls_in_x ? ", walls in x" : "") << "\n\n"
      << bed.beads.size() << " atoms\n2 atom types\n\n0 " << bed.width_x << " xlo xhi\n0 "
      << bed.width_y << " ylo yhi\n-1e-4 " << 1.05 * top + 3e-4 << " zlo zhi\n\nAtoms\n\n";
  std::size_t id = 0;
  for (const auto& b : bed.beads) {
    out << ++id << " 1 " << b.properties.diameter << ' ' << b.properties.density << ' ' << b.x.x
        << ' ' << b.x.y << ' ' << b.x.z << '\n';
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

}  // namespace packbed::benchmarks
