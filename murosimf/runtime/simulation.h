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
///
/// It composes parts that own one thing each: task_list.h the attached algorithms, algorithm_registry.h how they come and go, scheduler.h
/// the plan, threads and time, timed_calls.h and command_queue.h what is to be done between steps, event_log.h what has happened.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/runtime/algorithm_registry.h"
#include "murosimf/runtime/command_queue.h"
#include "murosimf/runtime/event_log.h"
#include "murosimf/runtime/pacer.h"
#include "murosimf/runtime/pose_feed.h"
#include "murosimf/runtime/scheduler.h"
#include "murosimf/runtime/task_list.h"
#include "murosimf/runtime/timed_calls.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/motion_level.h"
#include "murosimf/world/rate.h"
#include "murosimf/world/setup.h"
#include "murosimf/world/world.h"

namespace murosimf {

class Simulation {
  friend class SimulationLanes;
  friend class StatePacker;

 public:
  explicit Simulation(int threads = 1);

  [[nodiscard]] World& world() noexcept { return world_; }
  [[nodiscard]] const World& world() const noexcept { return world_; }

  // ---- Participants ----

  /// Adds an algorithm: constructs an A with (Setup&, arguments...) for `entity` and executes it at `rate` (a number: [Hz]) of
  /// simulated time, in the ticks that begin nearest to its instants (plan.h). `name` is what reports and messages call it. Algorithms that conflict run by phase, then
  /// in the order of attaching. In a running simulation, between two steps, it is initialized at once and is due from the next step
  /// on. Throws SetupError, and leaves everything as it was, if the rate is not positive and finite or does not fit to the others,
  /// if the constructor or initialize() throws, or if no algorithm writes what it reads.
  template <class A, class... Arguments>
  A& attach(std::string name, Entity& entity, const Rate& rate, Arguments&&... arguments) {
    const auto make = [&](Setup& setup) { return std::make_unique<A>(setup, std::forward<Arguments>(arguments)...); };
    return static_cast<A&>(attach(std::move(name), entity, rate, AlgorithmMaker<Algorithm>(make)));
  }
  /// The same for an algorithm that make(setup) constructs.
  Algorithm& attach(std::string name, Entity& entity, const Rate& rate, const AlgorithmMaker<Algorithm>& make) {
    return registry_.attach(std::move(name), entity, rate, make);
  }

  /// The same for algorithms that belong to no entity: those of the whole world, whose columns are world().common()'s.
  template <class A, class... Arguments>
  A& attach(std::string name, const Rate& rate, Arguments&&... arguments) {
    return attach<A>(std::move(name), world_.common(), rate, std::forward<Arguments>(arguments)...);
  }

  /// Adds an entity with all its algorithms, which furnish(entity) attaches, between two steps or before the first; in a running
  /// simulation they are then initialized, with `prepare` as for enter(). Throws SetupError, and leaves everything as it was, if one
  /// of that fails.
  Entity& add(std::string name, ModelPtr model, const EntityOptions& options,
              const std::function<void(Entity&)>& furnish, const std::function<void(Entity&)>& prepare = {});
  /// Has `call` done after each of these, with what came. It may attach algorithms that only observe; what it throws, add() throws, though the
  /// entity stays.
  void after_addition(std::function<void(Entity&)> call) { after_addition_.push_back(std::move(call)); }

  /// Takes an algorithm out and destroys it, between two steps; unused columns are removed (views keep theirs,
  /// column_view.h). Throws SetupError, and changes nothing, if it is a level, or if another one reads what only it writes.
  void detach(const Algorithm& algorithm) { registry_.detach(algorithm); }

  /// Has another level move `entity` from now on, at the same rate and in the same place of the order: constructs an L
  /// with (Setup&, arguments...), which takes over the motion as it is (world/motion_level.h). Unused
  /// columns are removed. Throws SetupError, and leaves everything as it was, if the level refuses, or if an
  /// algorithm reads what it does not write. To be called between steps only.
  template <std::derived_from<MotionLevel> L, class... Arguments>
  L& exchange(std::string name, Entity& entity, Arguments&&... arguments) {
    const auto make = [&](Setup& setup) { return std::make_unique<L>(setup, std::forward<Arguments>(arguments)...); };
    return static_cast<L&>(exchange(std::move(name), entity, AlgorithmMaker<MotionLevel>(make)));
  }
  MotionLevel& exchange(std::string name, Entity& entity, const AlgorithmMaker<MotionLevel>& make,
                        LevelStart start = LevelStart::in_motion) {
    return registry_.exchange(std::move(name), entity, make, start);
  }

