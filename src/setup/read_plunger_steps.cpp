// SPDX-License-Identifier: BSD-3-Clause
// Steps that move the plunger: compress, relax.
#include <array>
#include <string_view>

#include "setup/read_steps.hpp"

namespace packbed::setup {
namespace {

constexpr std::array<std::string_view, 7> goal_names = {
    "height", "compression", "further_compression", "compression_factor", "packing_factor",
    "force",  "pressure"};

/// The goal that a step has; none if it names none.
bool read_goal(Section& section, const StepContext& context, bool may_be_zero, PlungerMove& move) {
  constexpr Bounds above_1{.low = 1.0, .refusal = "must be above 1"};
  const auto load = may_be_zero ? bounds::not_negative : bounds::positive;
  const struct {
    Dimension dimension;
    Bounds bounds;
  } accepted[] = {{Dimension::length, bounds::positive},
                  {Dimension::fraction, bounds::between_0_and_1},
                  {Dimension::fraction, bounds::between_0_and_1},
                  {Dimension::fraction, above_1},
                  {Dimension::fraction, above_1},
                  {Dimension::force, load},
                  {Dimension::pressure, load}};
  int found = 0;
  for (std::size_t i = 0; i < goal_names.size(); ++i) {
    const auto value =
        section.optional_quantity(goal_names[i], accepted[i].dimension, accepted[i].bounds);
    if (!value) continue;
    if (++found > 1) section.fail(goal_names[i], "is one target too many; give one");
    move.goal = static_cast<PlungerGoal>(i);
    move.value = *value;
  }
  if (found > 0 && move.goal == PlungerGoal::height &&
      move.value > mesh::height(context.column.shape)) {
    section.fail("height", "is above the height of the column");
  }
  return found > 0;
}

void read_rest_of_move(Section& section, const StepContext& context, PlungerMove& move) {
  move.hold = section.quantity("hold", Dimension::time, bounds::not_negative, Fallback{"0 s"});
  move.friction = section.optional_quantity("friction", Dimension::fraction, bounds::not_negative);
  move.drained = section.boolean("drained", false);
  if (move.drained && !context.has_liquid) {
    section.fail("drained", "has no meaning in a dry column; leave it out");
  }
  if (context.has_liquid && !move.drained) {
    move.flow =
        section.flow("flow", mesh::flow_cross_section(context.column.shape), Fallback{"0 cm/h"});
  } else {
    section.refuse("flow",
                   move.drained ? "does not go with drained = true" : "needs a [liquid] section");
  }
}

}  // namespace

void require_plunger(const Section& section, const StepContext& context) {
  const auto* box = std::get_if<mesh::Box>(&context.column.shape);
  if (box == nullptr || box->boundaries[2] == mesh::Boundary::wall) return;
  section.fail("step", "needs a plunger; give column.boundaries.z = \"wall\"");
}

Compress read_compress(Section& section, const StepContext& context) {
  PlungerMove move{};
  section.mention({"speed", "height", "compression", "further_compression", "compression_factor",
                   "packing_factor", "force", "pressure", "hold", "flow", "friction", "drained"});
  require_plunger(section, context);
  move.speed = section.quantity("speed", Dimension::velocity, bounds::positive);
  if (!read_goal(section, context, false, move)) {
    section.fail("step",
                 "needs a target: height, compression, further_compression, compression_factor, "
                 "packing_factor, force or pressure");
  }
  read_rest_of_move(section, context, move);
  return {.move = move};
}

Relax read_relax(Section& section, const StepContext& context) {
  PlungerMove move{.speed = 0.0, .goal = PlungerGoal::force, .value = 0.0};
  section.mention({"speed", "height", "compression", "further_compression", "compression_factor",
                   "packing_factor", "force", "pressure", "hold", "flow", "friction", "drained",
                   "withdraw"});
  require_plunger(section, context);
  move.speed = section.quantity("speed", Dimension::velocity, bounds::positive);
  read_goal(section, context, true, move);
  read_rest_of_move(section, context, move);
  return {.move = move, .withdraw = section.boolean("withdraw", false)};
}

}  // namespace packbed::setup
