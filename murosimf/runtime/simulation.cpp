#include "murosimf/runtime/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "murosimf/math/floating_point.h"
#include "murosimf/model/access_guard.h"
#include "murosimf/model/foreign_code.h"
#include "murosimf/model/properties.h"

namespace murosimf {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr std::int64_t all_timed = 64, timed_every = 8;  // calls

/// Motion, and what works on its steps.
bool makes_steps(Phase phase) {
  return phase == Phase::contact || phase == Phase::interaction || phase == Phase::motion;
}

#ifdef NDEBUG
constexpr bool checked = false;
#else
constexpr bool checked = true;
#endif

}  // namespace

Simulation::Simulation(int threads) : world_(std::make_unique<World>()), pool_(threads) {}

Simulation::~Simulation() = default;

void Simulation::add_in_order(std::unique_ptr<Task> task) {
  const auto later = [&](Phase phase, const auto& other) { return phase < other->algorithm->phase(); };
  tasks_.insert(std::upper_bound(tasks_.begin(), tasks_.end(), task->algorithm->phase(), later), std::move(task));
}

auto Simulation::task_of_level(const Entity& entity) -> std::vector<std::unique_ptr<Task>>::iterator {
  return std::find_if(tasks_.begin(), tasks_.end(),
                      [&](const auto& task) { return task->level && task->entity == &entity; });
}

const MotionLevel* Simulation::level_of(const Entity& entity) const {
  for (const auto& task : tasks_) {
    if (task->level && task->entity == &entity) return task->level;
  }
  return nullptr;
}

void Simulation::at(Duration time, std::function<void()> call) {
  auto& calls = initialized_ ? timed_calls_ : schedule_;
  const auto later = [&](const TimedCall& other) { return other.time > time; };
  calls.insert(std::find_if(calls.begin(), calls.end(), later), {time, std::move(call)});
}

void Simulation::make_timed_calls() {
  const auto due = [&](const std::vector<TimedCall>& calls, std::size_t next) {
    return next < calls.size() && calls[next].time <= now_;
  };
  for (;;) {
    const bool scheduled = due(schedule_, scheduled_done_), other = due(timed_calls_, 0);
    if (!scheduled && !other) return;
    if (scheduled && !(other && timed_calls_[0].time < schedule_[scheduled_done_].time)) {
      make(schedule_[scheduled_done_++]);
    } else {
      const TimedCall call = std::move(timed_calls_.front());
      timed_calls_.erase(timed_calls_.begin());  // first: the call may add others
      make(call);
    }
  }
}

void Simulation::make(const TimedCall& timed) {
  const KeptFloatingPoint modes;  // the call is the user's
  try {
    timed.call();
  } catch (const SetupError& error) {
    warnings_.push_back(fmt::format("at {:.3f} s: {}", seconds(now_), error.what()));
  }
}

void Simulation::run(Duration duration, Pacer& pacer, const std::function<void(Duration)>& progress) {
  if (duration < Duration{}) throw SetupError(fmt::format("duration {} s is negative", seconds(duration)));
  initialize();
  pacer.start(now_);
  auto next_report = WallClock::now();
  for (const Duration end = now_ + duration; now_ < end && !stopped();) {
    pacer.before_step(now_, stop_);
    if (stopped()) return;
    step();
    pacer.after_step(now_, stop_);
    if (progress && (ticks_ % 64 == 0 || now_ >= end) && (WallClock::now() >= next_report || now_ >= end)) {
      progress(now_);
      next_report = WallClock::now() + std::chrono::milliseconds(100);
    }
  }
}

void Simulation::run(Duration duration) {
  Pacer as_fast_as_possible;
  run(duration, as_fast_as_possible);
}

void Simulation::step() {
  const StandardFloatingPoint modes;
  initialize();
  make_timed_calls();
  queue_.carry_out(now_);
  take_over_frozen();
  const std::vector<Wave>& waves = plan_.due(ticks_);
  const auto& shared = lane_jobs_.of(waves);
  const auto& alone = pool_.threads() > 1 ? lane_jobs_alone_.of(waves) : shared;
  for (std::size_t i = 0; i < waves.size(); ++i) run_wave(waves[i], shared[i], alone[i]);
  if constexpr (checked) checks_.after_tick();
  now_ += plan_.tick();
  ++ticks_;
  take_over_frozen();
  poses_.publish(*world_, now_, ticks_);
}

