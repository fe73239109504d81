// SPDX-License-Identifier: BSD-3-Clause
#include "app/plateau_outputs.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/outputs.hpp"
#include "column/liquid_profiles.hpp"
#include "core/file.hpp"

namespace packbed::app {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> columns = {"plateau",
                                          "stage",
                                          "start_time_s",
                                          "end_time_s",
                                          "superficial_velocity_m_s",
                                          "pressure_drop_Pa",
                                          "frit_pressure_drop_Pa",
                                          "pressure_drop_per_height_Pa_m",
                                          "bed_height_m",
                                          "compression",
                                          "mean_porosity",
                                          "middle_porosity",
                                          "floor_force_N",
                                          "wall_shear_N",
                                          "liquid_wall_shear_N",
                                          "budget_error",
                                          "pressure_noise",
                                          "steady"};

io::Cell cell(const std::optional<double>& value) {
  return value ? io::Cell(*value) : io::Cell(std::string());
}

std::string across_text(const std::vector<column::LiquidBin>& bins, std::string_view coordinate) {
  auto text = fmt::format("{0}_low_m,{0}_high_m,porosity,superficial_velocity_m_s\n", coordinate);
  for (const auto& b : bins) {
    text += fmt::format("{},{},{},{}\n", b.low, b.high, b.porosity, b.superficial_velocity);
  }
  return text;
}

std::string layers_text(const std::vector<column::LiquidBin>& bins) {
  std::string text = "z_low_m,z_high_m,porosity,superficial_velocity_m_s,pressure_Pa\n";
  for (const auto& b : bins) {
    text += fmt::format("{},{},{},{},{}\n", b.low, b.high, b.porosity, b.superficial_velocity,
                        b.pressure);
  }
  return text;
}

}  // namespace

PlateauOutputs::PlateauOutputs(std::filesystem::path folder, const Json& saved)
    : folder_(std::move(folder)), count_(saved.at("count")) {
  if (!Ranks::all().is_first()) return;
  const auto file = folder_ / "plateaus.csv";
  if (const std::int64_t bytes = saved.at("bytes"); bytes > 0) {
    series_ = io::SeriesWriter::resume(file, columns, bytes);
  } else {
    std::filesystem::remove(file);  // of after the checkpoint
  }
}

void PlateauOutputs::write(const column::Plateau& plateau,
                           const RowFigures& f,
                           const column::CoupledBed& liquid,
                           std::int64_t stage) {
  ++count_;
  write_profiles(f, liquid);
  if (!Ranks::all().is_first()) return;
  if (!series_) series_.emplace(folder_ / "plateaus.csv", columns);
  const auto& l = f.liquid;
  const bool has_bed = f.bed.height > 0.0;
  const auto of_bed = [&](double value) {
    return cell(has_bed ? std::optional(value) : std::nullopt);
  };
  series_->row({count_, stage, plateau.start, plateau.end, l.superficial_velocity, l.pressure_drop,
                l.frit_pressure_drop, of_bed(l.pressure_drop / f.bed.height), of_bed(f.bed.height),
                cell(f.compression()), of_bed(f.bed.mean_porosity), of_bed(f.bed.middle_porosity),
                of_bed(f.floor_force), of_bed(f.wall_shear), l.wall_shear, of_bed(f.budget_error),
                cell(plateau.noise), std::int64_t{plateau.is_steady}});
}

// Along z over the whole column; across it over the middle half of the bed.
void PlateauOutputs::write_profiles(const RowFigures& figures,
                                    const column::CoupledBed& liquid) const {
  const bool writes = Ranks::all().is_first();
  const auto folder = folder_ / "profiles";
  if (writes) std::filesystem::create_directories(folder);
  const auto write = [&](std::string_view coordinate, const std::string& text) {
    if (!writes) return;
    write_text_file(folder / fmt::format("plateau_{}_{:06}.csv", coordinate, count_), text);
  };
  write("z", layers_text(column::layer_profile(liquid.fluid())));
  if (figures.bed.height <= 0.0) return;
  const auto across = column::cross_profile(liquid.fluid(), liquid.shape(),
                                            analysis::middle_half(figures.bed.height));
  const auto* name = std::holds_alternative<mesh::Cylinder>(liquid.shape()) ? "radius" : "x";
  write(name, across_text(across, name));
}

Json PlateauOutputs::save() const {
  if (series_) series_->sync();
  return {{"count", count_}, {"bytes", series_ ? series_->bytes() : 0}};
}

}  // namespace packbed::app
