#include "murosimf/session/session_inside.h"

#include <algorithm>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::session {
namespace {

constexpr Duration patience = std::chrono::milliseconds(20);  // polling period of a stop while paused
constexpr Duration between_reports = std::chrono::milliseconds(100);

}  // namespace

/// Calls run in the thread of the run, between two steps; after its end they fail at once, since no step would come any more.
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

/// Until the end, whether the simulation advances or is paused; requests of other threads come between two steps.
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
  // Callers in other threads would wait forever for what is no longer done.
  refuse_all();
}

/// Whether no step is due at present.
bool Session::Inside::stands() const {
  const std::lock_guard lock(mutex);
  if (requests.finished || source->at_end()) return true;
  return requests.paused ? requests.steps == 0 : simulation.now() >= requests.end;
}

/// A session that stays waits at its end for a jump back in time.
bool Session::Inside::ends() {
  if (simulation.stopped()) return true;
  const std::lock_guard lock(mutex);
  if (requests.finished) return true;
  const bool done = simulation.now() >= requests.end || source->at_end();
  return !options.stays && !requests.paused && done && jobs.empty();
}

/// Waits for a request.
void Session::Inside::wait() {
  publish(true);
  std::unique_lock lock(mutex);
  while (!attention.load() && !simulation.stopped()) changed.wait_for(lock, patience);
  lock.unlock();
  // the pause must not count as delay
  restart_clock();
}

void Session::Inside::restart_clock() {
  clock.start(simulation.now());
  speedometer.restart(simulation.now());
}

void Session::Inside::step() {
  source->step();
  speedometer.advance(simulation.now());
  {
    const std::lock_guard lock(mutex);
    if (requests.paused && requests.steps > 0) --requests.steps;
  }
  publish(false);
  const auto wakes = [&] { return attention.load() || simulation.stopped(); };
  clock.wait_until(simulation.now(), wakes);
  // a request may arrive while the clock waits: served at once, then the clock continues to wait
  while (attention.exchange(false)) {
    attend();
    if (stands()) return;
    clock.wait_on(simulation.now(), wakes);
  }
}

/// Executes the requests of other threads.
void Session::Inside::attend() {
  std::deque<Job> all;
  {
    const std::lock_guard lock(mutex);
    all.swap(jobs);
    if (std::exchange(requests.new_speed, false)) {
      const Lateness& late = clock.lateness();
      lateness_before.late_steps += late.late_steps;
      lateness_before.steps += late.steps;
      lateness_before.worst = std::max(lateness_before.worst, late.worst);
      clock = Clock(requests.speed);
      clock.publish_overruns(options.publish_overruns);
      clock.start(simulation.now());
      status.speed = requests.speed;
    }
  }
  for (Job& job : all) {
    MUROSIMF_ASSERT(job.call != nullptr);
    try {
      job.call();
      // published before the future is ready: a caller that waits for it sees the new status
      publish(status.paused);
      job.done.set_value();
    } catch (...) {
      publish(status.paused);
      job.done.set_exception(std::current_exception());
    }
  }
}

/// Under the mutex: other threads read the status at any time.
void Session::Inside::publish(bool paused) {
  const Lateness& late = clock.lateness();
  const std::lock_guard lock(mutex);
  const bool other = source->has_grown();
  status.time = simulation.now();
  status.end = requests.end;
  status.first = source->first();
  status.last = source->last();
  status.paused = paused;
  status.at_end = source->at_end();
  status.speed = requests.speed;
  status.factor = paused ? 0 : speedometer.factor();
  status.branch = source->branch();
  status.diagnostic = source->diagnostic();
  status.events = simulation.events().size();
  status.warnings = simulation.warnings().size();
  lateness = {lateness_before.late_steps + late.late_steps, lateness_before.steps + late.steps,
              std::max(lateness_before.worst, late.worst)};
  if (paused || other) branches = source->branches();
}

/// After a jump in time, the clock must not try to catch up.
void Session::Inside::has_jumped() {
  {
    const std::lock_guard lock(mutex);
    ++status.jumps;
  }
  simulation.publish_poses();
  restart_clock();
}

void Session::Inside::reset(std::optional<std::uint64_t> seed) {
  source->reset(seed);
  has_jumped();
}

void Session::Inside::seek(Duration time, std::optional<int> branch, std::uint64_t number) {
  if (number != seeks.load()) return;
  source->seek(time, branch, [&] { return number != seeks.load() || simulation.stopped(); });
  pause_here();
  has_jumped();
}

void Session::Inside::load(const std::function<void(scene::Scene&)>& load) {
  source->load(load);
  pause_here();
  has_jumped();
}

void Session::Inside::pause_here() {
  const std::lock_guard lock(mutex);
  requests.paused = true, requests.steps = 0;
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
