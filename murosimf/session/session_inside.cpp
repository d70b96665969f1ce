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
  return wishes.finished || (wishes.paused ? wishes.steps == 0 : simulation.now() >= wishes.end);
}

bool Session::Inside::ends() {
  if (simulation.stopped()) return true;
  const std::lock_guard lock(mutex);
  if (wishes.finished) return true;
  return !options.stays && !wishes.paused && simulation.now() >= wishes.end && jobs.empty();
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
  simulation.step();
  timeline.advance(simulation.now());
  note_commands();  // of who posts to the scene itself
  if (timeline.wants_state(simulation.now())) {
    timeline.keep(simulation.now(), scene.save());
    new_state = true;
  }
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

void Session::Inside::note_commands() {
  const std::vector<Command>& all = simulation.commands();
  if (all.size() == noted) return;
  timeline.note(std::span(all).subspan(noted));
  noted = all.size();
}

void Session::Inside::publish(bool paused) {
  const Lateness& late = clock.lateness();
  const std::lock_guard lock(mutex);
  const bool other = std::exchange(new_state, false) || status.branch != timeline.present() || branches.empty();
  status.time = simulation.now();
  status.end = wishes.end;
  status.first = timeline.first();
  status.last = timeline.last();
  status.paused = paused;
  status.speed = wishes.speed;
  status.factor = paused ? 0 : speedometer.factor();
  status.branch = timeline.present();
  status.events = simulation.events().size();
  status.warnings = simulation.warnings().size();
  lateness = {lateness_before.late_steps + late.late_steps, lateness_before.steps + late.steps,
              std::max(lateness_before.worst, late.worst)};
  if (paused || other) branches = timeline.branches();
}

void Session::Inside::has_jumped() {
  noted = simulation.commands().size();
  {
    const std::lock_guard lock(mutex);
    ++status.jumps;
  }
  simulation.publish_poses();
  restart_clock();
}

void Session::Inside::reset(std::optional<std::uint64_t> seed) {
  if (!options.no_way_back.empty()) throw SetupError("no reset: " + options.no_way_back);
  scene.reset(seed);
  timeline.begin(simulation.now(), scene.save());
  has_jumped();
}

void Session::Inside::seek(Duration time, std::optional<int> branch, std::uint64_t number) {
  if (!options.no_way_back.empty()) throw SetupError("no way back in time: " + options.no_way_back);
  if (number != seeks.load()) return;
  const int to = branch.value_or(timeline.present());
  const Timeline::Way way = timeline.way_to(to, time);
  scene.load(*way.state);
  simulation.commands_were(way.before);
  for (const Command& command : way.then) {
    while (simulation.now() < command.time) simulation.step();
    (void)scene.post(command.text);
    simulation.carry_out_commands();
  }
  while (simulation.now() < time && number == seeks.load() && !simulation.stopped()) simulation.step();
  timeline.go_back(to, simulation.now());
  {
    const std::lock_guard lock(mutex);
    wishes.paused = true, wishes.steps = 0;
    status.paused = true;
  }
  has_jumped();
}

void Session::Inside::refuse_all() {
  const std::lock_guard lock(mutex);
  closed = true;
  for (Job& job : jobs) job.done.set_exception(std::make_exception_ptr(SetupError("the run has ended")));
  jobs.clear();
}

}  // namespace murosimf::session
