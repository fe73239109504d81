// SPDX-License-Identifier: BSD-3-Clause
#include "app/simulate.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/progress.hpp"
#include "app/run_checkpoint.hpp"
#include "app/run_log.hpp"
#include "app/stages.hpp"
#include "app/stop_signal.hpp"
#include "app/timings.hpp"
#include "column/plunger.hpp"
#include "core/error.hpp"
#include "core/version.hpp"
#include "dem/inertia_scale.hpp"
#include "setup/make_dem.hpp"
#include "setup/make_liquid.hpp"

namespace packbed::app {
namespace {

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

/// A run while it is under way.
class Simulation {
 public:
  Simulation(const setup::Case& c, const std::filesystem::path& folder, bool resume)
      : c_(c),
        folder_(folder),
        choice_(setup::step_of(c)),
        stages_(stage_count(c)),
        total_steps_(std::max(expected_steps(c, choice_.step), 1.0)),
        log_(folder / "run.log", resume) {
    check_resolution(c, choice_);
    if (resume) {
      go_on();
    } else {
      start();
    }
  }

  void run() {
    for (; now_.stage < stages_; ++now_.stage) {
      carry_out_stage();
      steps_behind_ += expected_steps(c_, now_.stage, choice_.step);
    }
    progress_->end();
  }

  [[nodiscard]] RunSummary summary() const {
    return {.simulated_time = dem_->time(),
            .steps = dem_->steps(),
            .renewals = dem_->renewals(),
            .step = dem_->options().step,
            .inertia_scale = dem_->options().inertia_scale,
            .beads = dem_->bead_count(),
            .has_flow = has_flow(c_),
            .has_plunger = any_plunger(c_),
            .figures = outputs_->figures(),
            .warnings = now_.warnings,
            .timings = timings_,
            .wall_time = seconds_since(start_)};
  }

 private:
  void start() {
    log_.line(fmt::format("packbed {}, case {}", version, c_.file.string()));
    std::optional<TakenBed> taken;
    if (c_.beads.run) {
      taken = take_bed(c_, choice_.step);
      put_in(*taken);
    } else {
      dem_.emplace(setup::make_dem(c_, choice_.step, Ranks::all()));
    }
    log_.line(fmt::format("{} beads on {} ranks", dem_->bead_count(), Ranks::all().size()));
    log_.line(c_.numerics.inertia_scale
                  ? fmt::format("inertia scale {} (given)", *c_.numerics.inertia_scale)
                  : fmt::format("inertia scale 1 (auto): {}", dem::free_inertia_scale().reason));
    log_.line(fmt::format(
        "time step {:.6g} s ({}); shortest contact {:.6g} s; stable in a bed up to about {:.6g} s",
        choice_.step, c_.numerics.step ? "given" : "recommended", choice_.contact_time,
        choice_.stable_in_a_bed));
    outputs_.emplace(c_, folder_, *dem_, nullptr);
    progress_.emplace(0);
    if (taken) {
      as_this_build_writes(taken->file, [&] { outputs_->take_settled(taken->outputs); });
    }
    outputs_->row(*dem_, nullptr, 0);
    if (taken && outputs_->figures().settled_height == 0.0) outputs_->set_settled(*dem_);
    outputs_->stage_end(*dem_, nullptr, 0);
  }

  void put_in(const TakenBed& bed) {
    dem_.emplace(setup::options_of(c_, choice_.step), bed.beads, dem::Dem::Lists::anew,
                 Ranks::all());
    auto words = fmt::format("bed taken from {}", c_.beads.run->string());
    if (bed.plunger && bed.plunger != column::plunger_position(dem_->walls())) {
      column::place_plunger(*bed.plunger, *dem_);
      words += fmt::format(", plunger at {:.4f} mm", 1e3 * *bed.plunger);
    }
    log_.line(words);
  }

  void go_on() {
    const auto saved = read_checkpoint(c_, folder_);
    now_ = saved.state;
    resumed_from_ = saved.file;
    if (now_.stage == stages_) prune_checkpoints(folder_, 1);  // which it was killed before
    timings_ = read_timings(folder_);
    const auto options = setup::options_of(c_, choice_.step);
    if (saved.liquid && options.mesh) options.mesh->set_top(saved.liquid->top);
    dem_.emplace(options, saved.beads, dem::Dem::Lists::as_saved, Ranks::all());
    if (saved.liquid) {
      liquid_ = make_liquid();
      liquid_->load(*saved.liquid, *dem_);
    }
    as_this_build_writes(saved.file, [&] { outputs_.emplace(c_, folder_, *dem_, &now_.outputs); });
    progress_.emplace(dem_->steps());
    for (std::int64_t k = 0; k < now_.stage; ++k) {
      steps_behind_ += expected_steps(c_, k, choice_.step);
    }
    log_.line(fmt::format("resumed at step {}, time {:.6g} s, from {} on {} ranks", dem_->steps(),
                          dem_->time(), saved.file.filename().string(), Ranks::all().size()));
    if (timings_.empty()) {
      log_.line("checkpoints/timings.json is missing: timings count from here on");
    }
  }

