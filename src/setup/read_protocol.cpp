// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "setup/read_steps.hpp"

namespace packbed::setup {
namespace {

ProtocolStep read_step(Section section, StepContext& context);

Run read_run(Section& section) {
  return {.duration = section.quantity("duration", Dimension::time, bounds::not_negative)};
}

Repeat read_repeat(Section& section, StepContext& context) {
  Repeat repeat{.count = section.integer("count", 1), .steps = {}};
  const bool outer = std::exchange(context.in_repeat, true);
  for (auto& step : section.tables("steps")) repeat.steps.push_back(read_step(step, context));
  context.in_repeat = outer;
  if (repeat.steps.empty()) section.fail("step", "needs steps; write [[protocol.steps]] below it");
  return repeat;
}

ProtocolStep read_step(Section section, StepContext& context) {
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
  StepContext context{.column = column,
                      .has_liquid = has_liquid,
                      .beads_are_counted = beads.csv || beads.count || beads.run};
  std::vector<ProtocolStep> protocol;
  protocol.reserve(sections.size());
  for (auto& section : sections) protocol.push_back(read_step(std::move(section), context));
  return protocol;
}

}  // namespace packbed::setup
