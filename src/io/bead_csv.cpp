// SPDX-License-Identifier: BSD-3-Clause
#include "io/bead_csv.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"

namespace packbed::io {
namespace {

const std::vector<std::string> known_columns = {"x_m",
                                                "y_m",
                                                "z_m",
                                                "diameter_m",
                                                "vx_m_s",
                                                "vy_m_s",
                                                "vz_m_s",
                                                "wx_rad_s",
                                                "wy_rad_s",
                                                "wz_rad_s",
                                                "fixed",
                                                "density_kg_m3",
                                                "youngs_modulus_Pa",
                                                "poisson_ratio",
                                                "resin",
                                                "id"};

/// Columns that we write and do not read: results.
const std::vector<std::string> result_columns = {"fx_N",   "fy_N",   "fz_N",
                                                 "tx_N_m", "ty_N_m", "tz_N_m"};

void check_header(const CsvTable& table) {
  for (const auto& column : table.header()) {
    if (std::ranges::find(known_columns, column) != known_columns.end()) continue;
    if (std::ranges::find(result_columns, column) != result_columns.end()) continue;
    const auto near = nearest(column, known_columns);
    throw ConfigError(fmt::format("{}: unknown column \"{}\"{}; known are {}", table.header_place(),
                                  column, near ? fmt::format(", did you mean \"{}\"?", *near) : "",
                                  either_of(known_columns)));
  }
}

int required(const CsvTable& table, const std::string& name) {
  const int column = table.find(name);
  if (column < 0) {
    throw ConfigError(
        fmt::format("{}: column \"{}\" is missing; a bead file needs "
                    "x_m,y_m,z_m,diameter_m",
                    table.header_place(), name));
  }
  return column;
}

/// One optional column, checked by `accepts`.
template <class Accepts>
std::vector<double> numbers(const CsvTable& table,
                            const std::string& name,
                            Accepts accepts,
                            const char* accepted) {
  std::vector<double> values;
  const int column = table.find(name);
  if (column < 0) return values;
  values.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double value = table.number(row, column);
    if (!accepts(value)) {
      throw ConfigError(
          fmt::format("{}: {} = {} {}", table.place(row), name, table.text(row, column), accepted));
    }
    values.push_back(value);
  }
  return values;
}

bool flag(const CsvTable& table, std::size_t row, int column) {
  const auto& text = table.text(row, column);
  if (text == "0" || text == "1") return text == "1";
  throw ConfigError(fmt::format("{}: fixed = \"{}\" must be 0 or 1", table.place(row), text));
}

std::vector<std::int64_t> ids(const CsvTable& table) {
  std::vector<std::int64_t> values;
  const int column = table.find("id");
  if (column < 0) return values;
  std::set<std::int64_t> seen;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double id = table.number(row, column);
    constexpr double most = 9007199254740991.0;  // beyond, a double does not hold all whole numbers
    const bool is_whole = id == std::floor(id) && id >= 0.0 && id <= most;
    if (is_whole) values.push_back(static_cast<std::int64_t>(id));
    if (!is_whole || !seen.insert(values.back()).second) {
      throw ConfigError(
          fmt::format("{}: id = {} must be a whole number from 0 to {:.0f}, and not there twice",
                      table.place(row), table.text(row, column), most));
    }
  }
  return values;
}

std::vector<std::array<double, 3>> vectors(const CsvTable& table,
                                           const std::array<std::string, 3>& names) {
  std::vector<std::array<double, 3>> values(table.rows(), {0.0, 0.0, 0.0});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int column = table.find(names[axis]);
    if (column < 0) continue;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      values[row][axis] = table.number(row, column);
    }
  }
  return values;
}

}  // namespace

std::string BeadTable::place(std::size_t bead) const {
  return fmt::format("{}:{}", file.string(), line[bead]);
}

BeadTable read_bead_csv(const std::filesystem::path& file) {
  const CsvTable table(file);
  check_header(table);
  for (const auto* name : {"x_m", "y_m", "z_m", "diameter_m"}) required(table, name);
  const auto positive = [](double value) { return value > 0.0; };

  BeadTable beads;
  beads.x = vectors(table, {"x_m", "y_m", "z_m"});
  beads.v = vectors(table, {"vx_m_s", "vy_m_s", "vz_m_s"});
  beads.omega = vectors(table, {"wx_rad_s", "wy_rad_s", "wz_rad_s"});
  beads.diameter = numbers(table, "diameter_m", positive, "must be positive");
  beads.density = numbers(table, "density_kg_m3", positive, "must be positive");
  beads.youngs_modulus = numbers(table, "youngs_modulus_Pa", positive, "must be positive");
  beads.poisson_ratio = numbers(
      table, "poisson_ratio", [](double nu) { return nu > -1.0 && nu <= 0.5; },
      "is outside (-1, 0.5]");
  if (const int column = table.find("fixed"); column >= 0) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
      beads.fixed.push_back(flag(table, row, column));
    }
  }
  if (const int column = table.find("resin"); column >= 0) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
      beads.resin.push_back(table.text(row, column));
    }
  }
  beads.id = ids(table);
  beads.file = file;
  for (std::size_t row = 0; row < table.rows(); ++row) beads.line.push_back(table.line(row));
  return beads;
}

void write_bead_csv(const std::filesystem::path& file, const std::vector<BeadRow>& rows) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out,
      "id,x_m,y_m,z_m,diameter_m,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,fixed,"
      "density_kg_m3,youngs_modulus_Pa,poisson_ratio,fx_N,fy_N,fz_N,tx_N_m,ty_N_m,tz_N_m\n");
  for (const auto& r : rows) {
    fmt::format_to(out, "{},{},{},{},{},{},{},{}\n", r.id, fmt::join(r.x, ","), r.diameter,
                   fmt::join(r.v, ","), fmt::join(r.w, ","), r.fixed ? 1 : 0,
                   fmt::format("{},{},{}", r.density, r.youngs_modulus, r.poisson_ratio),
                   fmt::format("{},{}", fmt::join(r.force, ","), fmt::join(r.torque, ",")));
  }
  write_text_file(file, {text.data(), text.size()});
}

}  // namespace packbed::io