  void carry_out_stage() {
    enter_or_leave_liquid();
    if (now_.stage_state.is_null()) {
      now_.bed = {.settled_height = outputs_->figures().settled_height,
                  .height = outputs_->figures().bed.height,
                  .plunger = column::plunger_position(dem_->walls()).value_or(column::lid_away)};
    }
    const auto stage = make_stage(c_, now_.stage, now_.bed, choice_, liquid_.get());
    clock_.emplace(entry_of(timings_, now_.stage + 1, stage->name()), liquid_.get());
    if (now_.stage_state.is_null()) {
      clock_->advance.time([&] { stage->begin(*dem_); });
    } else {
      as_this_build_writes(resumed_from_, [&] { stage->load(now_.stage_state); });
    }
    for (auto after = column::After::goes_on; after != column::After::end;) {
      after = clock_->advance.time([&] { return stage->advance(*dem_); });
      clock_->outputs.time([&] { write_outputs(*stage, after); });
      show_progress(*stage);
      if (after != column::After::end) answer_clock_and_signals(*stage);
    }
    clock_->outputs.time([&] {
      if (stage->name() == "settle") outputs_->set_settled(*dem_);
      outputs_->stage_end(*dem_, liquid_.get(), now_.stage + 1);
    });
    log_.line(fmt::format("stage {}: {}, {}", now_.stage + 1, stage->name(), stage->result(*dem_)));
    judge_inertia(stage->name());
    stage->leave(*dem_);
    now_.stage_state = nullptr;
    checkpoint(now_.stage + 1);
    log_.line(in_words(timings_.back()));
    clock_.reset();
  }

  void write_outputs(const column::Stage& stage, column::After after) {
    if (after != column::After::goes_on) outputs_->row(*dem_, liquid_.get(), now_.stage + 1);
    if (const auto plateau = stage.finished_plateau()) {
      outputs_->plateau(*plateau, *liquid_, now_.stage + 1);
    }
  }

  // Stages without a flow know no liquid but its weight, and move beads with their own inertia.
  void enter_or_leave_liquid() {
    if (has_flow(c_, now_.stage)) {
      if (!liquid_) liquid_ = make_liquid();
      return;
    }
    if (dem_->particles().in_liquid) {
      liquid_.reset();
      dem_->set_in_liquid(false);
    } else if (moves_plunger(c_, now_.stage) || now_.stage == 0 ||
               !moves_plunger(c_, now_.stage - 1)) {
      return;
    }
    dem_->set_inertia_scale(c_.numerics.inertia_scale.value_or(1.0));
    dem_->set_step(choice_.step);
  }

  [[nodiscard]] std::unique_ptr<column::CoupledBed> make_liquid() const {
    return std::unique_ptr<column::CoupledBed>(new column::CoupledBed(
        setup::make_coupled_bed(c_, column::plunger_position(dem_->walls()), Ranks::all())));
  }

  // Whether the beads still move as if their inertia did not count.
  void judge_inertia(std::string_view stage) {
    const double scale = dem_->options().inertia_scale;
    if (scale <= 1.0) return;
    const auto medium = dem_->particles().in_liquid ? dem::BedMedium::liquid : dem::BedMedium::dry;
    const auto warning = dem::inertia_warning(fmt::format("stage {} ({})", now_.stage + 1, stage),
                                              scale, dem_->sums(), medium);
    if (!warning) return;
    log_.line("warning: " + *warning);
    now_.warnings.push_back(*warning);
  }

  void show_progress(const column::Stage& stage) {
    if (!Ranks::all().is_first()) return;
    const double here = expected_steps(c_, now_.stage, choice_.step);
    const auto doing = stage.doing();
    progress_->show(*dem_,
                    {.stage = now_.stage + 1,
                     .stages = stages_,
                     .name = fmt::format("{}{}{}", stage.name(), doing.empty() ? "" : ": ", doing),
                     .share = (steps_behind_ + here * stage.share_done(*dem_)) / total_steps_,
                     .bed_height = outputs_->figures().bed.height});
  }

  // All ranks answer at the same slice: the clock is that of the first one, a signal may reach any.
  void answer_clock_and_signals(const column::Stage& stage) {
    const auto& interval = c_.output.checkpoint_interval;
    const bool due = Ranks::all().is_first() && interval && seconds_since(saved_) >= *interval;
    const double wish = Ranks::all().max(stop_was_asked() ? 2.0 : (due ? 1.0 : 0.0));
    if (wish == 0.0) return;
    now_.stage_state = stage.save();
    const auto file = checkpoint(now_.stage);
    if (wish < 2.0) return;
    progress_->end();
    const auto where = fmt::format("stopped at step {}, time {:.6g} s; checkpoint {}",
                                   dem_->steps(), dem_->time(), file.string());
    log_.line(where);
    throw Stopped(where + "; go on with the same command and --resume");
  }

  std::filesystem::path checkpoint(std::int64_t stage) {
    RunState state = now_;
    state.stage = stage;
    state.outputs = outputs_->save();
    const int keep = stage == stages_ ? 1 : 2;
    auto file = clock_->outputs.time(
        [&] { return write_checkpoint(c_, folder_, *dem_, liquid_.get(), state, keep); });
    saved_ = Clock::now();
    timings_.back() = clock_->now();
    if (Ranks::all().is_first()) write_timings(folder_, timings_);
    return file;
  }

  const setup::Case& c_;
  std::filesystem::path folder_;
  dem::StepChoice choice_;
  std::int64_t stages_;
  double total_steps_;
  double steps_behind_ = 0.0;  ///< of the stages that are over, as expected
  RunLog log_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point saved_ = start_;
  std::optional<dem::Dem> dem_;
  std::unique_ptr<column::CoupledBed> liquid_;  ///< where there is a flow
  std::optional<Outputs> outputs_;
  std::optional<Progress> progress_;
  std::vector<StageTimings>
      timings_;  ///< of stages that are over, and of the present one when last saved
  std::optional<StageClock> clock_;  ///< of the present stage
  RunState now_;
  std::filesystem::path resumed_from_;  ///< the checkpoint, if any
};

}  // namespace

RunSummary simulate(const setup::Case& c, const std::filesystem::path& folder, bool resume) {
  watch_stop_signals();
  Simulation simulation(c, folder, resume);
  simulation.run();
  return simulation.summary();
}

}  // namespace packbed::app
