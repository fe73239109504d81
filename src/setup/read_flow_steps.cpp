// SPDX-License-Identifier: BSD-3-Clause
// Steps with a flow: flow_ramp, hold, flow_pack, cycle, store.
#include <algorithm>
#include <optional>
#include <string_view>

#include "setup/read_steps.hpp"

namespace packbed::setup {
namespace {

/// What flows comes in at the top and leaves below.
void require_ends(const Section& section, const StepContext& context, const char* key) {
  if (!context.has_liquid) section.fail(key, "needs a [liquid] section");
  const auto* box = std::get_if<mesh::Box>(&context.column.shape);
  if (box == nullptr || box->boundaries[2] != mesh::Boundary::periodic) return;
  section.fail(key, "needs an inlet and an outlet; give column.boundaries.z = \"wall\"");
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

}  // namespace

FlowRamp read_flow_ramp(Section& section, const StepContext& context) {
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

Hold read_hold(Section& section, const StepContext& context) {
  section.mention({"duration", "flow"});
  if (section.has("flow")) require_ends(section, context, "flow");
  return {.duration = section.quantity("duration", Dimension::time, bounds::not_negative),
          .flow = section.optional_flow("flow", mesh::flow_cross_section(context.column.shape))};
}

FlowPack read_flow_pack(Section& section, const StepContext& context) {
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

Cycle read_cycle(Section& section, const StepContext& context) {
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

Store read_store(Section& section, const StepContext& context) {
  section.mention({"hold_limit"});
  if (!context.has_liquid) section.fail("step", "needs a [liquid] section");
  return {.hold_limit =
              section.quantity("hold_limit", Dimension::time, bounds::positive, Fallback{"5 s"})};
}

}  // namespace packbed::setup
