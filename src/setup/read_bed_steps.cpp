// SPDX-License-Identifier: BSD-3-Clause
// Steps that make a bed: settle, tap.
#include <string>
#include <string_view>

#include "setup/read_steps.hpp"

namespace packbed::setup {
namespace {

/// Beads that sink need something to sink to, and sides that hold them.
void require_floor(const Section& section, const mesh::ColumnShape& shape) {
  const auto* box = std::get_if<mesh::Box>(&shape);
  if (box == nullptr) return;
  if (box->boundaries[2] != mesh::Boundary::wall) {
    section.fail("step", "needs a floor; give column.boundaries.z = \"wall\"");
  }
  if (box->boundaries[0] == mesh::Boundary::open || box->boundaries[1] == mesh::Boundary::open) {
    section.fail("step",
                 "needs sides that hold the beads; column.boundaries x and y must be "
                 "\"wall\" or \"periodic\"");
  }
}

// rpm and the like count radians, and would come out 6.28 times too fast.
void refuse_angles(const Section& section, std::string_view key) {
  const auto unit = split_quantity(section.last_text()).unit;
  for (const auto* word : {"rpm", "rps", "rad", "rev", "cycle", "turn", "deg"}) {
    if (unit.find(word) == std::string::npos) continue;
    section.fail(key, "is the speed of a rotation; give the frequency in Hz or min-1");
  }
}

}  // namespace

Settle read_settle(Section& section, StepContext& context) {
  Settle settle;
  require_floor(section, context.column.shape);
  section.mention({"bed_height", "friction", "porosity"});
  if (context.beads_are_counted && section.has("bed_height")) {
    section.fail("bed_height",
                 "is one too many: [beads] or an earlier settle step already says "
                 "how many beads there are");
  }
  if (context.in_repeat && section.has("bed_height")) {
    section.fail("bed_height", "does not go into a repeat: beads are made once; settle before it");
  }
  if (!context.beads_are_counted && !section.has("bed_height")) {
    section.fail_missing("bed_height",
                         "is missing; give it, or [beads] csv or count, so that the "
                         "number of beads is known");
  }
  context.beads_are_counted = true;
  settle.bed_height = section.optional_quantity("bed_height", Dimension::length, bounds::positive);
  if (settle.bed_height && *settle.bed_height > mesh::height(context.column.shape)) {
    section.fail("bed_height", "is above the height of the column");
  }
  settle.friction =
      section.optional_quantity("friction", Dimension::fraction, bounds::not_negative);
  settle.porosity =
      section.optional_quantity("porosity", Dimension::fraction, bounds::between_0_and_1);
  if (settle.friction && settle.porosity) {
    section.fail("porosity", "does not go with friction; the friction follows from the porosity");
  }
  return settle;
}

Tap read_tap(Section& section, const StepContext& context) {
  Tap tap{};
  section.mention({"amplitude", "frequency", "count"});
  require_floor(section, context.column.shape);
  tap.amplitude = section.quantity("amplitude", Dimension::length, bounds::positive);
  tap.frequency = section.quantity("frequency", Dimension::frequency, bounds::positive);
  refuse_angles(section, "frequency");
  tap.count = section.integer("count", 1, Fallback{"1"});
  return tap;
}

}  // namespace packbed::setup
