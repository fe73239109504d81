// SPDX-License-Identifier: BSD-3-Clause
#include "fluid/border.hpp"

#include <variant>

namespace packbed::fluid {
namespace {

BorderKind kind_of(const BoundaryCondition& condition) {
  if (std::holds_alternative<Wall>(condition)) return BorderKind::wall;
  if (std::holds_alternative<Inlet>(condition)) return BorderKind::inlet;
  if (std::holds_alternative<Outlet>(condition)) return BorderKind::outlet;
  return BorderKind::slip;
}

double frit_resistance_of(const BoundaryCondition& condition) {
  if (const auto* inlet = std::get_if<Inlet>(&condition)) return inlet->frit_resistance;
  if (const auto* outlet = std::get_if<Outlet>(&condition)) return outlet->frit_resistance;
  return 0.0;
}

}  // namespace

Border border(const Boundaries& boundaries, const Domain& domain) {
  Border all;
  double outlets = 0.0;
  for (const auto& faces : domain.part.patches) {
    const auto& condition = boundaries.at(faces.patch);
    const auto* wall = std::get_if<Wall>(&condition);
    const auto kind = kind_of(condition);
    if (kind == BorderKind::outlet) outlets = 1.0;
    for (auto f = faces.first; f < faces.first + faces.count; ++f) {
      const auto& n = domain.geometry.normal[static_cast<std::size_t>(f)];
      const Vec3 velocity = wall != nullptr ? wall->velocity : Vec3{};
      all.kind.push_back(kind);
      all.patch.push_back(faces.patch);
      all.frit_resistance.push_back(frit_resistance_of(condition));
      all.wall_velocity.push_back(velocity - dot(velocity, n) * n);
      all.wall_eps.push_back(wall != nullptr ? wall->void_fraction.value_or(0.0) : 0.0);
    }
  }
  all.inward.resize(all.size(), 0.0);
  all.pressure.resize(all.size(), 0.0);
  all.has_outlet = domain.ranks.max(outlets) > 0.0;
  return all;
}

void update(Border& border,
            const Boundaries& boundaries,
            const Domain& domain,
            double time,
            const Vec3& rho_g) {
  for (std::size_t b = 0; b < border.size(); ++b) {
    const auto& condition = boundaries.at(border.patch[b]);
    if (const auto* inlet = std::get_if<Inlet>(&condition)) {
      border.inward[b] = inlet->superficial.at(time);
    }
    if (const auto* outlet = std::get_if<Outlet>(&condition)) {
      border.pressure[b] =
          outlet->pressure - dot(rho_g, domain.part.face_center[domain.inner() + b]);
    }
  }
}

}  // namespace packbed::fluid
