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
///
/// The level that moves a robot can be exchanged at any time between two steps:
///
///     simulation.exchange<ArticulatedDynamics>("articulated_dynamics", robot);
///     simulation.at(3s, [&] { simulation.exchange<KinematicWalking>("kinematic_walking", robot); });
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/algorithm.h"
#include "murosimf/model/motion_level.h"
#include "murosimf/model/setup.h"
#include "murosimf/model/world.h"
#include "murosimf/runtime/clock.h"
#include "murosimf/runtime/plan.h"
#include "murosimf/runtime/step_checks.h"
#include "murosimf/runtime/thread_pool.h"

namespace murosimf {

/// What one kind of algorithm has cost.
struct AlgorithmStatistics {
  std::string name;
  double rate_hz = 0;
  std::int64_t calls = 0;
  double us_per_call =
      0;  ///< mean; after the first 64 calls from every eighth: taking the time of all would slow them down
};

/// An algorithm's place in the order of a tick.
struct PlannedAlgorithm {
  std::size_t wave = 0;  ///< those of one wave run at the same time
  Phase phase{};
  std::string name, entity;
  double rate_hz = 0;
};

/// How a level that takes the place of another one begins.
enum class LevelStart {
  in_motion,  ///< goes on from the present state; refuses if it cannot
  anew,       ///< as at the beginning of a run: a state will be loaded before the next step
};

/// Something that happened once: a level was exchanged, or refused.
struct Event {
  Duration time{};
  std::string text;
};

class Simulation {
 public:
  template <class A>
  using Maker = std::function<std::unique_ptr<A>(Setup&)>;

  explicit Simulation(int threads = 1);
  ~Simulation();

  [[nodiscard]] World& world() { return *world_; }
  [[nodiscard]] const World& world() const { return *world_; }

  /// Adds an algorithm: constructs an A with (Setup&, arguments...) for `entity` and executes it `rate_hz` times per
  /// simulated second. `name` is what reports and messages call it. Algorithms that conflict run by phase, then
  /// in the order of attaching. Throws SetupError if the rate is not positive and finite, or after the first step.
  template <class A, class... Arguments>
  A& attach(std::string name, Entity& entity, double rate_hz, Arguments&&... arguments) {
    const auto make = [&](Setup& setup) { return std::make_unique<A>(setup, std::forward<Arguments>(arguments)...); };
    return static_cast<A&>(attach(std::move(name), entity, rate_hz, Maker<Algorithm>(make)));
  }
  /// The same for an algorithm that make(setup) constructs.
  Algorithm& attach(std::string name, Entity& entity, double rate_hz, const Maker<Algorithm>& make);

  /// Has another level move `entity` from now on, at the same rate and in the same place of the order: constructs an L
  /// with (Setup&, arguments...), which takes over the motion as it is (model/motion_level.h). Columns that nobody uses
  /// any more are removed. Throws SetupError, and leaves everything as it was, if the level refuses, or if somebody
  /// reads what it does not write. To be called between steps only.
  template <std::derived_from<MotionLevel> L, class... Arguments>
  L& exchange(std::string name, Entity& entity, Arguments&&... arguments) {
    const auto make = [&](Setup& setup) { return std::make_unique<L>(setup, std::forward<Arguments>(arguments)...); };
    return static_cast<L&>(exchange(std::move(name), entity, Maker<MotionLevel>(make)));
  }
  MotionLevel& exchange(std::string name, Entity& entity, const Maker<MotionLevel>& make,
                        LevelStart start = LevelStart::in_motion);

  /// The level that moves `entity` now; null if there is none.
  [[nodiscard]] const MotionLevel* level_of(const Entity& entity) const;

  /// Has `call` done between two steps, when simulated time has come to `time` (at once if it has passed). A SetupError
  /// that it throws becomes a warning; the run goes on. Those asked for before initialize() are the simulation's schedule: it
  /// is part of the state how far that has come. Later ones are their caller's, whom a state that is loaded does not concern.
  void at(Duration time, std::function<void()> call);

  /// Has `call` done at the end of initialize(), when all columns exist and have their first values.
  void after_initialize(std::function<void()> call) { after_initialize_.push_back(std::move(call)); }

  /// Checks, freezes, initializes and plans. Called by the first step; call it yourself to set properties before.
  void initialize();

  /// Advances by at least `duration` (whole ticks), paced by `clock`. `progress`, if given, is called about ten times
  /// per wall second with the present simulated time. Throws SetupError if the duration is negative. Ends early, between
  /// two ticks, if stopped().
  void run(Duration duration, Clock& clock, const std::function<void(Duration)>& progress = {});
  /// As fast as possible.
  void run(Duration duration);
  /// One tick.
  void step();