void Simulation::carry_out_commands() {
  initialize();
  make_timed_calls();
  if (queue_.carry_out(now_)) publish_poses();
}

void Simulation::show_past(Duration time, std::span<const Event> events, std::span<const std::string> warnings) {
  initialize();
  now_ = time;
  ticks_ = time / plan_.tick();
  events_.assign(events.begin(), events.end());
  warnings_.assign(warnings.begin(), warnings.end());
  poses_.publish(*world_, now_, ticks_);
}

/// One thread alone makes fuller groups for lanes than each of several can.
void Simulation::run_wave(const Wave& wave, const WaveJobs& shared, const WaveJobs& alone) {
  if constexpr (checked) checks_.before_wave(*world_, ticks_);
  const std::span<const std::size_t> ends(shared.ends);
  const auto kind = reinterpret_cast<std::uintptr_t>(&wave);
  alone_in_wave_ = wave.size() == 1;
  if (pool_.shares()) {
    pool_.for_each(ends, kind, [&](std::size_t i) { execute(shared.jobs[i]); });
  } else {
    pool_.alone(ends, kind, [&] {
      for (const Job& job : alone.jobs) execute(job);
    });
  }
  if constexpr (checked) {
    std::vector<const AccessSet*> access;
    for (const std::size_t task : wave) access.push_back(&tasks_[task]->access);
    checks_.after_wave(access);
  }
}

void Simulation::restart_checks() {
  if constexpr (checked) {
    std::vector<const AccessSet*> access;
    for (const auto& task : tasks_) access.push_back(&task->access);
    checks_.restart(*world_, access);
  }
}

void Simulation::check_and_plan() {
  std::vector<NamedAccess> named;
  std::vector<PlannedTask> planned;
  for (const auto& task : tasks_) {
    named.push_back({full_name(*task), &task->access});
    planned.push_back({task->name, &task->access, task->rate, makes_steps(task->algorithm->phase())});
  }
  check_every_read_is_written(named);
  plan_ = Plan(planned, now_);
  plan_jobs();
  ticks_ = now_ / plan_.tick();
  planned_at_ = now_;
}

/// After time has jumped: the plan is that of a simulation which has come here without changes on the way.
void Simulation::align_plan() {
  if (planned_at_ != Duration{} || now_ % plan_.tick() != Duration{}) return check_and_plan();
  ticks_ = now_ / plan_.tick();
}

std::unique_ptr<Simulation::Task> Simulation::new_task(std::string name, const Entity& entity, const Rate& rate) const {
  if (!(rate.hz >= slowest_rate && rate.hz <= fastest_rate)) {
    throw SetupError(
        fmt::format("the rate of '{}', {} Hz, is not between {} and {} Hz", name, rate.hz, slowest_rate, fastest_rate));
  }
  if (!(rate.phase >= 0 && rate.phase < 1)) {
    throw SetupError(fmt::format("the phase of '{}', {}, is not from 0 to below 1", name, rate.phase));
  }
  auto task = std::make_unique<Task>();
  task->name = std::move(name);
  task->entity = &entity;
  task->rate = rate;
  task->period = rate.period();
  return task;
}

/// What moves the entity reads how long its steps are.
void Simulation::follow_step_multiple(Task& task, Setup& setup) {
  const int step_multiple = setup.entity().options().step_multiple;
  if (step_multiple > 1 && makes_steps(task.algorithm->phase())) {
    task.step_ratio = setup.input(properties::step_ratio, step_multiple).data();
  }
}

std::string Simulation::full_name(const Task& task) { return fmt::format("{} of {}", task.name, task.entity->name()); }

void Simulation::use_lanes(bool use) {
  use_lanes_ = use;
  if (initialized_) plan_jobs();
}

