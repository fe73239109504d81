// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Material sections of a bed, as colored layers in an experiment (thesis sections 5.4.2 and 7.1): equal
/// in height in a reference state, their boundaries then move with the beads.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/bead.hpp"

namespace packbed::analysis {

struct SectionOptions {
  int count = 7;
  double reach =
      0.45e-3;  ///< tracers of a boundary: beads so near [m]; at most half a section is taken
};

/// A bead by which a boundary is followed.
struct Tracer {
  std::int64_t id = 0;
  std::int32_t boundary = 0;  ///< 1: between sections 1 and 2
  double offset = 0.0;        ///< of its center over the boundary in the reference state [m]
  bool operator==(const Tracer&) const = default;
};

/// All that has to be kept of the reference state.
struct SectionReference {
  std::vector<double> boundaries;  ///< heights from the top of the bed down to 0 [m]
  std::vector<Tracer> tracers;     ///< of all ranks, on every rank, by id
  bool operator==(const SectionReference&) const = default;
};

/// Sections of the present state, height = bed_height(beads). Ids must be unique. ValueError if a boundary
/// has fewer than three tracers: too many sections for the bed.
SectionReference section_reference(std::span<const Bead> beads,
                                   double height,
                                   const SectionOptions& options,
                                   const Ranks& ranks);

/// One row of sections.csv.
struct Section {
  int section = 0;               ///< 1: top
  double z_top = 0.0;            ///< [m]
  double z_bottom = 0.0;         ///< [m]
  double height = 0.0;           ///< [m]
  double compression = 0.0;      ///< 1 - height / height in the reference state
  double packing_density = 0.0;  ///< volume of beads in the section, shares exact, over its volume
};

/// The sections now. The top of the first one is `height`, the bottom of the last one 0; in between a
/// boundary is where the straight line through the tracers' heights over their offsets has offset 0, so
/// that an affine motion of the bed is followed exactly. A section whose boundaries have passed each other
/// (loose beads on top that were washed away) has a height <= 0 and packing density 0. DivergenceError if
/// a boundary has lost its tracers.
std::vector<Section> sections(const SectionReference& reference,
                              std::span<const Bead> beads,
                              double height,
                              double cross_section,
                              const Ranks& ranks);

/// How uneven packing densities are, S_mean = sqrt(mean of (phi_i - mean phi)^2), thesis eq. 5.3, the mean
/// taken over sections.
double density_spread(std::span<const Section> sections);

/// How far packing densities are from those after packing, S_init = sqrt(mean of (phi_i - phi_i,init)^2),
/// thesis eq. 5.4.
double density_change(std::span<const Section> sections, std::span<const Section> initial);

}  // namespace packbed::analysis
