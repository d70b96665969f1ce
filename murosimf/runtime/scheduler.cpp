#include "murosimf/runtime/scheduler.h"

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/math/floating_point.h"
#include "murosimf/world/access_guard.h"
#include "murosimf/world/foreign_code.h"

namespace murosimf {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr std::int64_t all_timed = 64, timed_every = 8;  // calls

}  // namespace

Scheduler::Scheduler(const World& world, TaskList& tasks, int threads) : world_(world), tasks_(tasks), pool_(threads) {}

void Scheduler::plan() {
  std::vector<NamedAccess> named;
  std::vector<PlannedTask> planned;
  for (const auto& task : tasks_) {
    named.push_back({full_name(*task), &task->access});
    planned.push_back({task->name, &task->access, task->rate, makes_steps(task->algorithm->phase())});
  }
  check_every_read_is_written(named);
  plan_ = Plan(planned, now_);
  planned_ = true;
  plan_jobs();
  MUROSIMF_ASSERT(now_ % plan_.tick() == Duration{} && "a plan has ticks of which the present time is a multiple");
  ticks_ = now_ / plan_.tick();
  planned_at_ = now_;
}

void Scheduler::jump_to(Duration time) {
  now_ = time;
  if (planned_at_ != Duration{} || now_ % plan_.tick() != Duration{}) return plan();
  ticks_ = now_ / plan_.tick();
}

void Scheduler::look_at(Duration time) noexcept {
  now_ = time;
  ticks_ = time / plan_.tick();
}

void Scheduler::run_tick() {
  MUROSIMF_ASSERT(planned_ && now_ == ticks_ * plan_.tick());
  const std::vector<Wave>& waves = due_waves();
  const auto& shared = lane_jobs_.of(waves);
  const auto& alone = pool_.threads() > 1 ? lane_jobs_alone_.of(waves) : shared;
  MUROSIMF_ASSERT(shared.size() == waves.size() && alone.size() == waves.size());
  for (std::size_t i = 0; i < waves.size(); ++i) run_wave(waves[i], shared[i], alone[i]);
  if constexpr (assertions_checked) checks_.after_tick();
  advance();
}

void Scheduler::advance() noexcept {
  now_ += plan_.tick();
  ++ticks_;
}

/// One thread alone makes fuller groups for lanes than each of several can.
void Scheduler::run_wave(const Wave& wave, const WaveJobs& shared, const WaveJobs& alone) {
  if constexpr (assertions_checked) checks_.before_wave(world_, ticks_);
  const std::span<const std::size_t> ends(shared.ends);
  MUROSIMF_ASSERT(ends.size() == static_cast<std::size_t>(pool_.threads()) && ends.back() == shared.jobs.size());
  const auto kind = reinterpret_cast<std::uintptr_t>(&wave);
  alone_in_wave_ = wave.size() == 1;
  if (pool_.shares()) {
    pool_.for_each(ends, kind, [&](std::size_t i) { execute(shared.jobs[i]); });
  } else {
    pool_.alone(ends, kind, [&] {
      for (const Job& job : alone.jobs) execute(job);
    });
  }
  if constexpr (assertions_checked) {
    std::vector<const AccessSet*> access;
    for (const std::size_t task : wave) access.push_back(&tasks_[task].access);
    checks_.after_wave(access);
  }
}

void Scheduler::restart_checks() {
  if constexpr (assertions_checked) {
    std::vector<const AccessSet*> access;
    for (const auto& task : tasks_) access.push_back(&task->access);
    checks_.restart(world_, access);
  }
}

void Scheduler::use_lanes(bool use) {
  use_lanes_ = use;
  if (planned_) plan_jobs();
}

/// Robots of one model at the same level take equally long.
ThreadAffinity Scheduler::find_homes() const {
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

/// A task with steps of its own length is due when the others are not, so it is never in a group. Neither is foreign code, which is
/// called by its caller.
void Scheduler::plan_jobs() {
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

void Scheduler::execute(Task& task) noexcept {
  if (task.idle) return;
  const std::int64_t steps = task.step_ratio ? std::lround(*task.step_ratio) : 1;
  MUROSIMF_ASSERT(steps >= 1);
  const Duration period = steps * task.period;
  if (task.step_ratio && now_ % period != Duration{}) return;
  std::optional<AccessGuard> guard;
  if constexpr (assertions_checked) guard.emplace(task.access);
  Task* const alone = &task;
  const auto step = [&] { task.algorithm->step({now_, period, alone_in_wave_ ? &parallel_for_ : nullptr}); };
  const ForeignCode* const code = ForeignCode::of(*task.algorithm);
  take_time({&alone, 1}, [&] { code ? code->caller(*code, full_name(task), step) : step(); });
}

void Scheduler::execute(const Job& job) noexcept {
  if (!job.lanes) return execute(tasks_[job.algorithms.front()]);
  MUROSIMF_ASSERT(job.algorithms.size() <= Pack8::lanes);
  std::array<Task*, Pack8::lanes> due{};
  std::size_t count = 0;
  LaneMask lanes = 0;
  for (std::size_t i = 0; i < job.algorithms.size(); ++i) {
    Task& task = tasks_[job.algorithms[i]];
    if (task.idle) continue;
    MUROSIMF_ASSERT(!task.step_ratio && (count == 0 || task.period == due[0]->period));
    due[count++] = &task;
    lanes |= lane_bit(static_cast<int>(i));
  }
  if (count == 0) return;
  take_time({due.data(), count}, [&] { job.lanes->step(lanes, {now_, due[0]->period}); });
}

/// Executes a step of these tasks, and shares its time out among them.
template <class Step>
void Scheduler::take_time(std::span<Task* const> tasks, const Step& step) noexcept {
  const KeptFloatingPoint modes;  // the algorithm may be foreign code
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

std::vector<PlannedAlgorithm> Scheduler::order_of_tick() const {
  std::vector<PlannedAlgorithm> order;
  const std::vector<Wave> waves = plan_.all();
  for (std::size_t i = 0; i < waves.size(); ++i) {
    for (const std::size_t number : waves[i]) {
      const Task& task = tasks_[number];
      order.push_back({i, task.algorithm->phase(), task.name, task.entity->name(), task.rate.hz});
    }
  }
  return order;
}

}  // namespace murosimf
