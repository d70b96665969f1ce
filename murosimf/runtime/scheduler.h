/// scheduler.h - executes the tasks of a list, tick by tick, in waves on several threads, and knows what time it is.
///
/// It owns the plan (plan.h), the jobs that threads make of its waves (lane_jobs.h), the threads, and time. After every change of the
/// list plan() comes before the next tick. Results depend neither on threads nor on lanes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "murosimf/runtime/lane_jobs.h"
#include "murosimf/runtime/plan.h"
#include "murosimf/runtime/pooled_parallel_for.h"
#include "murosimf/runtime/step_checks.h"
#include "murosimf/runtime/task_list.h"
#include "murosimf/runtime/thread_pool.h"
#include "murosimf/world/world.h"

namespace murosimf {

/// An algorithm's place in the order of a tick.
struct PlannedAlgorithm {
  std::size_t wave = 0;  ///< those of one wave run at the same time
  Phase phase{};
  std::string name, entity;
  double rate_hz = 0;
};

class Scheduler {
 public:
  /// World and tasks outlive it. Throws SetupError if the system does not give so many threads.
  Scheduler(const World& world, TaskList& tasks, int threads);

  [[nodiscard]] Duration now() const noexcept { return now_; }
  [[nodiscard]] Duration tick() const noexcept { return plan_.tick(); }
  /// now() in ticks.
  [[nodiscard]] std::int64_t ticks() const noexcept { return ticks_; }

  /// Plans the tasks that are in the list now, from this time on. Throws SetupError, and keeps the plan before, if something that is
  /// read is not written, or if rates do not fit together.
  void plan();
  /// Executes what is due and goes on by one tick.
  void run_tick();
  /// The waves that are due now; until the next plan() they stay where they are.
  [[nodiscard]] const std::vector<Wave>& due_waves() { return plan_.due(ticks_); }
  /// One task, if it is due and its entity not idle.
  void execute(Task& task) noexcept;
  /// Goes on by one tick without executing anything: all that is due has been executed.
  void advance() noexcept;
  /// Between two ticks, to the time of another state. The plan is then that of a simulation which has come there without changes
  /// on the way.
  void jump_to(Duration time);
  /// The same for a time that is only looked at: nothing is planned.
  void look_at(Duration time) noexcept;

  /// Debug builds: the columns are as they should be now, and tasks may change those that they have declared (step_checks.h).
  void restart_checks();

  [[nodiscard]] ThreadPool& pool() noexcept { return pool_; }
  [[nodiscard]] const ThreadPool& pool() const noexcept { return pool_; }
  /// Whether equal robots step together in lanes, from the next tick on.
  void use_lanes(bool use);
  /// How many algorithms do so, of those that have been due so far.
  [[nodiscard]] std::size_t algorithms_in_lanes() const { return lane_jobs_.members_in_groups(); }
  /// The order of a tick in which every algorithm is due: by waves, then by phase and order of attaching.
  [[nodiscard]] std::vector<PlannedAlgorithm> order_of_tick() const;

 private:
  void plan_jobs();
  [[nodiscard]] ThreadAffinity find_homes() const;
  void run_wave(const Wave& wave, const WaveJobs& shared, const WaveJobs& alone);
  void execute(const Job& job) noexcept;
  template <class Step>
  void take_time(std::span<Task* const> tasks, const Step& step) noexcept;

  const World& world_;
  TaskList& tasks_;
  Plan plan_;
  bool planned_ = false;
  Duration planned_at_{};
  Duration now_{};
  std::int64_t ticks_ = 0;
  ThreadPool pool_;
  PooledParallelFor parallel_for_{pool_};
  LaneJobs lane_jobs_, lane_jobs_alone_;  // of the plan: for all threads, and for one
  bool use_lanes_ = true;
  bool alone_in_wave_ = false;  // the task that steps now
  StepChecks checks_;           // used where assertions are checked
};

}  // namespace murosimf
