// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "core/quantity.hpp"
#include "setup/case_report.hpp"
#include "setup/read_case.hpp"

namespace packbed::app {

int check(const CheckCommand& command) {
  const UnitSystem units;
  const auto c = setup::read_case(command.file, units);
  const auto f = setup::figures(c);
  if (command.json) {
    fmt::print("{}", json_text(setup::check_json(c, f)));
  } else {
    fmt::print("{}", setup::check_text(c, f));
  }
  return 0;
}

}  // namespace packbed::app
