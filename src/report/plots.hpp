// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// The plots of one run, or of several runs laid over each other. A group without plots has nothing to show.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/rose.hpp"
#include "report/run_data.hpp"

namespace packbed::report {

/// Pressure drop, compression and height of the bed against velocity, with the Kozeny-Carman line and what
/// was measured.
PlotGroup flow_plots(std::span<const RunData> runs);
/// Flow and bed against time.
PlotGroup time_plots(std::span<const RunData> runs);
/// Force of the plunger against compression, where a run has one.
PlotGroup plunger_plots(std::span<const RunData> runs);
/// What frames tell of forces, directions and stresses.
PlotGroup force_plots(std::span<const RunData> runs);
/// Directions of contacts and of the forces that they carry, for the same section.
std::vector<Rose> direction_roses(std::span<const RunData> runs);
/// Sections, wall and liquid over the stages, or over the cycles of several runs.
PlotGroup evenness_plots(std::span<const RunData> runs);
/// Compression and packing density of the material sections.
PlotGroup section_plots(std::span<const RunData> runs);
/// Porosity, and where there are plateaus velocity and pressure, over slices of the bed.
PlotGroup profile_plots(std::span<const RunData> runs);
/// Whether the figures can be trusted: budget of forces, rest, overlaps.
PlotGroup check_plots(std::span<const RunData> runs);

/// Kozeny-Carman's pressure drop per height at unit velocity, of the settled bed [Pa s/m2]; none where the
/// run has no settled bed or no liquid. With the Sauter diameter of the beads, not of coarse grains.
std::optional<double> kozeny_carman_resistance(const RunData& run);

/// Plateaus between two turns of the flow, in the order of their velocities. Neighbors share the plateau at
/// which the flow turns.
struct Branch {
  std::string name;  ///< "up", "down", "up 2"
  bool rises = true;
  std::vector<std::size_t> plateaus;  ///< their places in RunData::plateaus
};
std::vector<Branch> branches(std::span<const Plateau> plateaus);
/// Those that a plot shows: all up to six, else the first four and the last two.
std::vector<Branch> shown_branches(std::span<const Plateau> plateaus);

/// What a curve is called: `what`, with the run in front where there are several.
std::string curve_label(std::span<const RunData> runs, std::size_t run, const std::string& what);

/// "stage 3, compress".
std::string stage_label(const RunData& run, int stage);
/// "after stage 3, compress"; "at the start".
std::string stage_end_label(const RunData& run, int stage);

/// Whether the flow of a plateau is lower than that of the one before.
bool falls(const RunData& run, std::size_t plateau);
/// "553 cm/h down".
std::string plateau_label(const RunData& run, std::size_t plateau);
/// The velocity over the highest one, for a scale of colors.
double plateau_shade(const RunData& run, std::size_t plateau);
/// Place of the plateau with the highest flow.
std::size_t highest_flow(std::span<const Plateau> plateaus);

/// At most `limit` of `count` places, evenly spread, the first and the last one among them; of one the last.
std::vector<std::size_t> spread(std::size_t count, std::size_t limit);

}  // namespace packbed::report