  /// Gives an entity another model of the same objects, between two steps: its level is exchanged for one that `level`
  /// constructs, which keeps place and velocities; all other algorithms work out anew what hangs on the model. Throws SetupError,
  /// and leaves everything as it was, if the objects are others or the level refuses.
  void exchange_model(Entity& entity, ModelPtr model, const AlgorithmMaker<MotionLevel>& level,
                      LevelStart start = LevelStart::in_motion) {
    registry_.exchange_model(entity, std::move(model), level, start);
  }

  /// Between two steps: takes an entity out of the world. Its columns, algorithms and place among the entities stay, but nothing
  /// executes these, touches, sees or shows it, until enter(). Initializes. Throws SetupError if it is not there.
  void leave(Entity& entity);
  /// Puts it back, as a reset would begin with it: its columns and algorithms are as before the first start, `prepare` is called
  /// (it may place the entity and set inputs), and they are initialized. Throws SetupError, and leaves it out, if it is there, or
  /// an algorithm cannot start.
  void enter(Entity& entity, const std::function<void(Entity&)>& prepare = {});

  /// The level that moves `entity` now; null if there is none.
  [[nodiscard]] const MotionLevel* level_of(const Entity& entity) const { return tasks_.level_of(entity); }
  /// Names of the algorithms that write a property of an entity while stepping; empty: none does.
  [[nodiscard]] std::vector<std::string> writers_of(const Entity& entity, std::string_view property) const {
    return tasks_.writers_of(entity, property);
  }
  /// The order of a tick in which every algorithm is due: by waves, then by phase and order of attaching. Initializes.
  [[nodiscard]] std::vector<PlannedAlgorithm> order_of_tick();
  /// One row per name and rate, in the order of the tick.
  [[nodiscard]] std::vector<AlgorithmStatistics> statistics() const { return tasks_.statistics(); }

  // ---- The start ----

  /// Has `call` done at every start, by initialize() and by reset(): before algorithms give columns their first values (it may
  /// place entities and set inputs), or after that (it may set properties).
  void before_start(std::function<void()> call) { before_start_.push_back(std::move(call)); }
  void after_start(std::function<void()> call) { after_start_.push_back(std::move(call)); }

  /// Checks, freezes, initializes and plans. Called by the first step; call it yourself to set properties before.
  void initialize();
  /// Back to the time 0, without building anything: as after initialize(), bit for bit. Levels and laws are those of now;
  /// calls that were asked for after initialize() are forgotten. Throws SetupError if an algorithm cannot start.
  void reset();
  /// Has all algorithms draw their random numbers from another seed from now on; readings and columns stay as they are.
  void reseed(std::uint64_t seed) { registry_.reseed(seed); }

  // ---- Time ----

  [[nodiscard]] Duration now() const noexcept { return scheduler_.now(); }
  [[nodiscard]] Duration tick() const noexcept { return scheduler_.tick(); }

  /// Advances by at least `duration` (whole ticks), paced by `pacer`: a Clock, a LockStep. `progress`, if given, is called about ten times
  /// per wall second with the present simulated time. Throws SetupError if the duration is negative. Ends early, between
  /// two ticks, if stopped().
  void run(Duration duration, Pacer& pacer, const std::function<void(Duration)>& progress = {});
  /// As fast as possible.
  void run(Duration duration);
  /// One tick.
  void step();

  /// Has run() end early once `stop` says true; asked before every tick and while a clock waits. step() does not ask.
  void stop_if(StopRequest stop) { stop_ = std::move(stop); }
  [[nodiscard]] bool stopped() const { return stop_ && stop_(); }

  /// The threads, and which waves they share out: only how long it takes depends on it.
  [[nodiscard]] ThreadPool& pool() noexcept { return scheduler_.pool(); }
  [[nodiscard]] const ThreadPool& pool() const noexcept { return scheduler_.pool(); }
  /// Whether equal robots step together in lanes (lane_jobs.h), as they do unless told otherwise. Only how long it takes depends on it.
  void use_lanes(bool use) { scheduler_.use_lanes(use); }
  /// How many algorithms do so, of those that have been due so far.
  [[nodiscard]] std::size_t algorithms_in_lanes() const { return scheduler_.algorithms_in_lanes(); }

