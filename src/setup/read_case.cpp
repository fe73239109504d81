// SPDX-License-Identifier: BSD-3-Clause
#include "setup/read_case.hpp"

#include <utility>

#include "core/file.hpp"
#include "setup/parse_toml.hpp"
#include "setup/read_sections.hpp"
#include "setup/resin_file.hpp"

namespace packbed::setup {
namespace {

Case read_tables(const toml::table& table, Reading& reading) {
  Case c;
  Section top(reading, table, "", "");
  for (const auto* key : {"title", "column", "resin", "liquid", "drag", "coupling", "beads",
                          "protocol", "numerics", "output"}) {
    top.mention(key);
  }
  top.finish();  // before anything else: a misspelt section would look like a missing one
  c.title = top.word("title", Fallback{reading.file.stem().string()});
  if (!top.has("column")) {
    top.fail_missing("[column]", "is missing; a case has at least [column] and [resin]");
  }
  c.column = read_column(top.table("column"), top.has("liquid"));
  c.beads = read_beads(top.table("beads"), c.column);
  c.resin = read_resin(top.table("resin"), reading.units, builtin_library(reading.units), c.beads,
                       c.column, top.has("liquid"));
  if (top.has("liquid")) c.liquid = read_liquid(top.table("liquid"));
  for (const auto* key : {"drag", "coupling"}) {
    if (top.has(key) && !top.has("liquid")) top.fail(key, "needs a [liquid] section");
  }
  if (top.has("liquid")) c.drag = read_drag(top.table("drag"));
  reading.full_load = full_load(c.column, table, reading);
  c.protocol = read_protocol(top.tables("protocol"), c.column, c.beads, c.liquid.has_value());
  if (top.has("liquid")) c.coupling = read_coupling(top.table("coupling"), c);
  c.numerics = read_numerics(top.table("numerics"), c.protocol);
  c.output = read_output(top.table("output"), reading.file, reading.units);
  return c;
}

}  // namespace

Case read_case_text(std::string_view text,
                    const std::filesystem::path& file,
                    const UnitSystem& units) {
  const auto table = parse_toml(text, file);
  Reading reading{units, file, {}};
  auto c = read_tables(table, reading);
  c.file = file;
  c.echo = std::move(reading.echo);
  return c;
}

Case read_case(const std::filesystem::path& file, const UnitSystem& units) {
  return read_case_text(read_text_file(file), file, units);
}

mesh::ColumnShape read_column_shape(std::string_view text,
                                    const std::filesystem::path& file,
                                    const UnitSystem& units) {
  const auto table = parse_toml(text, file);
  Reading reading{units, file, {}};
  Section top(reading, table, "", "");
  return read_column(top.table("column"), top.has("liquid")).shape;
}

}  // namespace packbed::setup
