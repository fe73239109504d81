// SPDX-License-Identifier: BSD-3-Clause
#include "setup/read_sections.hpp"

namespace packbed::setup {

NumericsOptions read_numerics(Section section, const std::vector<ProtocolStep>& protocol) {
  NumericsOptions numerics{};
  numerics.step =
      section.quantity_or_word("step", Dimension::time, bounds::positive, "auto", Fallback{"auto"});
  numerics.inertia_scale = section.quantity_or_word("inertia_scale", Dimension::fraction,
                                                    bounds::positive, "auto", Fallback{"auto"});
  numerics.inertia_scaling = static_cast<InertiaScaling>(
      section.choice("inertia_scaling", {"by_size", "uniform"}, Fallback{"by_size"}));
  numerics.seed = static_cast<std::uint64_t>(section.integer("seed", 0, Fallback{"1"}));
  numerics.background_damping = section.quantity_or_word(
      "background_damping", Dimension::time, bounds::positive, "none", Fallback{"none"});
  numerics.gravity = section.boolean("gravity", true);
  if (!numerics.gravity && needs_gravity(protocol)) {
    section.fail("gravity", "does not go with a step \"settle\" or \"tap\", which needs gravity");
  }
  numerics.force_step = section.boolean("force_step", false);
  numerics.overlap_limit = section.quantity("overlap_limit", Dimension::fraction,
                                            bounds::between_0_and_1, Fallback{"0.3"});
  section.finish();
  return numerics;
}

OutputOptions read_output(Section section,
                          const std::filesystem::path& case_file,
                          const UnitSystem& units) {
  OutputOptions output{};
  // Many cases are called case.toml and told apart by their folder.
  const auto stem = case_file.stem();
  const auto parent = std::filesystem::absolute(case_file).parent_path().filename();
  const auto name = stem == "case" && !parent.empty() ? parent : stem;
  output.directory =
      section.word("directory", Fallback{(std::filesystem::path("runs") / name).string()});
  output.interval =
      section.quantity("interval", Dimension::time, bounds::positive, Fallback{"10 ms"});
  output.beads_csv = section.boolean("beads_csv", false);
  output.frames = section.boolean("frames", true);
  if (output.frames) {
    output.frame_interval = section.quantity_or_word(
        "frame_interval", Dimension::time, bounds::positive, "stage ends", Fallback{"stage ends"});
    output.analysis = section.boolean("analysis", true);
  } else {
    output.analysis = false;
    for (const auto* key : {"frame_interval", "analysis"}) {
      section.refuse(key, "applies only to frames = true");
    }
  }
  output.checkpoint_interval = section.quantity_or_word(
      "checkpoint_interval", Dimension::time, bounds::positive, "none", Fallback{"10 min"});
  if (const auto file = section.optional_file("measured")) {
    output.measured = std::filesystem::absolute(*file);
    output.measured_points = read_measured(*file, units);
  }
  section.finish();
  return output;
}

}  // namespace packbed::setup
