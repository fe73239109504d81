// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "setup/case.hpp"

namespace packbed::setup {

/// Whether a step makes liquid flow; `has_liquid`: there is one in the column.
inline bool makes_flow(const ProtocolStep& step, bool has_liquid) {
  const auto& what = step.what;
  if (const auto* compress = std::get_if<Compress>(&what))
    return has_liquid && !compress->move.drained;
  if (const auto* relax = std::get_if<Relax>(&what)) return has_liquid && !relax->move.drained;
  const auto* hold = std::get_if<Hold>(&what);
  return std::holds_alternative<FlowRamp>(what) || std::holds_alternative<FlowPack>(what) ||
         std::holds_alternative<Cycle>(what) || std::holds_alternative<Store>(what) ||
         (hold != nullptr && hold->flow);
}

/// Whether a step, or one inside a repeat, does.
inline bool any_flow(const std::vector<ProtocolStep>& protocol, bool has_liquid) {
  return std::ranges::any_of(protocol, [&](const ProtocolStep& step) {
    const auto* repeat = std::get_if<Repeat>(&step.what);
    return makes_flow(step, has_liquid) ||
           (repeat != nullptr && any_flow(repeat->steps, has_liquid));
  });
}

}  // namespace packbed::setup
