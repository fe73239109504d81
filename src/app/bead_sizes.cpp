// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <fmt/format.h>

#include "app/bead_commands.hpp"
#include "app/print.hpp"
#include "app/quantities.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "io/plot.hpp"
#include "resin/size_bins.hpp"
#include "resin/size_statistics.hpp"
#include "setup/data_columns.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;
namespace bounds = setup::bounds;

constexpr double most_beads = 1e7;

// One diameter per bead: rows, repeated by their count if there is one.
std::vector<double> read_diameters(const std::string& file, const UnitSystem& units) {
  const CsvTable table(file);
  const setup::DataColumns columns(table, units, "diameter [um]");
  const auto diameters = columns.values("diameter", Dimension::length);
  const bool counted = columns.has_text("count");
  const auto counts = counted ? columns.values("count", Dimension::fraction)
                              : std::vector<double>(diameters.size(), 1.0);
  std::vector<double> all;
  for (std::size_t row = 0; row < diameters.size(); ++row) {
    if (!(diameters[row] > 0.0)) {
      throw ConfigError(fmt::format("{}: the diameter must be positive", table.place(row)));
    }
    if (!(counts[row] >= 0.0 && counts[row] == std::floor(counts[row]))) {
      throw ConfigError(fmt::format("{}: count = {} must be a whole number, not negative",
                                    table.place(row), counts[row]));
    }
    if (static_cast<double>(all.size()) + counts[row] > most_beads) {
      throw ConfigError(fmt::format("{}: more than {:.0e} beads", table.place(row), most_beads));
    }
    all.insert(all.end(), static_cast<std::size_t>(counts[row]), diameters[row]);
  }
  if (all.empty()) throw ConfigError(fmt::format("{}: all counts are 0", file));
  return all;
}

std::vector<std::pair<const char*, double>> figures(const std::vector<double>& diameters) {
  const auto measured = resin::Measured::from(diameters);
  const auto s = resin::statistics(measured);
  return {{"mean_m", s.mean},
          {"standard_deviation_m", s.standard_deviation},
          {"median_m", s.median},
          {"smallest_m", s.smallest},
          {"largest_m", s.largest},
          {"number_d10_m", measured.quantile(0.1)},
          {"number_d90_m", measured.quantile(0.9)},
          {"volume_d10_m", s.d10},
          {"volume_d50_m", s.d50},
          {"volume_d90_m", s.d90},
          {"sauter_m", s.sauter},
          {"volume_mean_m", s.volume_mean}};
}

std::string draw(const std::vector<resin::SizeBin>& bins) {
  io::PlotPanel density{.title = "Distribution density",
                        .x = {"diameter [um]"},
                        .y = {"share / width [% / um]"},
                        .series = {}};
  io::PlotPanel sums{.title = "Cumulative distribution",
                     .x = {"diameter [um]"},
                     .y = {"share of smaller beads [%]"},
                     .series = {}};
  sums.y.range = {0.0, 100.0};
  for (const bool volume : {false, true}) {
    const std::string label = volume ? "of the volume" : "of the number";
    io::PlotSeries steps{.label = label, .x = {bins.front().lower * 1e6}, .y = {0.0}};
    io::PlotSeries sum = steps;
    for (const auto& bin : bins) {
      const double q = 1e-4 * (volume ? bin.volume_density() : bin.number_density());
      steps.x.insert(steps.x.end(), {bin.lower * 1e6, bin.upper * 1e6});
      steps.y.insert(steps.y.end(), {q, q});
      sum.x.push_back(bin.upper * 1e6);
      sum.y.push_back(100.0 * (volume ? bin.volume_below_upper : bin.number_below_upper));
    }
    steps.x.push_back(bins.back().upper * 1e6);
    steps.y.push_back(0.0);
    density.series.push_back(steps);
    sums.series.push_back(sum);
  }
  return io::plot_svg({density, sums});
}

void write_table(const std::string& file, const std::vector<resin::SizeBin>& bins) {
  std::vector<std::vector<double>> c(6);
  for (const auto& b : bins) {
    const std::array row{b.lower,
                         b.upper,
                         b.number_share,
                         b.volume_share,
                         b.number_below_upper,
                         b.volume_below_upper};
    for (std::size_t i = 0; i < row.size(); ++i) c[i].push_back(row[i]);
  }
  write_csv(file,
            {"lower_m", "upper_m", "number_share", "volume_share", "number_below_upper",
             "volume_below_upper"},
            c);
}

}  // namespace

int bead_sizes(const BeadSizesCommand& command) {
  const UnitSystem units;
  const auto diameters = read_diameters(command.file, units);
  const double width =
      quantity_or(units, {"--bin", command.bin}, Dimension::length, bounds::positive, 5e-6);
  const auto bins = resin::size_bins(diameters, width);
  if (command.json) {
    Json j{{"beads", diameters.size()}};
    for (const auto& [name, value] : figures(diameters)) j[name] = value;
    j["bin_width_m"] = width;
    for (const auto& b : bins) {
      j["bins"].push_back({{"lower_m", b.lower},
                           {"upper_m", b.upper},
                           {"number_share", b.number_share},
                           {"volume_share", b.volume_share},
                           {"number_below_upper", b.number_below_upper},
                           {"volume_below_upper", b.volume_below_upper}});
    }
    fmt::print("{}", json_text(j));
  } else {
    fmt::print("{:<34} {}\n", "beads", diameters.size());
    for (const auto& [name, value] : figures(diameters)) {
      std::string words(name, std::string_view(name).size() - 2);
      for (auto& c : words) c = c == '_' ? ' ' : c;
      fmt::print("{:<34} {:.2f} um\n", words, value * 1e6);
    }
    fmt::print("\n  from [um]     to [um]  number [%]  volume [%]   sum, number   sum, volume\n");
    for (const auto& b : bins) {
      fmt::print("{:>11.2f} {:>11.2f} {:>11.3f} {:>11.3f} {:>13.3f} {:>13.3f}\n", b.lower * 1e6,
                 b.upper * 1e6, 100 * b.number_share, 100 * b.volume_share,
                 100 * b.number_below_upper, 100 * b.volume_below_upper);
    }
  }
  write_table(command.csv, bins);
  write_plot(command.plot, command.plot.empty() ? "" : draw(bins));
  return 0;
}

}  // namespace packbed::app
