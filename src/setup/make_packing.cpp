// SPDX-License-Identifier: BSD-3-Clause
#include "setup/make_packing.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "setup/make_dem.hpp"
#include "setup/make_liquid.hpp"

namespace packbed::setup {
namespace {

/// Height of the bed at a compression (H0 - H) / H0 [m].
double height_at(const Case& c, double compression, const PackedBed& bed) {
  if (bed.settled_height > 0.0) return (1.0 - compression) * bed.settled_height;
  throw ConfigError(
      fmt::format("{}: a compression is against the height of the settled bed, and no bed has "
                  "settled yet; let a "
                  "step \"settle\" come first, or give height",
                  c.file.string()));
}

double goal_height(const Case& c, const PlungerMove& move, const PackedBed& bed) {
  switch (move.goal) {
    case PlungerGoal::compression:
      return height_at(c, move.value, bed);
    case PlungerGoal::compression_factor:
      return height_at(c, 1.0 - 1.0 / move.value, bed);
    case PlungerGoal::packing_factor:
      return bed.height / move.value;
    default:
      return move.value;
  }
}

column::FlowOptions flow_to(const Case& c,
                            std::string name,
                            double velocity,
                            std::optional<double> hold,
                            double limit,
                            const dem::StepChoice& step) {
  auto o = with<column::FlowOptions>(drive_options(c, step));
  o.name = std::move(name);
  o.from = std::nullopt;
  o.to = velocity;
  o.hold = hold;
  o.hold_limit = limit;
  return o;
}

}  // namespace

column::PlungerOptions plunger_options(const Case& c,
                                       const PlungerMove& move,
                                       bool goes_up,
                                       const PackedBed& bed,
                                       const dem::StepChoice& step) {
  auto o = with<column::PlungerOptions>(drive_options(c, step));
  o.name = goes_up ? "relax" : "compress";
  o.speed = goes_up ? -move.speed : move.speed;
  const bool by_force = move.goal == PlungerGoal::force || move.goal == PlungerGoal::pressure;
  o.target = by_force ? column::PlungerTarget::force : column::PlungerTarget::height;
  o.value = move.goal == PlungerGoal::pressure ? move.value * o.area
            : by_force                         ? move.value
                                               : goal_height(c, move, bed);
  o.hold = move.hold;
  o.column_height = mesh::height(c.column.shape);
  o.flow = move.flow;
  o.friction = move.friction;
  o.resin_friction = c.resin.friction;
  o.drained = move.drained;
  o.gravity = c.numerics.gravity ? gravity : 0.0;
  o.liquid_density = c.liquid ? c.liquid->density : 0.0;
  o.settled_height = bed.settled_height;
  return o;
}

column::FlowOptions packing_flow(const Case& c,
                                 const FlowPack& pack,
                                 const PackedBed& bed,
                                 const dem::StepChoice& step) {
  auto o = flow_to(c, "flow_pack", pack.flow, pack.hold, pack.hold_limit, step);
  o.steps = pack.steps;
  if (pack.compression) o.until_height = height_at(c, *pack.compression, bed);
  return o;
}

// Without a compression the plunger stops where it touches the bed.
column::PlungerOptions packing_plunger(const Case& c,
                                       const FlowPack& pack,
                                       const PackedBed& bed,
                                       const dem::StepChoice& step) {
  PlungerMove move{.speed = pack.plunger_speed, .goal = PlungerGoal::height, .value = 0.0};
  if (pack.compression) move.value = height_at(c, *pack.compression, bed);
  auto o = plunger_options(c, move, false, bed, step);
  o.name = "flow_pack";
  o.flow = std::nullopt;
  o.touches_only = !pack.compression;
  return o;
}

column::FlowOptions packing_end(const Case& c, const FlowPack& pack, const dem::StepChoice& step) {
  return flow_to(c, "flow_pack", 0.0, pack.hold, pack.hold_limit, step);
}

column::FlowOptions cycle_options(const Case& c,
                                  const Cycle& cycle,
                                  bool high,
                                  const dem::StepChoice& step) {
  const auto& hold = high ? cycle.high_duration : cycle.low_duration;
  return flow_to(c, high ? "cycle high" : "cycle low", high ? cycle.high : cycle.low, hold,
                 hold.value_or(cycle.hold_limit), step);
}

column::FlowOptions store_options(const Case& c, const Store& store, const dem::StepChoice& step) {
  return flow_to(c, "store", 0.0, std::nullopt, store.hold_limit, step);
}

}  // namespace packbed::setup
