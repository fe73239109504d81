// SPDX-License-Identifier: BSD-3-Clause
// Any case, written back with every value filled in, reads to the same values.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "setup/read_case.hpp"

namespace packbed::setup {
namespace {

// --- random cases, with keys left out, units mixed and steps nested

using rc::gen::element;

std::string number(double low, double high) {
  const int permille = *rc::gen::inRange(0, 1001);
  return fmt::format("{}", low + (high - low) * permille / 1000.0);
}

std::string quantity(double low, double high, std::vector<std::string> units) {
  const auto unit = *rc::gen::elementOf(units);
  return fmt::format("\"{}{}{}\"", number(low, high), *element("", " ", "  "), unit);
}

std::string maybe(const std::string& key, const std::string& value) {
  return *rc::gen::arbitrary<bool>() ? fmt::format("{} = {}\n", key, value) : "";
}

std::string mesh(std::initializer_list<const char*> counts) {
  auto text = "[column.mesh]\n" + maybe("cell", quantity(0.3, 1, {"mm"})) + maybe("layers", "60");
  for (const auto* key : counts) text += maybe(key, "7");
  return text;
}

std::string frit() {
  return "[column.frit]\n" + maybe("youngs_modulus", quantity(2, 3, {"GPa"})) +
         maybe("inlet_resistance", quantity(1, 5, {"m-1", "cm-1"})) +
         maybe("outlet_resistance", quantity(0, 2, {"m-1"}));
}

std::string column() {
  std::string text = "[column]\n";
  std::string cells;
  const auto of_rectangles = {"cells_x", "cells_y"};
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      cells = mesh(of_rectangles) + frit();
      text += fmt::format("shape = \"slice\"\ninner_diameter = {}\nslice_depth = {}\nheight = {}\n",
                          quantity(5, 20, {"mm"}), quantity(2400, 4000, {"um", "µm"}),
                          quantity(5, 8, {"cm"}));
      break;
    case 1:
      cells = mesh({"core", "ring"}) + frit();
      text += fmt::format("shape = \"cylinder\"\ninner_diameter = {}\nheight = {}\n",
                          quantity(0.5, 2, {"cm", "inch"}), quantity(50, 80, {"mm"}));
      break;
    default:
      cells = mesh(of_rectangles);
      text += fmt::format("shape = \"box\"\nsize = [{0}, {0}, {1}]\n", quantity(2, 4, {"mm"}),
                          quantity(50, 60, {"mm"}));
      text += maybe("boundaries",
                    fmt::format("{{ x = \"{}\", z = \"wall\" }}", *element("periodic", "wall")));
  }
  return text +
         maybe("wall", fmt::format("{{ youngs_modulus = {} }}", quantity(1, 70, {"GPa", "kbar"}))) +
         (*rc::gen::arbitrary<bool>() ? cells : "");
}

std::string sizes() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return "";
    case 1:
      return fmt::format("[resin.sizes]\nmean = {}\n{}", quantity(80, 90, {"um"}),
                         maybe("standard_deviation", quantity(10, 20, {"um", "micron"})));
    case 2:
      return fmt::format(
          "[resin.sizes]\ndistribution = \"lognormal\"\nmedian = {}\n"
          "geometric_standard_deviation = {}\n",
          quantity(60, 90, {"um"}), number(1.05, 1.3));
    default:
      return fmt::format("[resin.sizes]\ndistribution = \"monodisperse\"\ndiameter = {}\n",
                         quantity(0.05, 0.2, {"mm"}));
  }
}

std::string resin() {
  const bool hooke = *rc::gen::arbitrary<bool>();
  return "[resin]\nname = \"SEP\"\n" +
         (hooke ? maybe("characteristic_velocity", quantity(1, 20, {"cm/s"})) +
                      maybe("viscous", "true")
                : std::string("contact = \"hertz\"\n")) +
         maybe("density", quantity(1.05, 1.3, {"g/cm3", "g/mL", "kg/L"})) +
         maybe("youngs_modulus", quantity(4, 60, {"MPa", "bar"})) +
         maybe("poisson_ratio", number(-0.9, 0.5)) + maybe("restitution", number(0.01, 1.0)) +
         maybe("friction", number(0, 1)) + maybe("rolling", "\"cdt\"") +
         maybe("tension", *element("true", "false")) +
         maybe("coarse_grain", *element("1", "2", "3", "2.5")) + sizes();
}

std::string flow() {
  return *element(quantity(10, 3000, {"cm/h", "cm h-1"}), quantity(0.1, 2, {"L/h"}),
                  quantity(1, 30, {"mL/min"}));
}

