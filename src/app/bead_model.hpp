// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "continuum/bead/loading.hpp"
#include "continuum/bead/plate_contact.hpp"
#include "core/quantity.hpp"

namespace packbed::app {

/// The bead that the options of `packbed bead` describe, as the user wrote them.
struct BeadOptions {
  std::string model;
  std::string radius, poisson;
  std::string g0, g1, eta;                                     // sls, poroelastic (g0)
  std::string c0;                                              // prony
  std::vector<std::string> terms;                              // prony: "C,tau"
  std::string youngs_modulus;                                  // hertz, hooke
  std::string density, characteristic_velocity;                // hooke
  std::string pore_radius, intraparticle_porosity, viscosity;  // poroelastic
};

/// A model under its name: force [N] at a time [s] of a loading.
struct BeadModel {
  continuum::BeadShape shape;
  std::function<double(const continuum::Loading&, double)> force;
  bool closing_only = false;                 ///< not known for opening plates
  std::string approximation = {};            ///< said with figures of a ramp
  std::optional<double> instantaneous = {};  ///< shear modulus G(0) [Pa]
  std::optional<double> relaxed = {};        ///< G(inf) [Pa]
};

/// Throws ConfigError for an unknown model, a missing option or one that the model does not have.
BeadModel make_bead_model(const BeadOptions& options, const UnitSystem& units);

}  // namespace packbed::app
