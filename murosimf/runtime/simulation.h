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
#include "murosimf/model/rate.h"
#include "murosimf/model/setup.h"
#include "murosimf/model/world.h"
#include "murosimf/runtime/command_queue.h"
#include "murosimf/runtime/home_helpers.h"
#include "murosimf/runtime/lane_jobs.h"
#include "murosimf/runtime/pacer.h"
#include "murosimf/runtime/plan.h"
#include "murosimf/runtime/pose_feed.h"
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
  struct TimedCall {
    Duration time{};
    std::function<void()> call;
  };

 public:
  template <class A>
  using Maker = std::function<std::unique_ptr<A>(Setup&)>;

  explicit Simulation(int threads = 1);
  ~Simulation();

  [[nodiscard]] World& world() { return *world_; }
  [[nodiscard]] const World& world() const { return *world_; }

  /// Adds an algorithm: constructs an A with (Setup&, arguments...) for `entity` and executes it at `rate` (a number: [Hz]) of
  /// simulated time, in the ticks that begin nearest to its instants (plan.h). `name` is what reports and messages call it. Algorithms that conflict run by phase, then
  /// in the order of attaching. In a running simulation, between two steps, it is initialized at once and is due from the next step
  /// on. Throws SetupError, and leaves everything as it was, if the rate is not positive and finite or does not fit to the others,
  /// if the constructor or initialize() throws, or if nobody writes what it reads.
  template <class A, class... Arguments>
  A& attach(std::string name, Entity& entity, const Rate& rate, Arguments&&... arguments) {
    const auto make = [&](Setup& setup) { return std::make_unique<A>(setup, std::forward<Arguments>(arguments)...); };
    return static_cast<A&>(attach(std::move(name), entity, rate, Maker<Algorithm>(make)));
  }
  /// The same for an algorithm that make(setup) constructs.
  Algorithm& attach(std::string name, Entity& entity, const Rate& rate, const Maker<Algorithm>& make);

  /// The same for algorithms that belong to no entity: those of the whole world, whose columns are world().common()'s.
  template <class A, class... Arguments>
  A& attach(std::string name, const Rate& rate, Arguments&&... arguments) {
    return attach<A>(std::move(name), world_->common(), rate, std::forward<Arguments>(arguments)...);
  }

  /// Adds an entity with all its algorithms, which furnish(entity) attaches, between two steps or before the first; in a running
  /// simulation they are then initialized, with `prepare` as for enter(). Throws SetupError, and leaves everything as it was, if one
  /// of that fails.
  Entity& add(std::string name, ModelPtr model, const EntityOptions& options,
              const std::function<void(Entity&)>& furnish, const std::function<void(Entity&)>& prepare = {});

  /// Takes an algorithm out and destroys it, between two steps; columns that nobody uses any more are removed (views keep theirs,
  /// column_view.h). Throws SetupError, and changes nothing, if it is a level, or if somebody reads what nobody else writes.
  void detach(const Algorithm& algorithm);

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

  /// Gives an entity another model of the same objects, between two steps: its level is exchanged for one that `level`
  /// constructs, which keeps place and velocities; all other algorithms work out anew what hangs on the model. Throws SetupError,
  /// and leaves everything as it was, if the objects are others or the level refuses.
  void exchange_model(Entity& entity, ModelPtr model, const Maker<MotionLevel>& level,
                      LevelStart start = LevelStart::in_motion);

  /// Between two steps: takes an entity out of the world. Its columns, algorithms and place among the entities stay, but nothing
  /// executes these, touches, sees or shows it, until enter(). Initializes. Throws SetupError if it is not there.
  void leave(Entity& entity);
  /// Puts it back, as a reset would begin with it: its columns and algorithms are as before the first start, `prepare` is called
  /// (it may place the entity and set inputs), and they are initialized. Throws SetupError, and leaves it out, if it is there, or
  /// an algorithm cannot start.
  void enter(Entity& entity, const std::function<void(Entity&)>& prepare = {});

  /// The level that moves `entity` now; null if there is none.
  [[nodiscard]] const MotionLevel* level_of(const Entity& entity) const;

  /// Has `call` done between two steps, when simulated time has come to `time` (at once if it has passed). A SetupError
  /// that it throws becomes a warning; the run goes on. Those asked for before initialize() are the simulation's schedule: it
  /// is part of the state how far that has come. Later ones are their caller's, whom a state that is loaded does not concern.
  void at(Duration time, std::function<void()> call);

  /// Has `call` done at every start, by initialize() and by reset(): before algorithms give columns their first values (it may
  /// place entities and set inputs), or after that (it may set properties).
  void before_start(std::function<void()> call) { before_start_.push_back(std::move(call)); }
  void after_start(std::function<void()> call) { after_start_.push_back(std::move(call)); }

  /// Back to the time 0, without building anything: as after initialize(), bit for bit. Levels and laws are those of now;
  /// calls that were asked for after initialize() are forgotten. Throws SetupError if an algorithm cannot start.
  void reset();
  /// Has all algorithms draw their random numbers from another seed from now on; readings and columns stay as they are.
  void reseed(std::uint64_t seed);

  /// Checks, freezes, initializes and plans. Called by the first step; call it yourself to set properties before.
  void initialize();

  /// Advances by at least `duration` (whole ticks), paced by `pacer`: a Clock, a LockStep. `progress`, if given, is called about ten times
  /// per wall second with the present simulated time. Throws SetupError if the duration is negative. Ends early, between
  /// two ticks, if stopped().
  void run(Duration duration, Pacer& pacer, const std::function<void(Duration)>& progress = {});
  /// As fast as possible.
  void run(Duration duration);
  /// One tick.
  void step();

  /// From any thread: has `call` done at the beginning of the next step, after the calls of that time. All who ask are served in
  /// the order in which they asked; `text` says what is to be done, so that commands() tells how to repeat the run. The future
  /// has what the call threw. What `check` refuses, if there is one, is no command.
  std::future<void> post(std::string text, std::function<void()> call, std::function<void()> check = {}) {
    return queue_.post(std::move(text), std::move(call), std::move(check));
  }
  [[nodiscard]] const std::vector<Command>& commands() const { return queue_.history(); }
  /// After load(): which commands had led to that state.
  void commands_were(std::vector<Command> commands) { queue_.set_history(std::move(commands)); }
  /// Of who carries out a command himself, between two steps.
  void note_command(std::string text) { queue_.note(now_, std::move(text)); }

  /// What is to be done, and was asked for: no part of a state. Who undoes by load() what he has done since then puts it back, too.
  class Agenda {
    friend class Simulation;
    std::size_t commands_ = 0;
    std::vector<TimedCall> calls_;
  };
  [[nodiscard]] Agenda agenda() const;
  void agenda_was(Agenda agenda);

  /// For who pauses between two steps: carries out now what others have posted, instead of at the beginning of the next step, at the same
  /// simulated time; as there, after the calls of that time. Poses are published again then.
  void carry_out_commands();
  /// Poses as they are now for all who look on, also if no step was made since the last ones.
  void publish_poses() { poses_.publish_again(*world_, now_, ticks_); }

  /// For who shows what was, instead of making steps: he has set columns to what they were at that time, until which this had happened.
  /// Nothing is computed; poses are published. To go on from there would be another run: reset() or load() come before that. Initializes.
  void show_past(Duration time, std::span<const Event> events, std::span<const std::string> warnings);

  /// Copies of poses for other threads.
  [[nodiscard]] PoseFeed& poses() { return poses_; }

  /// Has run() end early once `stop` says true; asked before every tick and while a clock waits. step() does not ask.
  void stop_if(StopRequest stop) { stop_ = std::move(stop); }
  [[nodiscard]] bool stopped() const { return stop_ && stop_(); }

  [[nodiscard]] Duration now() const { return now_; }
  [[nodiscard]] Duration tick() const { return plan_.tick(); }
  [[nodiscard]] int threads() const { return pool_.threads(); }
  /// Which waves these share out. Only how long it takes depends on it.
  void share_waves(Sharing sharing) { pool_.share(sharing); }
  [[nodiscard]] const ThreadPool& pool() const { return pool_; }
  /// Whether equal robots step together in lanes (lane_jobs.h), as they do unless told otherwise. Only how long it takes depends on it.
  void use_lanes(bool use);
  /// How many algorithms do so, of those that have been due so far.
  [[nodiscard]] std::size_t algorithms_in_lanes() const { return lane_jobs_.members_in_groups(); }
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
  void warn(std::string text) { warnings_.push_back(std::move(text)); }
  /// What went wrong on the way, one line each: frozen entities, calls that were refused.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Task {
    std::string name;
    const Entity* entity = nullptr;
    Rate rate{usual_step_rate};
    Duration period{};  ///< of it
    std::unique_ptr<Algorithm> algorithm;
    MotionLevel* level = nullptr;  ///< the algorithm, if it is one
    AccessSet access;
    bool comes_along = false;            ///< with the entity that is being added
    const double* step_ratio = nullptr;  ///< properties::step_ratio, if the entity makes steps of its own length
    bool idle = false;  ///< of the entity, taken over between ticks so that it cannot change during one
    std::int64_t calls = 0;
    std::int64_t timed_calls = 0;  ///< that `time` stands for
    Duration time{};
    std::vector<std::byte> first_memory;  ///< the algorithm's own state before it has first been initialized
  };

  [[nodiscard]] std::unique_ptr<Task> new_task(std::string name, const Entity& entity, const Rate& rate) const;
  [[nodiscard]] static std::string full_name(const Task& task);
  static void follow_step_multiple(Task& task, Setup& setup);
  void add_in_order(std::unique_ptr<Task> task);
  [[nodiscard]] std::vector<std::unique_ptr<Task>>::iterator task_of_level(const Entity& entity);
  void construct(Task& task, Entity& entity, const Maker<Algorithm>& make);
  void start_late(const Task& task);
  void keep_new_columns(const Task& task);
  void construct_level(Task& task, Entity& entity, const Maker<MotionLevel>& make, LevelStart start);
  void put_in_place_of(std::unique_ptr<Task>& present, std::unique_ptr<Task>& next, LevelStart start);
  void drop_columns_of(const Task& task);
  void restart_columns_of(const Task& task);
  void check_and_plan();
  void align_plan();
  void restart_checks();
  void run_wave(const Wave& wave, const WaveJobs& shared, const WaveJobs& alone);
  void make_timed_calls();
  void make(const TimedCall& call);
  void start();
  void load_sections(std::span<const std::byte> bytes);
  template <class Visit>
  void visit_parts(const Visit& visit);
  void keep_start();
  void go_back_to_start();
  static void go_back_to_start(Entity& entity);
  static void keep_columns(Entity& entity);
  static void keep_memory(Task& task);
  static void recall_first(Task& task);
  void state(StateArchive& archive);
  [[nodiscard]] ThreadAffinity find_homes() const;
  void plan_jobs();
  void execute(Task& task) noexcept;
  void execute(const Job& job) noexcept;
  template <class Step>
  void take_time(std::span<Task* const> tasks, const Step& step) noexcept;
  void take_over_frozen();
  void take_over_idle();
  void start_again(Entity& entity, const std::function<void(Entity&)>& prepare);
  void attach_all(Entity& entity, const std::function<void(Entity&)>& furnish);
  void begin(Entity& entity, const std::function<void(Entity&)>& prepare);
  void keep_start_of(Entity& entity);
  void tell_of(Entity& entity);
  void take_back(Entity& entity);

  std::unique_ptr<World> world_;                // outlives the tasks, which point into it
  std::vector<std::unique_ptr<Task>> tasks_;    // by phase, then by order of attaching
  std::vector<std::unique_ptr<Task>> retired_;  // exchanged; without algorithm, for the statistics
  std::vector<TimedCall> schedule_;             // asked for before initialize(), the earliest first
  std::size_t scheduled_done_ = 0;              // of them
  std::vector<TimedCall> timed_calls_;          // those to come that were asked for later, the next one first
  std::vector<Event> events_;
  CommandQueue queue_;
  PoseFeed poses_;
  Plan plan_;
  LaneJobs lane_jobs_;  // of the plan
  bool use_lanes_ = true;
  Duration planned_at_{};
  StepChecks checks_;  // used in debug builds only
  ThreadPool pool_;
  HomeHelpers parallel_for_{pool_};
  bool alone_in_wave_ = false;  // who steps now
  Duration now_{};
  std::int64_t ticks_ = 0;
  bool initialized_ = false;
  bool adds_ = false;  // an entity; what is attached meanwhile is initialized when all of it is there
  StopRequest stop_;
  std::vector<std::function<void()>> before_start_, after_start_;
  std::size_t events_before_start_ = 0;
  std::vector<std::string> warnings_;
  std::size_t frozen_reported_ = 0;
  LaneJobs lane_jobs_alone_;  // of the plan, as lane_jobs_, for one thread
};

}  // namespace murosimf