std::string step(const std::string& header, int depth) {
  const auto start = fmt::format("[[{}]]\nstep = ", header);
  switch (*rc::gen::inRange(0, depth > 1 ? 9 : 10)) {
    case 0:
      return start + fmt::format("\"run\"\nduration = {}\n", quantity(1, 900, {"ms", "s"}));
    case 1:
      return start + "\"flow_ramp\"\nto = " + flow() + "\n" + maybe("from", flow()) +
             maybe("steps", "20") + maybe("hold", quantity(0.1, 2, {"s", "min"})) +
             maybe("change", "\"jump\"");
    case 2:
      return start + "\"hold\"\nduration = \"1 s\"\n" + maybe("flow", flow());
    case 3:
      return start + "\"compress\"\nspeed = " + quantity(1, 30, {"mm/min"}) + "\n" +
             *element<std::string>("compression = \"2.5 %\"\n", "compression_factor = 1.15\n",
                                   "packing_factor = 1.1\n", "further_compression = 0.02\n",
                                   "height = \"20 mm\"\n", "force = \"0.5 N\"\n",
                                   "pressure = \"0.5 bar\"\n") +
             maybe("hold", quantity(0.1, 2, {"s"})) + maybe("friction", number(0, 1)) +
             *element<std::string>("", "drained = true\n", "flow = \"20 cm/h\"\n");
    case 4:
      return start + "\"tap\"\namplitude = " + quantity(1, 90, {"um"}) +
             "\nfrequency = " + quantity(10, 90, {"Hz", "s-1"}) + "\n" + maybe("count", "3");
    case 5:
      return start + "\"relax\"\nspeed = " + quantity(1, 30, {"mm/min"}) + "\n" +
             *element<std::string>("", "compression = \"2.5 %\"\n", "force = \"0 N\"\n") +
             maybe("withdraw", "true") + maybe("drained", "true");
    case 6:
      return start + "\"flow_pack\"\nflow = " + flow() + "\n" + maybe("steps", "4") +
             maybe("hold", quantity(0.1, 2, {"s"})) + maybe("compression", "\"20 %\"") +
             maybe("plunger_speed", quantity(1, 30, {"mm/min"}));
    case 7:
      return start + "\"cycle\"\ncount = 3\nhigh = " + flow() + "\nlow = " + flow() + "\n" +
             maybe("high_duration", quantity(0.1, 2, {"s"})) +
             maybe("low_duration", quantity(0.1, 2, {"s"}));
    case 8:
      return start + "\"store\"\n" + maybe("hold_limit", quantity(0.1, 2, {"s"}));
    default: {
      std::string text = start + "\"repeat\"\ncount = 3\n";
      const int count = *rc::gen::inRange(1, 4);
      for (int i = 0; i < count; ++i) text += step(header + ".steps", depth + 1);
      return text;
    }
  }
}

std::string settle() {
  return "[[protocol]]\nstep = \"settle\"\nbed_height = " + quantity(10, 40, {"mm"}) + "\n" +
         maybe("porosity", number(0.36, 0.42));
}

std::string random_case() {
  std::string text =
      maybe("title", "\"A \\\"quoted\\\" title, with # and ä\"") + column() + resin();
  text += "[liquid]\n" + maybe("temperature", quantity(4, 40, {"degC"})) +
          maybe("wall_void_fraction", *element<std::string>("1", "0.4", "\"bed\""));
  text += "[drag]\n" + maybe("law", *element<std::string>("\"ergun\"", "\"beetstra\"")) +
          maybe("min_void_fraction", number(0.3, 0.45));
  text += "[coupling]\n" + maybe("overlap", "\"merged\"") + maybe("scheme", "\"frozen_velocity\"") +
          maybe("interval", quantity(1, 5, {"ms"}));
  if (*rc::gen::arbitrary<bool>()) text += settle();
  const int count = *rc::gen::inRange(0, 5);
  for (int i = 0; i < count; ++i) text += step("protocol", 0);
  text += "[numerics]\n" + maybe("step", *element<std::string>("\"auto\"", "\"1.5 us\"")) +
          maybe("inertia_scale", *element<std::string>("\"auto\"", "500", "12.5")) +
          maybe("inertia_scaling", "\"uniform\"") + maybe("seed", "7") +
          maybe("force_step", "true") + maybe("overlap_limit", number(0.1, 0.6)) +
          maybe("background_damping", "\"20 ms\"");
  return text + "[output]\n" + maybe("interval", quantity(1, 50, {"ms"})) +
         maybe("beads_csv", "true") +
         *element<std::string>("", "analysis = false\n", "frames = false\n");
}

void expect_same(const Case& a, const Case& b) {
  RC_ASSERT(a.title == b.title);
  RC_ASSERT(a.column == b.column);
  RC_ASSERT(a.resin == b.resin);
  RC_ASSERT(a.liquid == b.liquid);
  RC_ASSERT(a.drag == b.drag);
  RC_ASSERT(a.coupling == b.coupling);
  RC_ASSERT(a.beads == b.beads);
  RC_ASSERT(a.protocol == b.protocol);
  RC_ASSERT(a.numerics == b.numerics);
  RC_ASSERT(a.output == b.output);
}

RC_GTEST_PROP(Echo, ReadsBackToTheSameValues, ()) {
  static const UnitSystem units;
  const auto text = random_case();
  RC_LOG(text);
  const auto original = read_case_text(text, "case.toml", units);
  const auto written = to_toml(original.echo);
  RC_LOG(written);

  const auto again = read_case_text(written, "case.toml", units);

  expect_same(original, again);
  // and a second writing changes nothing but the origins, which are now all the user's
  const auto third = read_case_text(to_toml(again.echo), "case.toml", units);
  RC_ASSERT(to_toml(again.echo) == to_toml(third.echo));
}

}  // namespace
}  // namespace packbed::setup
