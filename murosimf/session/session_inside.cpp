#include "murosimf/session/session_inside.h"

#include <algorithm>
#include <utility>

#include "murosimf/model/error.h"

namespace murosimf::session {
namespace {

constexpr Duration patience =
    std::chrono::milliseconds(20);  // until a stop of the simulation is seen while it is paused
constexpr Duration between_reports = std::chrono::milliseconds(100);

}  // namespace

std::future<void> Session::Inside::ask(std::function<void()> call) {
  Job job{std::move(call), {}};
  std::future<void> done = job.done.get_future();
  const std::lock_guard lock(mutex);
  if (closed) {
    job.done.set_exception(std::make_exception_ptr(SetupError("the run has ended")));
    return done;
  }
  jobs.push_back(std::move(job));
  attention.store(true);
  changed.notify_all();
  return done;
}

void Session::Inside::run(const std::function<void(Duration)>& progress) {
  restart_clock();
  auto next_report = std::chrono::steady_clock::now();
  while (!ends()) {
    if (attention.exchange(false)) attend();
    if (stands()) {
      wait();
      continue;
    }
    step();
    if (!progress || std::chrono::steady_clock::now() < next_report) continue;
    progress(simulation.now());
    next_report = std::chrono::steady_clock::now() + between_reports;
  }
  publish(true);
  refuse_all();
}

/// Whether no step is to be made now.
bool Session::Inside::stands() const {
  const std::lock_guard lock(mutex);
  if (wishes.finished || course->at_end()) return true;
  return wishes.paused ? wishes.steps == 0 : simulation.now() >= wishes.end;
}

bool Session::Inside::ends() {
  if (simulation.stopped()) return true;
  const std::lock_guard lock(mutex);
  if (wishes.finished) return true;
  const bool done = simulation.now() >= wishes.end || course->at_end();
  return !options.stays && !wishes.paused && done && jobs.empty();
}

/// Until somebody wants something.
void Session::Inside::wait() {
  publish(true);
  std::unique_lock lock(mutex);
  while (!attention.load() && !simulation.stopped()) changed.wait_for(lock, patience);
  lock.unlock();
  restart_clock();
}

void Session::Inside::restart_clock() {
  clock.start(simulation.now());
  speedometer.restart(simulation.now());
}

void Session::Inside::step() {
  course->step();
  speedometer.advance(simulation.now());
  {
    const std::lock_guard lock(mutex);
    if (wishes.paused && wishes.steps > 0) --wishes.steps;
  }
  publish(false);
  const auto wakes = [&] { return attention.load() || simulation.stopped(); };
  clock.wait_until(simulation.now(), wakes);
  while (attention.exchange(false)) {
    attend();
    if (stands()) return;
    clock.wait_on(simulation.now(), wakes);
  }
}

/// Does what others have asked for.
void Session::Inside::attend() {
  std::deque<Job> all;
  {
    const std::lock_guard lock(mutex);
    all.swap(jobs);
    if (std::exchange(wishes.new_speed, false)) {
      const Lateness& late = clock.lateness();
      lateness_before.late_steps += late.late_steps;
      lateness_before.steps += late.steps;
      lateness_before.worst = std::max(lateness_before.worst, late.worst);
      clock = Clock(wishes.speed);
      clock.tell_of_overruns(options.tell_of_overruns);
      clock.start(simulation.now());
      status.speed = wishes.speed;
    }
  }
  for (Job& job : all) {
    try {
      job.call();
      publish(status.paused);
      job.done.set_value();
    } catch (...) {
      publish(status.paused);
      job.done.set_exception(std::current_exception());
    }
  }
}

void Session::Inside::publish(bool paused) {
  const Lateness& late = clock.lateness();
  const std::lock_guard lock(mutex);
  const bool other = course->has_grown();
  status.time = simulation.now();
  status.end = wishes.end;
  status.first = course->first();
  status.last = course->last();
  status.paused = paused;
  status.at_end = course->at_end();
  status.speed = wishes.speed;
  status.factor = paused ? 0 : speedometer.factor();
  status.branch = course->branch();
  status.remark = course->remark();
  status.events = simulation.events().size();
  status.warnings = simulation.warnings().size();
  lateness = {lateness_before.late_steps + late.late_steps, lateness_before.steps + late.steps,
              std::max(lateness_before.worst, late.worst)};
  if (paused || other) branches = course->branches();
}

void Session::Inside::has_jumped() {
  {
    const std::lock_guard lock(mutex);
    ++status.jumps;
  }
  simulation.publish_poses();
  restart_clock();
}

void Session::Inside::reset(std::optional<std::uint64_t> seed) {
  course->reset(seed);
  has_jumped();
}

void Session::Inside::seek(Duration time, std::optional<int> branch, std::uint64_t number) {
  if (number != seeks.load()) return;
  course->seek(time, branch, [&] { return number != seeks.load() || simulation.stopped(); });
  pause_here();
  has_jumped();
}

void Session::Inside::load(const std::function<void(scene::Scene&)>& load) {
  course->load(load);
  pause_here();
  has_jumped();
}

void Session::Inside::pause_here() {
  const std::lock_guard lock(mutex);
  wishes.paused = true, wishes.steps = 0;
  status.paused = true;
}

void Session::Inside::record(bool on) {
  if (!options.record)
    throw SetupError("this run was begun without a recording that others switch (--record FILE --record-on asked)");
  options.record(on);
  const std::lock_guard lock(mutex);
  status.recorded = on;
}

void Session::Inside::refuse_all() {
  const std::lock_guard lock(mutex);
  closed = true;
  for (Job& job : jobs) job.done.set_exception(std::make_exception_ptr(SetupError("the run has ended")));
  jobs.clear();
}

}  // namespace murosimf::session
