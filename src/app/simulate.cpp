// SPDX-License-Identifier: BSD-3-Clause
#include "app/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "column/protocol/run_step.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/version.hpp"
#include "io/bead_csv.hpp"
#include "io/series.hpp"
#include "setup/make_dem.hpp"

namespace packbed::app {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Ratio of two sums that may both be zero.
double ratio(double a, double b) { return b > 0.0 ? a / b : 0.0; }

/// Calls visit(plan) for every step "run", in their order.
void for_each_run(const setup::Case& c,
                  const std::vector<setup::ProtocolStep>& steps,
                  double step,
                  const std::function<void(const column::RunPlan&)>& visit) {
  for (const auto& s : steps) {
    if (const auto* run = std::get_if<setup::Run>(&s.what)) {
      visit(column::plan_run(run->duration, step, c.output.interval));
    } else if (const auto* repeat = std::get_if<setup::Repeat>(&s.what)) {
      for (std::int64_t k = 0; k < repeat->count; ++k) for_each_run(c, repeat->steps, step, visit);
    }
  }
}

/// Time steps of all of them; a double, since there may be any number.
double steps_of(const setup::Case& c, const std::vector<setup::ProtocolStep>& steps, double step) {
  double total = 0.0;
  for (const auto& s : steps) {
    if (const auto* run = std::get_if<setup::Run>(&s.what)) {
      total += static_cast<double>(column::plan_run(run->duration, step, c.output.interval).steps);
    } else if (const auto* repeat = std::get_if<setup::Repeat>(&s.what)) {
      total += static_cast<double>(repeat->count) * steps_of(c, repeat->steps, step);
    }
  }
  return total;
}

std::array<double, 3> as_array(const Vec3& a) { return {a.x, a.y, a.z}; }

/// Everything that is written while a run is under way.
class Outputs {
 public:
  Outputs(const setup::Case& c,
          const std::filesystem::path& folder,
          double steps,
          std::vector<std::string> walls)
      : folder_(folder),
        beads_csv_(c.output.beads_csv),
        steps_(steps),
        walls_(std::move(walls)),
        beads_(setup::make_beads(c)) {
    if (!Ranks::all().is_first()) return;
    series_.emplace(folder / "series.csv", columns(walls_));
    if (beads_csv_) std::filesystem::create_directories(folder / "frames");
    std::ranges::sort(beads_, {}, [](const auto& bead) { return bead.properties.id; });
  }

  void write(const dem::Dem& dem, std::size_t stage) {
    const auto s = dem.snapshot();
    if (!std::isfinite(s.kinetic_energy) || !std::isfinite(s.elastic_energy)) {
      throw DivergenceError(fmt::format(
          "step {}, time {:.6g} s: the energy of the beads is not a finite number; start them "
          "slower, or take a smaller step",
          dem.steps(), s.time));
    }
    if (!series_) return;  // the first rank writes
    std::vector<io::Cell> row = {s.time,
                                 dem.steps(),
                                 static_cast<std::int64_t>(stage),
                                 s.mean_overlap,
                                 s.max_overlap_ratio,
                                 s.coordination_number,
                                 s.kinetic_energy,
                                 s.elastic_energy,
                                 ratio(s.kinetic_energy, s.elastic_energy),
                                 ratio(s.mean_unbalanced_force, s.mean_contact_force),
                                 dem.bead_count()};
    for (const auto& force : s.wall_force) {
      for (const double component : as_array(force)) row.emplace_back(component);
    }
    series_->row(row);
    if (beads_csv_) write_beads(s);
    summary.kinetic_to_elastic = ratio(s.kinetic_energy, s.elastic_energy);
    summary.unbalanced_force = ratio(s.mean_unbalanced_force, s.mean_contact_force);
    summary.max_overlap_ratio = std::max(summary.max_overlap_ratio, s.max_overlap_ratio);
    summary.coordination_number = s.coordination_number;
    show_progress(dem);
  }

  RunSummary summary;

 private:
  static std::vector<std::string> columns(const std::vector<std::string>& walls) {
    std::vector<std::string> names = {"time_s",
                                      "step",
                                      "stage",
                                      "mean_overlap_m",
                                      "max_overlap_ratio",
                                      "coordination_number",
                                      "kinetic_energy_J",
                                      "elastic_energy_J",
                                      "kinetic_to_elastic",
                                      "unbalanced_force",
                                      "particles"};
    for (const auto& wall : walls) {
      for (const char axis : {'x', 'y', 'z'}) names.push_back(fmt::format("{}_f{}_N", wall, axis));
    }
    return names;
  }

  void write_beads(const dem::Snapshot& s) {
    std::vector<io::BeadRow> rows;
    for (std::size_t i = 0; i < beads_.size(); ++i) {
      const auto& p = beads_[i].properties;
      rows.push_back({.id = p.id,
                      .x = as_array(s.x[i]),
                      .v = as_array(s.v[i]),
                      .w = as_array(s.w[i]),
                      .diameter = p.diameter,
                      .fixed = p.fixed,
                      .density = p.density,
                      .youngs_modulus = p.material.youngs_modulus,
                      .poisson_ratio = p.material.poisson_ratio,
                      .force = as_array(s.force[i]),
                      .torque = as_array(s.torque[i])});
    }
    io::write_bead_csv(folder_ / "frames" / fmt::format("beads_{:06}.csv", frame_++), rows);
  }

