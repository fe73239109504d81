// SPDX-License-Identifier: BSD-3-Clause
#include "app/bead_model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "app/quantities.hpp"
#include "continuum/bead/hertz.hpp"
#include "continuum/bead/hooke.hpp"
#include "continuum/bead/poroelastic_ramp.hpp"
#include "continuum/bead/swollen_bead.hpp"
#include "continuum/bead/viscoelastic.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace packbed::app {
namespace {

using continuum::Loading;
using enum Dimension;
namespace bounds = setup::bounds;

const std::vector<std::string> model_names = {"hertz",      "hooke", "sls-maxwell",
                                              "sls-kelvin", "prony", "poroelastic"};

constexpr setup::Bounds below_half{
    .low = -1.0,
    .high = 0.5,
    .refusal = "is outside (-1, 0.5), which the diffusion of liquid needs"};

// Options that only some models have.
std::vector<std::pair<Option, std::string>> special(const BeadOptions& o) {
  const std::string sls = "sls-maxwell sls-kelvin";
  return {{{"--G0", o.g0}, sls + " poroelastic"},
          {{"--G1", o.g1}, sls},
          {{"--eta", o.eta}, sls},
          {{"--C0", o.c0}, "prony"},
          {{"--E", o.youngs_modulus}, "hertz hooke"},
          {{"--density", o.density}, "hooke"},
          {{"--characteristic-velocity", o.characteristic_velocity}, "hooke"},
          {{"--pore-radius", o.pore_radius}, "poroelastic"},
          {{"--intraparticle-porosity", o.intraparticle_porosity}, "poroelastic"},
          {{"--viscosity", o.viscosity}, "poroelastic"}};
}

void check_options(const BeadOptions& o) {
  if (std::ranges::find(model_names, o.model) == model_names.end()) {
    throw ConfigError(o.model.empty()
                          ? fmt::format("--model is missing; known are {}", either_of(model_names))
                          : fmt::format("--model \"{}\" is not known; known are {}", o.model,
                                        either_of(model_names)));
  }
  for (const auto& [option, models] : special(o)) {
    if (!option.text.empty() && models.find(o.model) == std::string::npos) {
      throw ConfigError(
          fmt::format("{} does not apply to --model {}; leave it out", option.name, o.model));
    }
  }
  if (!o.terms.empty() && o.model != "prony") {
    throw ConfigError(fmt::format("--term does not apply to --model {}; leave it out", o.model));
  }
}

BeadModel viscoelastic(const continuum::BeadShape& shape, const continuum::ShearRelaxation& g) {
  const continuum::ViscoelasticBead bead{shape, g};
  return {.shape = shape,
          .force = [bead](const Loading& loading, double t) { return bead.force(loading, t); },
          .instantaneous = g.instantaneous(),
          .relaxed = g.relaxed};
}

continuum::ShearRelaxation read_prony(const BeadOptions& o, const UnitSystem& units) {
  double c0 = quantity_or(units, {"--C0", o.c0}, pressure, bounds::not_negative, 0.0);
  std::vector<continuum::RelaxationTerm> terms;
  for (const auto& text : o.terms) {
    const auto comma = text.find(',');
    if (comma == std::string::npos) {
      throw ConfigError(
          fmt::format("--term = \"{}\" is refused: it has no comma; give modulus and "
                      "time such as \"0.4 MPa,12 s\"",
                      text));
    }
    const auto c = text.substr(0, comma);
    const auto tau = text.substr(comma + 1);
    if (trimmed(tau) == "inf") {  // never relaxes
      c0 += quantity(units, {"--term", c}, pressure, bounds::not_negative);
      continue;
    }
    terms.push_back({quantity(units, {"--term", c}, pressure, bounds::not_negative),
                     quantity(units, {"--term", tau}, time, bounds::positive)});
  }
  if (o.terms.empty()) {
    throw ConfigError("--term is missing; give modulus and time such as \"0.4 MPa,12 s\"");
  }
  return continuum::prony(c0, terms);
}

BeadModel poroelastic(const BeadOptions& o, const UnitSystem& units, continuum::BeadShape shape) {
  shape.poisson = quantity(units, {"--poisson", o.poisson}, fraction, below_half);
  const double g = quantity(units, {"--G0", o.g0}, pressure, bounds::positive);
  const double k = continuum::pore_permeability(
      quantity(units, {"--intraparticle-porosity", o.intraparticle_porosity}, fraction,
               bounds::between_0_and_1),
      quantity(units, {"--pore-radius", o.pore_radius}, length, bounds::positive));
  const double mu =
      quantity_or(units, {"--viscosity", o.viscosity}, viscosity, bounds::positive, 1e-3);
  const continuum::PoroelasticBead bead{
      shape, g, continuum::poroelastic_diffusivity(shape.poisson, g, k, mu)};
  return {
      .shape = shape,
      .force = [bead](const Loading& l,
                      double t) { return continuum::poroelastic_force(bead, l, t); },
      .closing_only = true,
      .approximation =
          "the ramp is an approximation: steps of the present contact radius, superposed; a step "
          "(relax without --speed) and very fast and slow ramps are exact",
      .instantaneous = {},
      .relaxed = g};
}

}  // namespace

BeadModel make_bead_model(const BeadOptions& o, const UnitSystem& units) {
  check_options(o);
  const continuum::BeadShape shape{
      quantity(units, {"--radius", o.radius}, length, bounds::positive),
      quantity(units, {"--poisson", o.poisson}, fraction, bounds::poisson_ratio)};
  const auto modulus = [&](std::string_view name, const std::string& text) {
    return quantity(units, {name, text}, pressure, bounds::positive);
  };
  if (o.model == "hertz") {
    const double e = modulus("--E", o.youngs_modulus);
    return viscoelastic(shape,
                        {.relaxed = continuum::shear_modulus(e, shape.poisson), .terms = {}});
  }
  if (o.model == "hooke") {
    const continuum::HookeBead bead{
        shape, modulus("--E", o.youngs_modulus),
        quantity(units, {"--density", o.density}, density, bounds::positive),
        quantity(units, {"--characteristic-velocity", o.characteristic_velocity}, velocity,
                 bounds::positive)};
    return {.shape = shape,
            .force = [bead](const Loading& l, double t) { return bead.force(l.approach(t)); }};
  }
  if (o.model == "prony") return viscoelastic(shape, read_prony(o, units));
  if (o.model == "poroelastic") return poroelastic(o, units, shape);
  const double g0 = modulus("--G0", o.g0);
  const double g1 = modulus("--G1", o.g1);
  const double eta = quantity(units, {"--eta", o.eta}, viscosity, bounds::positive);
  return viscoelastic(shape, o.model == "sls-maxwell" ? continuum::sls_maxwell(g0, g1, eta)
                                                      : continuum::sls_kelvin(g0, g1, eta));
}

}  // namespace packbed::app
