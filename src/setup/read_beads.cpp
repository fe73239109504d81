// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "core/error.hpp"
#include "setup/read_sections.hpp"

namespace packbed::setup {

BeadOptions read_beads(Section section, const ColumnOptions& column) {
  BeadOptions beads;
  section.mention({"csv", "count"});
  const auto file = section.optional_file("csv");
  if (file && section.has("count")) section.fail("count", "does not go with beads.csv");
  beads.count = section.optional_integer("count", 0);
  section.finish();
  if (!file) return beads;

  beads.csv = std::filesystem::absolute(*file);
  beads.table = io::read_bead_csv(*file);
  for (std::size_t i = 0; i < beads.table.size(); ++i) {
    const auto& x = beads.table.x[i];
    if (!mesh::contains(column.shape, x)) {
      throw ConfigError(fmt::format(
          "{}: the bead at ({}, {}, {}) m has its center outside the column; z counts from the "
          "lower end, x and y from the axis of a slice or cylinder, from a corner of a box",
          beads.table.place(i), x[0], x[1], x[2]));
    }
  }
  return beads;
}

}  // namespace packbed::setup
