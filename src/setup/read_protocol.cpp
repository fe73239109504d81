// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <utility>

#include "setup/read_sections.hpp"

namespace packbed::setup {
namespace {

/// What the steps read so far leave to the next one.
struct Context {
  const ColumnOptions& column;
  bool has_liquid = false;
  bool beads_are_counted = false;  ///< by [beads] or an earlier settling
  bool in_repeat = false;
};

ProtocolStep read_step(Section section, Context& context);

Run read_run(Section& section) {
  return {.duration = section.quantity("duration", Dimension::time, bounds::not_negative)};
}

/// What flows comes in at the top and leaves below.
void require_ends(const Section& section, const Context& context, const char* key) {
  if (!context.has_liquid) section.fail(key, "needs a [liquid] section");
  const auto* box = std::get_if<mesh::Box>(&context.column.shape);
  if (box == nullptr || box->boundaries[2] != mesh::Boundary::periodic) return;
  section.fail(key, "needs an inlet and an outlet; give column.boundaries.z = \"wall\"");
}

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

Settle read_settle(Section& section, Context& context) {
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

// rpm and the like count radians, and would come out 6.28 times too fast.
void refuse_angles(const Section& section, std::string_view key) {
  const auto unit = split_quantity(section.last_text()).unit;
  for (const auto* word : {"rpm", "rps", "rad", "rev", "cycle", "turn", "deg"}) {
    if (unit.find(word) == std::string::npos) continue;
    section.fail(key, "is the speed of a rotation; give the frequency in Hz or min-1");
  }
}

Tap read_tap(Section& section, Context& context) {
  Tap tap{};
  section.mention({"amplitude", "frequency", "count"});
  require_floor(section, context.column.shape);
  tap.amplitude = section.quantity("amplitude", Dimension::length, bounds::positive);
  tap.frequency = section.quantity("frequency", Dimension::frequency, bounds::positive);
  refuse_angles(section, "frequency");
  tap.count = section.integer("count", 1, Fallback{"1"});
  return tap;
}

/// How long a flow stays: a time, or until the bed is steady.
struct Holds {
  std::optional<double> first;
  std::optional<double> second;
  double limit = 0.0;
};

Holds read_holds(Section& section, std::string_view first, std::string_view second) {
  const auto read = [&](std::string_view key) {
    return section.quantity_or_word(key, Dimension::time, bounds::positive, "until steady",
                                    Fallback{"until steady"});
  };
  Holds holds;
  holds.first = read(first);
  holds.second = second.empty() ? holds.first : read(second);
  if (holds.first && holds.second) {
    section.refuse("hold_limit", second.empty()
                                     ? "applies only to hold = \"until steady\""
                                     : "applies only to a flow that is held \"until steady\"");
    holds.limit = std::max(*holds.first, *holds.second);
  } else {
    holds.limit =
        section.quantity("hold_limit", Dimension::time, bounds::positive, Fallback{"5 s"});
  }
  return holds;
}

FlowRamp read_flow_ramp(Section& section, Context& context) {
  FlowRamp ramp{};
  section.mention({"from", "to", "steps", "hold", "hold_limit", "change"});
  require_ends(section, context, "step");
  const double area = mesh::flow_cross_section(context.column.shape);
  ramp.from = section.flow("from", area, Fallback{"0 cm/h"});
  ramp.to = section.flow("to", area);
  ramp.steps = section.integer("steps", 1, Fallback{"1"});
  const auto holds = read_holds(section, "hold", "");
  ramp.hold = holds.first;
  ramp.hold_limit = holds.limit;
  ramp.change =
      static_cast<FlowChange>(section.choice("change", {"jump", "ramp"}, Fallback{"ramp"}));
  return ramp;
}

Hold read_hold(Section& section, Context& context) {
  section.mention({"duration", "flow"});
  if (section.has("flow")) require_ends(section, context, "flow");
  return {.duration = section.quantity("duration", Dimension::time, bounds::not_negative),
          .flow = section.optional_flow("flow", mesh::flow_cross_section(context.column.shape))};
}

constexpr std::array<std::string_view, 7> goal_names = {
    "height", "compression", "further_compression", "compression_factor", "packing_factor",
    "force",  "pressure"};

/// The goal that a step has; none if it names none.
bool read_goal(Section& section, const Context& context, bool may_be_zero, PlungerMove& move) {
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

void require_plunger(const Section& section, const Context& context) {
  const auto* box = std::get_if<mesh::Box>(&context.column.shape);
  if (box == nullptr || box->boundaries[2] == mesh::Boundary::wall) return;
  section.fail("step", "needs a plunger; give column.boundaries.z = \"wall\"");
}

void read_rest_of_move(Section& section, const Context& context, PlungerMove& move) {
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

Compress read_compress(Section& section, Context& context) {
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

Relax read_relax(Section& section, Context& context) {
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

FlowPack read_flow_pack(Section& section, Context& context) {
  FlowPack pack{};
  section.mention({"flow", "steps", "hold", "hold_limit", "compression", "further_compression",
                   "plunger_speed"});
  require_ends(section, context, "step");
  require_plunger(section, context);
  pack.flow = section.flow("flow", mesh::flow_cross_section(context.column.shape));
  if (pack.flow <= 0.0) section.fail("flow", "must be positive: it presses the bed down");
  pack.steps = section.integer("steps", 1, Fallback{"10"});
  const auto holds = read_holds(section, "hold", "");
  pack.hold = holds.first;
  pack.hold_limit = holds.limit;
  pack.compression =
      section.optional_quantity("compression", Dimension::fraction, bounds::between_0_and_1);
  pack.further_compression = section.optional_quantity("further_compression", Dimension::fraction,
                                                       bounds::between_0_and_1);
  if (pack.compression && pack.further_compression) {
    section.fail("further_compression", "is one target too many; give one");
  }
  pack.plunger_speed = section.quantity("plunger_speed", Dimension::velocity, bounds::positive,
                                        Fallback{"30 mm/min", "default: thesis section 5.4.5"});
  return pack;
}

Cycle read_cycle(Section& section, Context& context) {
  Cycle cycle{};
  section.mention({"high", "low", "count", "high_duration", "low_duration", "hold_limit"});
  require_ends(section, context, "step");
  const double area = mesh::flow_cross_section(context.column.shape);
  const auto origin = "default: thesis section 5.4.5";
  cycle.high = section.flow("high", area, Fallback{"0.75 RHL", origin});
  cycle.low = section.flow("low", area, Fallback{"0.05 RHL", origin});
  cycle.count = section.integer("count", 1);
  const auto holds = read_holds(section, "high_duration", "low_duration");
  cycle.high_duration = holds.first;
  cycle.low_duration = holds.second;
  cycle.hold_limit = holds.limit;
  return cycle;
}

Store read_store(Section& section, Context& context) {
  section.mention({"hold_limit"});
  if (!context.has_liquid) section.fail("step", "needs a [liquid] section");
  return {.hold_limit =
              section.quantity("hold_limit", Dimension::time, bounds::positive, Fallback{"5 s"})};
}

Repeat read_repeat(Section& section, Context& context) {
  Repeat repeat{.count = section.integer("count", 1), .steps = {}};
  const bool outer = std::exchange(context.in_repeat, true);
  for (auto& step : section.tables("steps")) repeat.steps.push_back(read_step(step, context));
  context.in_repeat = outer;
  if (repeat.steps.empty()) section.fail("step", "needs steps; write [[protocol.steps]] below it");
  return repeat;
}

ProtocolStep read_step(Section section, Context& context) {
  const auto kind = section.choice("step", {"run", "settle", "tap", "flow_ramp", "hold", "compress",
                                            "relax", "flow_pack", "cycle", "store", "repeat"});
  ProtocolStep step{Run{}};
  switch (kind) {
    case 0:
      step.what = read_run(section);
      break;
    case 1:
      step.what = read_settle(section, context);
      break;
    case 2:
      step.what = read_tap(section, context);
      break;
    case 3:
      step.what = read_flow_ramp(section, context);
      break;
    case 4:
      step.what = read_hold(section, context);
      break;
    case 5:
      step.what = read_compress(section, context);
      break;
    case 6:
      step.what = read_relax(section, context);
      break;
    case 7:
      step.what = read_flow_pack(section, context);
      break;
    case 8:
      step.what = read_cycle(section, context);
      break;
    case 9:
      step.what = read_store(section, context);
      break;
    default:
      step.what = read_repeat(section, context);
      break;
  }
  section.finish();
  return step;
}

}  // namespace

bool needs_gravity(const std::vector<ProtocolStep>& protocol) {
  return std::ranges::any_of(protocol, [](const ProtocolStep& step) {
    const auto* repeat = std::get_if<Repeat>(&step.what);
    return std::holds_alternative<Settle>(step.what) || std::holds_alternative<Tap>(step.what) ||
           (repeat != nullptr && needs_gravity(repeat->steps));
  });
}

std::vector<ProtocolStep> read_protocol(std::vector<Section> sections,
                                        const ColumnOptions& column,
                                        const BeadOptions& beads,
                                        bool has_liquid) {
  Context context{.column = column,
                  .has_liquid = has_liquid,
                  .beads_are_counted = beads.csv || beads.count || beads.run};
  std::vector<ProtocolStep> protocol;
  protocol.reserve(sections.size());
  for (auto& section : sections) protocol.push_back(read_step(std::move(section), context));
  return protocol;
}

}  // namespace packbed::setup