  /// Has run() end early once `stop` says true; asked before every tick and while a clock waits. step() does not ask.
  void stop_if(StopRequest stop) { stop_ = std::move(stop); }
  [[nodiscard]] bool stopped() const { return stop_ && stop_(); }

  [[nodiscard]] Duration now() const { return now_; }
  [[nodiscard]] Duration tick() const { return plan_.tick(); }
  [[nodiscard]] int threads() const { return pool_.threads(); }
  [[nodiscard]] std::uint64_t state_hash() const { return world_->state_hash(); }

  /// Everything that decides how it goes on, between two steps: all columns, sensors' memory and readings, pictures on their way,
  /// time, schedule, events and warnings so far. Initializes.
  [[nodiscard]] std::vector<std::byte> save();
  /// Goes on from there, bit for bit: the next steps and readings are those that followed save(), there and in every simulation
  /// that was built alike, on machines of one byte order; algorithms that only observe may be others. Throws SetupError that
  /// says what does not fit, and is as before then: another version of the library, damaged bytes, other entities, columns or
  /// algorithms. Initializes.
  void load(std::span<const std::byte> bytes);

  /// The order of a tick in which every algorithm is due: by waves, then by phase and order of attaching. Initializes.
  [[nodiscard]] std::vector<PlannedAlgorithm> order_of_tick();
  /// One row per name and rate, in the order of the tick.
  [[nodiscard]] std::vector<AlgorithmStatistics> statistics() const;
  /// Names of the algorithms that write a property of an entity while stepping; empty: nobody does.
  [[nodiscard]] std::vector<std::string> writers_of(const Entity& entity, std::string_view property) const;
  /// What happened on the way, in the order of time: exchanges, and whatever record() was called with.
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  void record(std::string text) { events_.push_back({now_, std::move(text)}); }
  /// What went wrong on the way, one line each: frozen entities, calls that were refused.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Task {
    std::string name;
    const Entity* entity = nullptr;
    Duration period{};
    std::unique_ptr<Algorithm> algorithm;
    MotionLevel* level = nullptr;  ///< the algorithm, if it is one
    AccessSet access;
    bool frozen = false;  ///< of the entity, taken over between ticks so that it cannot change during one
    std::int64_t calls = 0;
    std::int64_t timed_calls = 0;  ///< that `time` stands for
    Duration time{};
  };
  struct TimedCall {
    Duration time{};
    std::function<void()> call;
  };

  [[nodiscard]] std::unique_ptr<Task> new_task(std::string name, const Entity& entity, double rate_hz) const;
  [[nodiscard]] static std::string full_name(const Task& task);
  void add_in_order(std::unique_ptr<Task> task);
  [[nodiscard]] std::vector<std::unique_ptr<Task>>::iterator task_of_level(const Entity& entity);
  void construct_level(Task& task, Entity& entity, const Maker<MotionLevel>& make, LevelStart start);
  void put_in_place_of(std::unique_ptr<Task>& present, std::unique_ptr<Task>& next, LevelStart start);
  void drop_columns_of(const Task& task);
  void restart_columns_of(const Task& task);
  void check_and_plan();
  void restart_checks();
  void run_wave(const Wave& wave);
  void make_timed_calls();
  void make(const TimedCall& call);
  void load_sections(std::span<const std::byte> bytes);
  template <class Visit>
  void visit_sections(const Visit& visit);
  void state(StateArchive& archive);
  void execute(Task& task) noexcept;
  void take_over_frozen();

  std::unique_ptr<World> world_;                // outlives the tasks, which point into it
  std::vector<std::unique_ptr<Task>> tasks_;    // by phase, then by order of attaching
  std::vector<std::unique_ptr<Task>> retired_;  // exchanged; without algorithm, for the statistics
  std::vector<TimedCall> schedule_;             // asked for before initialize(), the earliest first
  std::size_t scheduled_done_ = 0;              // of them
  std::vector<TimedCall> timed_calls_;          // those to come that were asked for later, the next one first
  std::vector<Event> events_;
  Plan plan_;
  StepChecks checks_;  // used in debug builds only
  ThreadPool pool_;
  Duration now_{};
  std::int64_t ticks_ = 0;
  bool initialized_ = false;
  StopRequest stop_;
  std::vector<std::function<void()>> after_initialize_;
  std::vector<std::string> warnings_;
  std::size_t frozen_reported_ = 0;
};

}  // namespace murosimf
