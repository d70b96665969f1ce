/// session_inside.h - the data of a session, and the loop of the thread that runs it. Only for session.cpp.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "murosimf/session/session.h"
#include "murosimf/session/speedometer.h"

namespace murosimf::session {

struct Session::Inside {
  /// A request with its promise.
  struct Job {
    std::function<void()> call;
    std::promise<void> done;
  };

  Inside(std::unique_ptr<PlaybackSource> given_course, const SessionOptions& given)
      : source(std::move(given_course)),
        scene(source->scene()),
        simulation(scene.simulation()),
        options(given),
        clock(given.speed) {
    requests.paused = given.paused;
    if (given.record) status.recorded = false;
    requests.speed = given.speed;
    clock.publish_overruns(given.publish_overruns);
  }

  // ---- of the thread that runs it ----

  void run(const std::function<void(Duration)>& progress);
  void step();
  void wait();
  [[nodiscard]] bool stands() const;
  [[nodiscard]] bool ends();
  void attend();
  void restart_clock();
  void publish(bool paused);
  void reset(std::optional<std::uint64_t> seed);
  void seek(Duration time, std::optional<int> branch, std::uint64_t number);
  void load(const std::function<void(scene::Scene&)>& load);
  void record(bool on);
  void has_jumped();
  void pause_here();
  void refuse_all();

  // ---- of any thread ----

  std::future<void> ask(std::function<void()> call);
  template <class Change>
  void request(const Change& change);

  const std::unique_ptr<PlaybackSource> source;
  scene::Scene& scene;
  Simulation& simulation;
  const SessionOptions options;
  Clock clock;
  Lateness lateness_before;  // of clocks before this one
  Speedometer speedometer;

  mutable std::mutex mutex;  // of what follows
  std::condition_variable changed;
  struct Requests {
    bool paused = false, finished = false, new_speed = false;
    std::optional<double> speed;
    Duration end{};
    std::int64_t steps = 0;  // still to be made while paused
  } requests;
  bool closed = false;  // run() has returned
  std::deque<Job> jobs;
  SessionStatus status;
  std::vector<BranchView> branches;
  Lateness lateness;
  std::atomic<bool> attention{false};  // there is a request
  std::atomic<std::uint64_t> seeks{0};
};

// ---- definitions ----

template <class Change>
void Session::Inside::request(const Change& change) {
  const std::lock_guard lock(mutex);
  change(requests);
  attention.store(true);
  changed.notify_all();
}

}  // namespace murosimf::session
