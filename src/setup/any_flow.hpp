// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "setup/case.hpp"

namespace packbed::setup {

/// Whether a step, or one inside a repeat, sets a flow of liquid.
inline bool any_flow(const std::vector<ProtocolStep>& protocol) {
  return std::ranges::any_of(protocol, [](const ProtocolStep& step) {
    const auto* hold = std::get_if<Hold>(&step.what);
    const auto* repeat = std::get_if<Repeat>(&step.what);
    return std::holds_alternative<FlowRamp>(step.what) || (hold != nullptr && hold->flow) ||
           (repeat != nullptr && any_flow(repeat->steps));
  });
}

}  // namespace packbed::setup
