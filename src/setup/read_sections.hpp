// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// One reader per section of a case file. Each refuses what it does not know; what they throw is
/// described at read_case.

#include "resin/resin.hpp"
#include "setup/case.hpp"
#include "setup/section.hpp"

namespace packbed::setup {

/// The column has a mesh if it `has_liquid`.
ColumnOptions read_column(Section section, bool has_liquid);
/// Superficial velocity of a relative hydrodynamic load of 1: that of the column, else the flow of the first
/// step "flow_pack" [m/s].
std::optional<double> full_load(const ColumnOptions& column,
                                const toml::table& file,
                                const Reading& reading);
BeadOptions read_beads(Section section, const ColumnOptions& column);
/// `library` has the resins that the program comes with; the case may add its own.
/// Beads of a file that name their resin get its properties here.
ResinOptions read_resin(Section section,
                        const UnitSystem& units,
                        resin::Library library,
                        BeadOptions& beads,
                        const ColumnOptions& column,
                        bool has_liquid);
LiquidOptions read_liquid(Section section);
DragOptions read_drag(Section section);
/// After all that says how wide cells, grains and periodic sides are.
CouplingOptions read_coupling(Section section, const Case& c);
/// Steps with a flow need `has_liquid`. The number of beads comes from [beads] or from the bed
/// height of the first settling, never from both.
std::vector<ProtocolStep> read_protocol(std::vector<Section> sections,
                                        const ColumnOptions& column,
                                        const BeadOptions& beads,
                                        bool has_liquid);
/// Whether a step makes beads sink.
bool needs_gravity(const std::vector<ProtocolStep>& protocol);
NumericsOptions read_numerics(Section section, const std::vector<ProtocolStep>& protocol);
OutputOptions read_output(Section section,
                          const std::filesystem::path& case_file,
                          const UnitSystem& units);

}  // namespace packbed::setup