  void show_progress(const dem::Dem& dem) {
    const bool terminal = isatty(STDERR_FILENO) == 1 || std::getenv("PACKBED_PROGRESS") != nullptr;
    const double done = steps_ > 0.0 ? static_cast<double>(dem.steps()) / steps_ : 1.0;
    const double spent = seconds_since(start_);
    if (!terminal || (spent - shown_ < 0.2 && done < 1.0)) return;
    shown_ = spent;
    const double rate = static_cast<double>(dem.steps()) * static_cast<double>(dem.bead_count()) /
                        std::max(spent, 1e-9);
    fmt::print(
        stderr, "\rrun: {:5.1f} %  time {:.4g} s  {:.3g} million particle-steps/s  {:.0f} s left ",
        100.0 * done, dem.time(), rate * 1e-6, done > 0.0 ? spent * (1.0 - done) / done : 0.0);
    if (done >= 1.0) fmt::print(stderr, "\n");
  }

  std::filesystem::path folder_;
  bool beads_csv_;
  double steps_;
  std::vector<std::string> walls_;
  std::vector<dem::BeadStart> beads_;  ///< in the order of ids
  std::optional<io::SeriesWriter> series_;
  std::int64_t frame_ = 0;
  double shown_ = -1.0;
  Clock::time_point start_ = Clock::now();
};

bool only_runs(const std::vector<setup::ProtocolStep>& steps) {
  return std::ranges::all_of(steps, [](const auto& s) {
    const auto* repeat = std::get_if<setup::Repeat>(&s.what);
    return std::holds_alternative<setup::Run>(s.what) ||
           (repeat != nullptr && only_runs(repeat->steps));
  });
}

void check_resolution(const setup::Case& c, const dem::StepChoice& choice) {
  const double per_contact = choice.contact_time / choice.step;
  if (c.numerics.force_step || per_contact >= dem::fewest_steps_per_contact * (1.0 - 1e-9)) return;
  throw ConfigError(
      fmt::format("{}: numerics.step = {:.4g} s leaves {:.2g} steps to the shortest contact "
                  "({:.4g} s); give at most "
                  "{:.4g} s, leave it out, or set numerics.force_step = true",
                  c.file.string(), choice.step, per_contact, choice.contact_time,
                  choice.contact_time / dem::fewest_steps_per_contact));
}

std::string log_head(const setup::Case& c, const dem::StepChoice& choice, double steps) {
  std::string text = fmt::format("packbed {}, case {}\n", version, c.file.string());
  text += fmt::format("{} beads on {} ranks\n", c.beads.table.size(), Ranks::all().size());
  text +=
      fmt::format("inertia scale {}{}\n", c.numerics.inertia_scale.value_or(1.0),
                  c.numerics.inertia_scale ? "" : " (auto: beads of a step \"run\" move freely)");
  text += fmt::format(
      "time step {:.6g} s ({}); shortest contact {:.6g} s; stable in a bed up to about "
      "{:.6g} s\n",
      choice.step, c.numerics.step ? "given" : "recommended", choice.contact_time,
      choice.stable_in_a_bed);
  return text + fmt::format("{:.0f} time steps to do\n", steps);
}

std::string log_end(const setup::Case& c, const RunSummary& s) {
  const double rate = static_cast<double>(s.steps) * static_cast<double>(c.beads.table.size()) /
                      std::max(s.wall_time, 1e-9);
  return fmt::format(
      "done: {:.6g} s simulated, {} renewals of the list of pairs, {:.3g} s wall time, "
      "{:.3g} million particle-steps/s with outputs\n",
      s.simulated_time, s.renewals, s.wall_time, rate * 1e-6);
}

}  // namespace

bool can_simulate(const setup::Case& c) { return c.beads.csv && only_runs(c.protocol); }

RunSummary simulate(const setup::Case& c, const std::filesystem::path& folder) {
  const auto start = Clock::now();
  const auto choice = setup::step_of(c);
  check_resolution(c, choice);
  const double total = steps_of(c, c.protocol, choice.step);
  const bool writes = Ranks::all().is_first();
  auto log = log_head(c, choice, total);
  if (writes) write_text_file(folder / "run.log", log);

  auto dem = setup::make_dem(c, choice.step, Ranks::all());
  std::vector<std::string> walls;
  for (const auto& wall : dem.walls()) walls.push_back(wall.name);
  Outputs outputs(c, folder, total, walls);
  outputs.write(dem, 0);
  std::size_t stage = 0;
  double last_step = choice.step;
  for_each_run(c, c.protocol, choice.step, [&](const column::RunPlan& plan) {
    ++stage;
    last_step = plan.step;
    column::run_step(dem, plan, c.numerics.force_step, [&] { outputs.write(dem, stage); });
    log += fmt::format("stage {}: run, {} steps of {:.6g} s\n", stage, plan.steps, plan.step);
  });
  auto summary = outputs.summary;
  summary.simulated_time = dem.time();
  summary.steps = dem.steps();
  summary.renewals = dem.renewals();
  summary.step = last_step;
  summary.inertia_scale = c.numerics.inertia_scale.value_or(1.0);
  summary.wall_time = seconds_since(start);
  if (writes) write_text_file(folder / "run.log", log + log_end(c, summary));
  return summary;
}

}  // namespace packbed::app
