#include "deploy/tacit/one_process_run.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <optional>

#include "console/record/record_error.h"
#include "console/record/run_recorder.h"
#include "console/record/run_store.h"
#include "console/report/metrics_table.h"
#include "deploy/lockstep/team.h"
#include "deploy/tacit/one_process_tape.h"
#include "deploy/tacit/profile.h"
#include "deploy/tacit/progress_line.h"

namespace tacit {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds kGlance(20);
constexpr std::chrono::milliseconds kKeeping(500);

/// A run in this process, from its first tick to its last or to an early end.
class Run {
 public:
  Run(const RunPlan& plan, const RunDirectory& directory, Signals& signals)
      : plan_(plan),
        signals_(signals),
        team_(plan.setup.world, plan.setup.brain, seed(plan.setup)),
        recorder_(directory, plan.wish.trajectories ? RunRecorder::Trajectories::On
                                                    : RunRecorder::Trajectories::Off),
        line_(plan.wish.quiet ? ProgressLine::Style::Silent : ProgressLine::Style::Live),
        learned_(learned_folder(plan, directory)) {
    if (!plan.tape.empty()) {
      tape_.emplace(plan.tape, directory, last_tick(plan.setup));
    }
    if (!plan.policies.empty()) {
      team_.inherit(plan.policies);
    }
    if (plan.wish.profile) {
      profile_.emplace(team_);
    }
  }

  Ending make() {
    try {
      make_ticks();
    } catch (const RecordError& error) {
      fail(error);
    }
    line_.show(progress());
    line_.finish();
    return finish();
  }

 private:
  void make_ticks() {
    while (!team_.done(last_tick(plan_.setup)) && !early_end()) {
      take(team_.step());
      record_view();
      keep_pace();
    }
    if (!early_) {
      const Event ending = team_.ending();
      take({&ending, 1});
      if (tape_) tape_->look(team_, recorder_.events());
    }
  }

  void take(std::span<const Event> events) {
    const std::uint64_t first = recorder_.events();
    recorder_.add(events);
    if (tape_) tape_->add(first, events);
  }

  void record_view() {
    if (plan_.wish.trajectories) {
      team_.world().view(view_);
      recorder_.add(view_);
    }
    if (tape_ && !team_.done(last_tick(plan_.setup))) tape_->look(team_, recorder_.events());
  }

  /// Looks at signals, the time and the progress line, a few times a second.
  bool early_end() {
    const Clock::time_point now = Clock::now();
    if (now < next_glance_) {
      return false;
    }
    next_glance_ = now + kGlance;
    keep_lessons_sometimes(now);
    signals_.wait(std::chrono::milliseconds(0));
    line_.show_sometimes([this] { return progress(); });
    if (signals_.end_wanted()) {
      early_ = Ending{Exit::Interrupted, "interrupted"};
    } else if (plan_.wish.timeout_s > 0 && elapsed_s() > plan_.wish.timeout_s) {
      early_ = Ending{Exit::TimedOut, "the time is out"};
    }
    return early_.has_value();
  }

  void keep_lessons_sometimes(Clock::time_point now) {
    if (now >= next_keeping_) {
      next_keeping_ = now + kKeeping;
      keep_lessons();
    }
  }

  void keep_lessons() {
    if (learned_ && team_.tick() > 0) {
      learned_->save(team_.policies());
    }
  }

  void keep_pace() {
    if (plan_.wish.speed <= 0) {
      return;
    }
    const double due_s =
        static_cast<double>(team_.tick()) * plan_.setup.world.physics.tick_s / plan_.wish.speed;
    while (elapsed_s() < due_s && !signals_.end_wanted()) {
      const Seconds left(std::min(due_s - elapsed_s(), 1.0));
      signals_.wait(std::chrono::ceil<std::chrono::milliseconds>(left));
    }
  }

  Ending finish() {
    const double wall_s = elapsed_s();
    try {
      keep_lessons();
      const RunOutcome outcome = recorder_.finish(wall_s, early_ ? early_->because : "");
      RunStore(plan_.store).add(recorder_.row(outcome));
      if (tape_) tape_->finish(outcome);
    } catch (const RecordError& error) {
      fail(error);
    }
    if (!plan_.wish.quiet) {
      std::cerr << to_text(metrics_table(recorder_.tally())) << std::flush;
    }
    if (profile_) {
      std::cerr << to_text(profile_->table()) << std::flush;
    }
    return early_.value_or(Ending{});
  }

  /// The first reason for an early end is the one to tell.
  void fail(const RecordError& error) {
    if (!early_) {
      early_ = Ending{Exit::Unforeseen, error.what()};
    }
  }

  [[nodiscard]] Progress progress() const {
    return {team_.tick(), last_tick(plan_.setup), plan_.setup.world.physics.tick_s,
            static_cast<double>(team_.tick()) / elapsed_s(), standing()};
  }

  [[nodiscard]] std::string standing() const {
    std::map<RobotId, std::string> doings;
    Telemetry telemetry;
    for (const Brain& brain : team_.brains()) {
      brain.report(telemetry);
      doings[telemetry.robot] = doing(telemetry);
    }
    return standing_text(recorder_.tally(), plan_.setup.world.robots.count, doings_text(doings));
  }

  [[nodiscard]] double elapsed_s() const { return Seconds(Clock::now() - begin_).count(); }

  const RunPlan& plan_;
  Signals& signals_;
  Team team_;
  RunRecorder recorder_;
  ProgressLine line_;
  WorldView view_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_glance_ = begin_;
  Clock::time_point next_keeping_ = begin_ + kKeeping;
  std::optional<PolicyFolder> learned_;
  std::optional<Profile> profile_;
  std::optional<OneProcessTape> tape_;
  std::optional<Ending> early_;
};

}  // namespace

Ending run_in_one_process(const RunPlan& plan, const RunDirectory& directory, Signals& signals) {
  return Run(plan, directory, signals).make();
}

}  // namespace tacit
