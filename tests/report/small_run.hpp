// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "report/run_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed::test {

/// The folder of a run as packbed leaves it, with numbers that are easy to follow: a bed of 8 mm, flows of 1,
/// 2 and 1 mm/s, a pressure drop of 100 Pa s/mm. `title` is that of the case.
class SmallRun {
 public:
  explicit SmallRun(const std::string& title = "small", const std::string& resin = "gel") {
    write("case.toml",
          "title = " + quoted(title) +
              "\n[column]\nshape = \"slice\"\ninner_diameter = \"0.4 cm\"\n"
              "slice_depth = \"900 um\"\nheight = \"12 mm\"\n"
              "[resin]\nname = " +
              quoted(resin) +
              "\nyoungs_modulus = \"30 MPa\"\ncoarse_grain = 3\n"
              "[liquid]\nname = \"water\"\ntemperature = \"293.15 K\"\n"
              "[[protocol]]\nstep = \"settle\"\nbed_height = \"8 mm\"\n"
              "[[protocol]]\nstep = \"repeat\"\ncount = 1\n"
              "[[protocol.steps]]\nstep = \"flow_ramp\"\nfrom = \"0 m/s\"\nto = \"2 mm/s\"\n"
              "steps = 2\nhold = \"1 s\"\nchange = \"ramp\"\n"
              "[[protocol.steps]]\nstep = \"hold\"\nduration = \"1 s\"\nflow = \"1 mm/s\"\n");
    report::Json summary = {{"version", "0.1.0"},
                            {"case", "/home/me/small.toml"},
                            {"title", title},
                            {"simulated_time_s", 4.0},
                            {"settled_height_m", 0.008},
                            {"settled_porosity", 0.4},
                            {"wall_time_s", 3.0},
                            {"ranks", 1},
                            {"warnings", {"mind the gap"}},
                            {"figures",
                             {{"sizes", {{"sauter_diameter_m", 9e-5}}},
                              {"liquid", {{"density_kg_m3", 998.2}, {"viscosity_Pa_s", 1e-3}}}}}};
    write("summary.json", summary.dump());
    write("series.csv",
          "time_s,stage,superficial_velocity_m_s,pressure_drop_Pa,bed_height_m,compression,"
          "budget_error\n"
          "0,0,0,0,0.01,,1\n"
          "1,1,0,0,0.008,0,-1e-5\n"
          "1.5,2,0.0005,50,0.00796,0.005,0.1\n"
          "1.8,2,0.001,100,0.00794,0.0075,0.1\n"
          "2,2,0.001,100,0.00792,0.01,0.001\n"
          "2.8,2,0.002,200,0.00786,0.0175,0.1\n"
          "3,2,0.002,200,0.00784,0.02,0.001\n"
          "3.8,3,0.001,110,0.00785,0.019,0.1\n"
          "4,3,0.001,110,0.00788,0.015,0.001\n");
    std::string sections =
        "time_s,section,z_top_m,z_bottom_m,height_m,compression,packing_density\n";
    for (const auto* time : {"1", "2", "3", "4"}) {
      for (const auto* section : {"1", "2", "3", "4", "5", "6", "7"}) {
        sections += std::string(time) + "," + section + ",0,0,0,0.0" + section + ",0.6\n";
      }
    }
    write("sections.csv", sections);
    write("profiles/z_000001.csv", "z_low_m,z_high_m,porosity\n0,0.004,0.5\n0.004,0.008,0.25\n");
  }

  void write(const std::string& name, const std::string& text) const {
    (void)folder_.file(name, text);
  }
  void remove(const std::string& name) const { std::filesystem::remove(path() / name); }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  static std::string quoted(const std::string& text) { return report::Json(text).dump(); }

  TemporaryFolder folder_;
};

}  // namespace packbed::test
