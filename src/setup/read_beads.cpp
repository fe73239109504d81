// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "setup/read_sections.hpp"

namespace packbed::setup {

namespace {

std::int64_t beads_of(const std::filesystem::path& run, const Section& section) {
  const auto file = run / "summary.json";
  const auto summary = nlohmann::json::parse(read_text_file(file), nullptr, false);
  if (summary.is_object() && summary.contains("beads")) return summary["beads"];
  section.fail("run",
               fmt::format("is refused: {} has no number of beads; that run was not carried out",
                           file.string()));
}

}  // namespace

BeadOptions read_beads(Section section, const ColumnOptions& column) {
  BeadOptions beads;
  section.mention({"csv", "count", "run"});
  const auto file = section.optional_file("csv");
  if (file && section.has("count")) section.fail("count", "does not go with beads.csv");
  beads.count = section.optional_integer("count", 0);
  if (const auto run = section.optional_run("run")) {
    for (const auto* key : {"csv", "count"}) {
      if (section.has(key)) section.fail(key, "does not go with beads.run");
    }
    beads.run = std::filesystem::absolute(*run);
    beads.beads_of_run = beads_of(*run, section);
  }
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
