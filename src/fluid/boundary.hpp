// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What bounds the liquid: a condition per patch of the mesh.

#include <array>
#include <optional>
#include <variant>

#include "core/vec3.hpp"
#include "fluid/flow_program.hpp"
#include "mesh/cross_section.hpp"

namespace packbed::fluid {

/// The liquid sticks to the wall. Nothing passes it.
struct Wall {
  Vec3 velocity{};  ///< of the wall along itself [m/s]
  /// Void fraction at the wall; without: that of the cell. The thesis has 1 (table B.3).
  std::optional<double> void_fraction{};
  bool operator==(const Wall&) const = default;
};

/// The liquid slides along the wall. Nothing passes it.
struct SlipWall {
  bool operator==(const SlipWall&) const = default;
};

/// Side of a direction that does not count: the slice of one cell in y.
struct Empty {
  bool operator==(const Empty&) const = default;
};

/// A known volume flux over the whole patch, with no velocity along it. Positive: into the column. It is
/// what passes the patch itself: a plunger that moves displaces liquid besides.
struct Inlet {
  FlowProgram superficial{};     ///< [m/s]
  double frit_resistance = 0.0;  ///< thickness over permeability of the frit before it [1/m]
  bool operator==(const Inlet&) const = default;
};

/// A known pressure behind the frit of the patch. What flows back in has no velocity along the patch.
struct Outlet {
  double pressure = 0.0;         ///< [Pa]
  double frit_resistance = 0.0;  ///< thickness over permeability [1/m]
  bool operator==(const Outlet&) const = default;
};

using BoundaryCondition = std::variant<SlipWall, Wall, Empty, Inlet, Outlet>;

/// One condition per patch; patches that the mesh lacks do not matter.
struct Boundaries {
  BoundaryCondition inlet = Inlet{};
  BoundaryCondition outlet = Outlet{};
  BoundaryCondition wall = Wall{};
  BoundaryCondition x_low = Wall{};
  BoundaryCondition x_high = Wall{};
  BoundaryCondition y_low = Empty{};
  BoundaryCondition y_high = Empty{};

  [[nodiscard]] const BoundaryCondition& at(mesh::Patch patch) const;
  bool operator==(const Boundaries&) const = default;
};

}  // namespace packbed::fluid
