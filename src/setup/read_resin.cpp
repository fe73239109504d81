// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "resin/size_statistics.hpp"
#include "setup/read_sections.hpp"
#include "setup/read_sizes.hpp"
#include "setup/resin_file.hpp"

namespace packbed::setup {
namespace {

const resin::Resin& find_resin(const Section& section,
                               const resin::Library& library,
                               const std::string& name) {
  const auto* resin = library.find(name);
  if (resin != nullptr) return *resin;
  const auto near = nearest(name, library.names());
  section.fail("name", fmt::format("is not in the library{}; `packbed resins` lists it. For beads "
                                   "of your own leave name out, or name a library of yours",
                                   near ? fmt::format(", did you mean \"{}\"?", *near) : ""));
}

/// The modulus that a contact law is calibrated with.
std::string_view modulus_key(ContactLawName law) {
  return law == ContactLawName::hooke ? "youngs_modulus_linear" : "youngs_modulus_relaxed";
}

/// Reads the keys of one resin, with what the library knows of it as defaults.
class ResinReader {
 public:
  ResinReader(Section& section, const resin::Resin* resin) : section_(section), resin_(resin) {}

  /// From the case, else the library, else `otherwise`; refused if there is none of them.
  double needed(std::string_view key,
                Dimension dimension,
                const Bounds& bounds,
                std::string_view library_key,
                const std::optional<Fallback>& otherwise = {}) {
    const auto fallback = default_of(library_key, otherwise);
    if (!section_.has(key) && !fallback && resin_ != nullptr) {
      section_.fail_missing(key, missing_in_library(library_key, dimension));
    }
    return section_.quantity(key, dimension, bounds, fallback);
  }

  /// The same, but absent if there is none and the beads of a file each have their own.
  std::optional<double> unless_per_bead(std::string_view key,
                                        Dimension dimension,
                                        const Bounds& bounds,
                                        std::string_view library_key,
                                        bool each_bead_has_it) {
    const bool known = section_.has(key) || default_of(library_key, {});
    if (!known && each_bead_has_it) {
      section_.mention(key);
      return std::nullopt;
    }
    return needed(key, dimension, bounds, library_key);
  }

 private:
  [[nodiscard]] std::optional<Fallback> default_of(std::string_view library_key,
                                                   const std::optional<Fallback>& otherwise) const {
    if (const auto* p = resin_ == nullptr ? nullptr : resin_->find(library_key)) {
      return Fallback{p->text, library_origin(*p)};
    }
    return otherwise;
  }

  [[nodiscard]] std::string missing_in_library(std::string_view library_key,
                                               Dimension dimension) const {
    std::string hint;
    const auto* relaxed = resin_->find("youngs_modulus_relaxed");
    if (library_key == "youngs_modulus_linear" && relaxed != nullptr) {
      hint = fmt::format(", or use contact = \"hertz\" with the relaxed modulus {}", relaxed->text);
    }
    return fmt::format("is missing: the library has no {} for \"{}\"; {}{}", library_key,
                       resin_->name, such_as(library_key, dimension), hint);
  }