/// Robots of one model at the same level take equally long.
ThreadAffinity Simulation::find_homes() const {
  std::map<std::pair<const Model*, std::string_view>, std::vector<const Entity*>> alike;
  std::vector<const std::vector<const Entity*>*> in_order;  // of attaching: pointers have none that is always the same
  for (const auto& task : tasks_) {
    if (!task->level) continue;
    auto& entities = alike[{&task->entity->model(), task->name}];
    if (entities.empty()) in_order.push_back(&entities);
    entities.push_back(task->entity);
  }
  ThreadAffinity thread_affinity(static_cast<std::size_t>(pool_.threads()));
  for (const auto* entities : in_order) thread_affinity.share_out(*entities);
  return thread_affinity;
}

/// Who makes steps of its own length is due when the others are not.
void Simulation::plan_jobs() {
  parallel_for_.use(find_homes());
  std::vector<LaneJobs::Member> members;
  for (const auto& task : tasks_) {
    const bool alone = !use_lanes_ || task->step_ratio || ForeignCode::of(*task->algorithm);
    members.push_back(
        {alone ? nullptr : task->algorithm.get(), task->period, parallel_for_.thread_affinity().of(*task->entity)});
  }
  std::vector<LaneJobs::Member> at_one_home = members;
  for (LaneJobs::Member& member : at_one_home) member.home = 0;
  lane_jobs_alone_ = {std::move(at_one_home), 1};
  lane_jobs_ = {std::move(members), pool_.threads()};
}

void Simulation::execute(Task& task) noexcept {
  if (task.idle) return;
  const std::int64_t steps = task.step_ratio ? std::lround(*task.step_ratio) : 1;
  const Duration period = steps * task.period;
  if (task.step_ratio && now_ % period != Duration{}) return;
#ifndef NDEBUG
  const AccessGuard guard(task.access);
#endif
  Task* const alone = &task;
  const auto step = [&] { task.algorithm->step({now_, period, alone_in_wave_ ? &parallel_for_ : nullptr}); };
  const ForeignCode* const code = ForeignCode::of(*task.algorithm);
  take_time({&alone, 1}, [&] { code ? code->caller(*code, full_name(task), step) : step(); });
}

void Simulation::execute(const Job& job) noexcept {
  if (!job.lanes) return execute(*tasks_[job.algorithms.front()]);
  std::array<Task*, Pack8::lanes> due{};
  std::size_t count = 0;
  LaneMask lanes = 0;
  for (std::size_t i = 0; i < job.algorithms.size(); ++i) {
    Task& task = *tasks_[job.algorithms[i]];
    if (task.idle) continue;
    due[count++] = &task;
    lanes |= lane_bit(static_cast<int>(i));
  }
  if (count == 0) return;
  take_time({due.data(), count}, [&] { job.lanes->step(lanes, {now_, due[0]->period}); });
}

/// Executes a step of these tasks, and shares its time out among them.
template <class Step>
void Simulation::take_time(std::span<Task* const> tasks, const Step& step) noexcept {
  const KeptFloatingPoint modes;  // the algorithm may be somebody else's
  const std::int64_t call = tasks.front()->calls;
  for (Task* task : tasks) ++task->calls;
  if (call >= all_timed && call % timed_every != 0) return step();
  const auto start = WallClock::now();
  step();
  const std::int64_t stands_for = call < all_timed ? 1 : timed_every;  // the first call is dear, and happens once
  const auto time = stands_for * (WallClock::now() - start) / static_cast<std::int64_t>(tasks.size());
  for (Task* task : tasks) {
    task->time += time;
    task->timed_calls += stands_for;
  }
}

void Simulation::take_over_idle() {
  for (const auto& task : tasks_) task->idle = task->entity->idle();
}

void Simulation::take_over_frozen() {
  const auto& entities = world_->entities();
  const auto frozen = [](const auto& entity) { return entity->frozen(); };
  const auto count = static_cast<std::size_t>(std::count_if(entities.begin(), entities.end(), frozen));
  if (count == frozen_reported_) return;
  frozen_reported_ = count;
  take_over_idle();
  for (const auto& entity : entities) {
    const std::string beginning = fmt::format("'{}' was frozen", entity->name());
    const auto said = [&](const std::string& warning) { return warning.starts_with(beginning); };
    if (!entity->frozen() || std::any_of(warnings_.begin(), warnings_.end(), said)) continue;
    warnings_.push_back(fmt::format("{} at {:.3f} s: {}", beginning, seconds(now_), *entity->frozen_reason()));
  }
}

}  // namespace murosimf
