/// simulation.h - a world, the algorithms that act on it, and time.
///
///     Simulation simulation;
///     Entity& ball = simulation.world().add("ball", ball_model);
///     simulation.attach<SimplifiedDynamics>("simplified_dynamics", ball, 1000);
///     simulation.run(10s);
///     Vec3d r = ball.base().get(properties::position);
///
/// Attaching runs the algorithm's constructor, which takes its columns; the first step freezes the columns, checks
/// that whatever is read is written, lets every algorithm initialize what it writes, and plans the waves.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/algorithm.h"
#include "murosimf/model/setup.h"
#include "murosimf/model/world.h"
#include "murosimf/runtime/clock.h"
#include "murosimf/runtime/plan.h"
#include "murosimf/runtime/thread_pool.h"

namespace murosimf {

/// What one kind of algorithm has cost.
struct AlgorithmStatistics {
  std::string name;
  double rate_hz = 0;
  std::int64_t calls = 0;
  double us_per_call = 0;  ///< mean over every eighth call; taking the time of all would slow the shortest ones down
};

class Simulation {
 public:
  explicit Simulation(int threads = 1);
  ~Simulation();

  [[nodiscard]] World& world() { return *world_; }
  [[nodiscard]] const World& world() const { return *world_; }

  /// Adds an algorithm: constructs an A with (Setup&, arguments...) for `entity` and executes it `rate_hz` times per
  /// simulated second. `name` is what reports and messages call it. Order matters: algorithms that conflict run in
  /// the order of attaching. Throws SetupError if the rate is not positive and finite, or after the first step.
  template <class A, class... Arguments>
  A& attach(std::string name, Entity& entity, double rate_hz, Arguments&&... arguments) {
    auto task = new_task(std::move(name), entity, rate_hz);
    Setup setup(*world_, entity, task->access, task->period);
    auto algorithm = std::make_unique<A>(setup, std::forward<Arguments>(arguments)...);
    A& reference = *algorithm;
    task->algorithm = std::move(algorithm);
    tasks_.push_back(std::move(task));  // last: a constructor that throws leaves nothing behind
    return reference;
  }

  /// Has `call` done at the end of initialize(), when all columns exist and have their first values.
  void after_initialize(std::function<void()> call) { after_initialize_.push_back(std::move(call)); }

  /// Checks, freezes, initializes and plans. Called by the first step; call it yourself to set properties before.
  void initialize();

  /// Advances by at least `duration` (whole ticks), paced by `clock`. `progress`, if given, is called about ten times
  /// per wall second with the present simulated time. Throws SetupError if the duration is negative.
  void run(Duration duration, Clock& clock, const std::function<void(Duration)>& progress = {});
  /// As fast as possible.
  void run(Duration duration);
  /// One tick.
  void step();

  [[nodiscard]] Duration now() const { return now_; }
  [[nodiscard]] Duration tick() const { return plan_.tick(); }
  [[nodiscard]] int threads() const { return pool_.threads(); }
  [[nodiscard]] std::uint64_t state_hash() const { return world_->state_hash(); }

  /// One row per name and rate, in the order of attaching.
  [[nodiscard]] std::vector<AlgorithmStatistics> statistics() const;
  /// What went wrong on the way, one line each: frozen entities.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Task {
    std::string name;
    const Entity* entity = nullptr;
    Duration period{};
    std::unique_ptr<Algorithm> algorithm;
    AccessSet access;
    bool frozen = false;  ///< of the entity, taken over between ticks so that it cannot change during one
    std::int64_t calls = 0;
    std::int64_t timed_calls = 0;
    Duration time{};
  };

  [[nodiscard]] std::unique_ptr<Task> new_task(std::string name, const Entity& entity, double rate_hz) const;
  void execute(Task& task) noexcept;
  void take_over_frozen();

  std::unique_ptr<World> world_;  // outlives the tasks, which point into it
  std::vector<std::unique_ptr<Task>> tasks_;
  Plan plan_;
  ThreadPool pool_;
  Duration now_{};
  std::int64_t ticks_ = 0;
  bool initialized_ = false;
  std::vector<std::function<void()>> after_initialize_;
  std::vector<std::string> warnings_;
  std::size_t frozen_reported_ = 0;
};

}  // namespace murosimf
