// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/print.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/quantity.hpp"
#include "io/mesh_svg.hpp"
#include "setup/case_report.hpp"
#include "setup/read_case.hpp"

namespace packbed::app {
namespace {

void draw_mesh(const setup::Case& c,
               const setup::CaseFigures& f,
               const std::filesystem::path& file) {
  if (!f.mesh) {
    throw ConfigError(
        fmt::format("{}: --mesh-svg: there is no mesh without a [liquid]; leave the "
                    "option out, or give a liquid",
                    c.file.string()));
  }
  const auto& shape = c.column.shape;
  write_text_file(file, io::mesh_svg({shape, f.mesh->counts}, shape));
}

}  // namespace

int check(const CheckCommand& command) {
  const UnitSystem units;
  const auto c = setup::read_case(command.file, units);
  const auto f = setup::figures(c);
  if (!command.mesh_svg.empty()) draw_mesh(c, f, command.mesh_svg);
  if (command.json) {
    fmt::print("{}", json_text(setup::check_json(c, f)));
  } else {
    fmt::print("{}", setup::check_text(c, f));
  }
  return 0;
}

}  // namespace packbed::app