  Section& section_;
  const resin::Resin* resin_;
};

void read_contact(Section& section,
                  ResinReader& reader,
                  const BeadOptions& beads,
                  ResinOptions& options) {
  const Fallback thesis_friction{"0.1", "default: value of CM Sepharose 6FF, thesis table 8.4"};
  const Fallback thesis_rolling{"0.35", "default: value of CM Sepharose 6FF, thesis table 8.4"};
  const bool hooke = options.contact == ContactLawName::hooke;
  options.youngs_modulus =
      reader.unless_per_bead("youngs_modulus", Dimension::pressure, bounds::positive,
                             hooke ? "youngs_modulus_linear" : "youngs_modulus_relaxed",
                             !beads.table.youngs_modulus.empty());
  if (hooke) {
    options.characteristic_velocity =
        reader.needed("characteristic_velocity", Dimension::velocity, bounds::positive,
                      "characteristic_velocity", Fallback{"0.1 m/s", "default: thesis table 8.4"});
  } else {
    section.refuse("characteristic_velocity", "belongs to contact = \"hooke\"");
  }
  options.poisson_ratio =
      reader.unless_per_bead("poisson_ratio", Dimension::fraction, bounds::poisson_ratio,
                             "poisson_ratio", !beads.table.poisson_ratio.empty());
  options.restitution = reader.needed("restitution", Dimension::fraction, bounds::restitution,
                                      "restitution", Fallback{"0.5", "default: thesis table B.2"});
  options.viscous = section.boolean("viscous", false);
  if (options.viscous) {
    const Fallback e_max{"0.9", "default: thesis table 8.4"};
    const Fallback stokes{"0.3", "default: thesis table 8.4"};
    if (!hooke) section.fail("viscous", "goes with contact = \"hooke\" only");
    options.restitution_max = reader.needed("restitution_max", Dimension::fraction,
                                            bounds::restitution, "restitution_max", e_max);
    options.critical_stokes = reader.needed("critical_stokes", Dimension::fraction,
                                            bounds::positive, "critical_stokes", stokes);
  } else {
    for (const auto* key : {"restitution_max", "critical_stokes"}) {
      section.refuse(key, "belongs to viscous = true");
    }
  }
  options.tension = section.boolean("tension", false);
  options.friction = reader.needed("friction", Dimension::fraction, bounds::not_negative,
                                   "friction", thesis_friction);
  options.wall_friction = reader.needed("wall_friction", Dimension::fraction, bounds::not_negative,
                                        "wall_friction", thesis_friction);
  options.rolling = static_cast<RollingLawName>(
      section.choice("rolling", {"none", "cdt", "epsd"}, Fallback{"epsd"}));
  if (options.rolling == RollingLawName::none) {
    section.refuse("rolling_friction", "belongs to rolling = \"cdt\" or \"epsd\"");
    return;
  }
  options.rolling_friction =
      reader.needed("rolling_friction", Dimension::fraction, bounds::not_negative,
                    "rolling_friction", thesis_rolling);
}

/// The largest grain must not meet itself across a periodic side, and must fit between walls.
void check_fit(const Section& section,
               const ColumnOptions& column,
               double largest,
               std::string_view owner) {
  const auto check = [&](std::string_view what, double size) {
    if (size >= largest) return;
    section.fail_here(
        fmt::format("{} up to {:.4g} um, but {} is only {:.4g} um; make it wider or "
                    "them smaller",
                    owner, largest * 1e6, what, size * 1e6));
  };
  if (const auto* slice = std::get_if<mesh::Slice>(&column.shape)) {
    check("column.slice_depth", slice->depth);
    check("column.inner_diameter", slice->inner_diameter);
    check("column.height", slice->height);
  } else if (const auto* cylinder = std::get_if<mesh::Cylinder>(&column.shape)) {
    check("column.inner_diameter", cylinder->inner_diameter);
    check("column.height", cylinder->height);
  } else {
    const auto& box = std::get<mesh::Box>(column.shape);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (box.boundaries[axis] == mesh::Boundary::open) continue;
      check(fmt::format("column.size[{}]", axis + 1), box.size[axis]);
    }
  }
}

/// Beads that are made by number must fit into the column.
void check_count(const Section& section,
                 const ColumnOptions& column,
                 const BeadOptions& beads,
                 const ResinOptions& resin) {
  if (!beads.count) return;
  constexpr double densest = 0.74;  // equal spheres; random ones reach about 0.64
  const double grain = resin.coarse_grain * resin::statistics(*resin.sizes).volume_mean;
  const double volume =
      static_cast<double>(*beads.count) * std::numbers::pi / 6.0 * std::pow(grain, 3);
  const double share = volume / (mesh::cross_section(column.shape) * mesh::height(column.shape));
  if (share <= densest) return;
  section.fail_here(
      fmt::format("grains would fill {:.3g} times the column with beads.count = {}; "
                  "solids of more than {} cannot be packed",
                  share, *beads.count, densest));
}

/// Gives beads that name their resin its density and elastic constants, unless the file has them.
void apply_resins_of_beads(const resin::Library& library,
                           std::string_view modulus_key,
                           io::BeadTable& beads) {
  if (beads.resin.empty()) return;
  const struct {
    std::string_view key;
    std::vector<double>& values;
  } properties[] = {{"density", beads.density},
                    {modulus_key, beads.youngs_modulus},
                    {"poisson_ratio", beads.poisson_ratio}};
  for (const auto& [key, values] : properties) {
    if (!values.empty()) continue;
    for (std::size_t i = 0; i < beads.size(); ++i) {
      const auto* resin = library.find(beads.resin[i]);
      const auto* property = resin == nullptr ? nullptr : resin->find(key);
      if (property == nullptr) {
        throw ConfigError(fmt::format(
            "{}: resin = \"{}\" {}", beads.place(i), beads.resin[i],
            resin == nullptr ? std::string("is not in the library; `packbed resins` lists it")
                             : fmt::format("has no {} in the library; give the beads a column of "
                                           "it",
                                           key)));
      }
      values.push_back(property->si);
    }
  }
}

}  // namespace

ResinOptions read_resin(Section section,
                        const UnitSystem& units,
                        resin::Library library,
                        BeadOptions& beads,
                        const ColumnOptions& column,
                        bool has_liquid) {
  ResinOptions options;
  section.mention({"name", "library", "density", "coarse_grain", "contact", "youngs_modulus",
                   "characteristic_velocity", "poisson_ratio", "restitution", "viscous",
                   "restitution_max", "critical_stokes", "tension", "friction", "wall_friction",
                   "rolling", "rolling_friction", "sizes"});
  const auto name = section.optional_word("name");
  if (const auto own = section.optional_file("library")) library.add(read_library(*own, units));
  const resin::Resin* resin = name ? &find_resin(section, library, *name) : nullptr;
  options.name = name.value_or("");

  options.contact =
      static_cast<ContactLawName>(section.choice("contact", {"hooke", "hertz"}, Fallback{"hooke"}));
  apply_resins_of_beads(library, modulus_key(options.contact), beads.table);

  ResinReader reader(section, resin);
  options.density = reader.unless_per_bead("density", Dimension::density, bounds::positive,
                                           "density", !beads.table.density.empty());
  options.coarse_grain =
      section.quantity("coarse_grain", Dimension::fraction, bounds::at_least_1, Fallback{"1"});
  read_contact(section, reader, beads, options);
  if (beads.csv) {
    section.refuse("sizes", "does not go with beads.csv, which has the diameters");
    const auto& diameters = beads.table.diameter;
    check_fit(section, column, *std::ranges::max_element(diameters), "with beads.csv has beads");
  } else {
    options.sizes = read_sizes(section.table("sizes"), units, resin);
    check_fit(section, column, options.coarse_grain * resin::largest(*options.sizes),
              "has grains (coarse_grain times the largest bead)");
    check_count(section, column, beads, options);
  }
  if (options.viscous && !has_liquid) section.fail("viscous", "needs a [liquid] section");
  section.finish();
  return options;
}

}  // namespace packbed::setup
