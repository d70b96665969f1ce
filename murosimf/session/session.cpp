#include "murosimf/session/session.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/session/speedometer.h"

namespace murosimf::session {
namespace {

constexpr Duration never = Duration::max();
constexpr Duration patience =
    std::chrono::milliseconds(20);  // until a stop of the simulation is seen while it is paused
constexpr Duration between_reports = std::chrono::milliseconds(100);

}  // namespace

struct Session::Inside {
  /// Something that somebody waits for.
  struct Job {
    std::function<void()> call;
    std::promise<void> done;
  };

  Inside(scene::Scene& which, const SessionOptions& given)
      : scene(which), simulation(which.simulation()), options(given), clock(given.speed), timeline(given.timeline) {
    wishes.paused = given.paused;
    wishes.speed = given.speed;
    clock.tell_of_overruns(given.tell_of_overruns);
  }

  // ---- of the thread that runs it ----

  void run(const std::function<void(Duration)>& progress);
  void step();
  void wait();
  [[nodiscard]] bool stands() const;
  [[nodiscard]] bool ends();
  void attend();
  void restart_clock();
  void note_commands();
  void publish(bool paused);
  void reset(std::optional<std::uint64_t> seed);
  void seek(Duration time, std::optional<int> branch, std::uint64_t number);
  void has_jumped();
  void refuse_all();

  // ---- of any thread ----

  std::future<void> ask(std::function<void()> call);
  template <class Change>
  void wish(const Change& change);

  scene::Scene& scene;
  Simulation& simulation;
  const SessionOptions options;
  Clock clock;
  Timeline timeline;
  Lateness lateness_before;  // of clocks before this one
  Speedometer speedometer;
  std::size_t noted = 0;   // commands
  bool new_state = false;  // of the timeline, that others have not been told of

  mutable std::mutex mutex;  // of what follows
  std::condition_variable changed;
  struct Wishes {
    bool paused = false, finished = false, new_speed = false;
    std::optional<double> speed;
    Duration end{};
    std::int64_t steps = 0;  // to be made although it is paused
  } wishes;
  bool closed = false;  // nobody runs it any more
  std::deque<Job> jobs;
  SessionStatus status;
  std::vector<BranchView> branches;
  Lateness lateness;
  std::atomic<bool> attention{false};  // somebody wants something
  std::atomic<std::uint64_t> seeks{0};
};

// ---- any thread ----

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

template <class Change>
void Session::Inside::wish(const Change& change) {
  const std::lock_guard lock(mutex);
  change(wishes);
  attention.store(true);
  changed.notify_all();
}

Session::Session(scene::Scene& scene, const SessionOptions& options)
    : inside_(std::make_unique<Inside>(scene, options)) {
  inside_->simulation.initialize();
  inside_->timeline.begin(inside_->simulation.now(), scene.save());
  inside_->noted = inside_->simulation.commands().size();
  inside_->publish(options.paused);
}

Session::~Session() = default;

void Session::pause() {
  inside_->wish([](Inside::Wishes& wishes) { wishes.paused = true, wishes.steps = 0; });
}

void Session::go_on() {
  const Duration now = status().time;
  inside_->wish([now](Inside::Wishes& wishes) {
    wishes.paused = false, wishes.steps = 0;
    if (wishes.end <= now) wishes.end = never;
  });
}

void Session::step(std::int64_t steps) {
  inside_->wish(
      [steps](Inside::Wishes& wishes) { wishes.paused = true, wishes.steps += std::max<std::int64_t>(0, steps); });
}

void Session::set_speed(std::optional<double> speed) {
  (void)Clock(speed);  // throws
  inside_->wish([speed](Inside::Wishes& wishes) { wishes.speed = speed, wishes.new_speed = true; });
}

void Session::run_until(Duration end) {
  inside_->wish([end](Inside::Wishes& wishes) { wishes.end = end; });
}

void Session::finish() {
  inside_->wish([](Inside::Wishes& wishes) { wishes.finished = true; });
}

std::future<void> Session::change(std::string text) {
  return inside_->ask([inside = inside_.get(), text = std::move(text)] {
    std::future<void> done = inside->scene.post(text);
    inside->simulation.carry_out_commands();
    inside->note_commands();
    done.get();
  });
}

std::future<void> Session::reset(std::optional<std::uint64_t> seed) {
  return inside_->ask([inside = inside_.get(), seed] { inside->reset(seed); });
}

std::future<void> Session::seek(Duration time, std::optional<int> branch) {
  const std::uint64_t number = ++inside_->seeks;
  return inside_->ask([inside = inside_.get(), time, branch, number] { inside->seek(time, branch, number); });
}

std::future<void> Session::visit(std::function<void(scene::Scene&)> call) {
  return inside_->ask([inside = inside_.get(), call = std::move(call)] { call(inside->scene); });
}

SessionStatus Session::status() const {
  const std::lock_guard lock(inside_->mutex);
  return inside_->status;
}

std::vector<BranchView> Session::branches() const {
  const std::lock_guard lock(inside_->mutex);
  return inside_->branches;
}

Lateness Session::lateness() const {
  const std::lock_guard lock(inside_->mutex);
  return inside_->lateness;
}

// ---- the thread that runs it ----

void Session::run(Duration end, const std::function<void(Duration)>& progress) {
  run_until(end);
  inside_->run(progress);
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