  // ---- What is done between steps ----

  /// Has `call` done between two steps, when simulated time has come to `time` (at once if it has passed). A SetupError
  /// that it throws becomes a warning; the run goes on. Those asked for before initialize() are the simulation's schedule: it
  /// is part of the state how far that has come. Later ones belong to their caller: a loaded state does not change them.
  void at(Duration time, std::function<void()> call);

  /// For other threads: what they post() is done at the beginning of the next step, after the calls of that time. Its history is
  /// commands().
  [[nodiscard]] CommandQueue& command_queue() noexcept { return commands_; }
  /// Those that were carried out: with them a run can be repeated.
  [[nodiscard]] const std::vector<Command>& commands() const noexcept { return commands_.history(); }
  /// For a caller that pauses between two steps: executes now what others have posted, instead of at the beginning of the next step, at the same
  /// simulated time; as there, after the calls of that time. Poses are published again then.
  void carry_out_commands();

  /// What is to be done, and was asked for: no part of a state. A caller that undoes steps by load() restores it, too.
  struct Agenda {
    std::size_t commands = 0;      ///< that were carried out
    std::vector<TimedCall> calls;  ///< that come later
  };
  [[nodiscard]] Agenda agenda() const { return {commands_.history().size(), timed_calls_.later()}; }
  void agenda_was(Agenda agenda);

  // ---- Events, and poses for observers ----

  /// In the order of time: exchanges, and whatever record() was called with.
  [[nodiscard]] const std::vector<Event>& events() const noexcept { return log_.events(); }
  void record(std::string text) { log_.record(now(), std::move(text)); }
  /// What went wrong on the way, one line each: frozen entities, calls that were refused.
  [[nodiscard]] const std::vector<std::string>& warnings() const noexcept { return log_.warnings(); }
  void warn(std::string text) { log_.warn(std::move(text)); }

  /// Copies of poses for other threads.
  [[nodiscard]] PoseFeed& poses() noexcept { return poses_; }
  /// Publishes the present poses to all observers, also if no step was made since the last ones.
  void publish_poses() { poses_.publish_again(world_, now(), scheduler_.ticks()); }
  /// For playback, instead of steps: the caller has set the columns to those of that time, with the events and warnings until then.
  /// Nothing is computed; poses are published. To go on from there would be another run: reset() or load() come before that. Initializes.
  void show_past(Duration time, std::span<const Event> events, std::span<const std::string> warnings);

  // ---- State ----

  [[nodiscard]] std::uint64_t state_hash() const { return world_.state_hash(); }
  /// Everything that decides how it goes on, between two steps: all columns, sensors' memory and readings, pictures on their way,
  /// time, schedule, events and warnings so far. Initializes.
  [[nodiscard]] std::vector<std::byte> save();
  /// Goes on from there, bit for bit: the next steps and readings are those that followed save(), there and in every simulation
  /// that was built alike, on machines of one byte order; algorithms that only observe may be others. Throws SetupError that
  /// says what does not fit, and is as before then: another version of the library, damaged bytes, other entities, columns or
  /// algorithms. Initializes.
  void load(std::span<const std::byte> bytes);

 private:
  void start();
  void make(const std::function<void()>& call);
  void make_timed_calls();
  void load_sections(std::span<const std::byte> bytes);
  template <class Visit>
  void visit_parts(const Visit& visit);
  void state(StateArchive& archive);

  World world_;     // outlives the tasks, which point into it
  TaskList tasks_;  // outlive the scheduler, whose groups of lanes point to them
  EventLog log_;
  TimedCalls timed_calls_;
  CommandQueue commands_;
  PoseFeed poses_;
  Scheduler scheduler_;
  AlgorithmRegistry registry_{world_, tasks_, scheduler_, log_};
  std::vector<std::function<void()>> before_start_, after_start_;
  std::vector<std::function<void(Entity&)>> after_addition_;
  StopRequest stop_;
};

}  // namespace murosimf
