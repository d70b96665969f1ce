/// session.h - a running scene that other threads control: viewers, servers, supervisors.
///
///     scene::Scene scene("three_on_three", {.pushable = true, .stop = interrupted});
///     session::Session session(scene, {.speed = 1.0});
///     std::thread run([&] { session.run(60s); });
///     session.pause();                                       // from here on: any thread
///     session.change("blue1.level = full_dynamics").get();   // also while it is paused
///     session.seek(2s);                                      // back in time; the rest of the run stays as a branch
///     session.go_on();
///
/// One thread runs the scene; requests of others are executed between two steps, also while it is paused. Control has no effect on
/// the results: the same scene, seed and changes give the same states, at any speed and with any pauses. Control software, referees and
/// other external participants are never asked twice for an instant: up to the last live instant their recorded input is repeated. From there
/// on they continue in their present state, which SessionStatus::diagnostic reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/runtime/clock.h"
#include "murosimf/scene/scene.h"
#include "murosimf/session/playback_source.h"
#include "murosimf/session/timeline.h"

namespace murosimf::session {

struct SessionOptions {
  std::optional<double> speed{};  ///< simulated seconds per wall second; nothing: as fast as possible
  bool paused = false;            ///< starts paused
  bool stays = true;              ///< at its end: pauses there until finish(); false: run() returns
  TimelineOptions timeline{};     ///< states kept for going back
  std::function<void(const Overrun&)> publish_overruns{};  ///< called by the thread that runs it (Clock)
  /// Starts or stops a recording; called between two steps by the thread that runs it. None: recording is not available.
  std::function<void(bool on)> record{};
  std::string no_way_back{};  ///< reason why reset and going back are impossible ("it is recorded"); empty: possible
};

/// A snapshot between two steps.
struct SessionStatus {
  Duration time{};              ///< simulated
  Duration end{};               ///< time at which it pauses by itself
  Duration first{}, last{};     ///< of the present branch of the timeline, including its ancestors
  bool paused = false;          ///< stands still
  bool at_end = false;          ///< the end of a recording: go_on() restarts it
  std::optional<double> speed;  ///< requested
  double factor = 0;            ///< simulated seconds per wall second, over about the last second; 0 while it is paused
  std::uint64_t jumps = 0;      ///< number of jumps in time: resets, seeks, loaded states
  int branch = 0;               ///< of the timeline
  std::size_t events = 0, warnings = 0;  ///< of the simulation, so far
  std::optional<bool> recorded;          ///< whether it is being recorded; nothing: not available
  std::string diagnostic{};  ///< since the last jump: what differs from the earlier run, and why; empty: nothing
};

class Session {
 public:
  /// The scene must outlive it. Initializes the scene. Throws SetupError for an impossible speed.
  explicit Session(scene::Scene& scene, const SessionOptions& options = {});
  /// For another source than a computed scene: a recording. `timeline` and `no_way_back` are handled by the source.
  explicit Session(std::unique_ptr<PlaybackSource> source, const SessionOptions& options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// The calling thread runs the scene until finish(), a stop of the simulation (SceneOptions::stop), or, if it does not stay, its
  /// end. At simulated time `end` it pauses: going back, changes, and continuing beyond remain possible. `progress`, if given, is
  /// called about ten times per wall second while it runs.
  void run(Duration end, const std::function<void(Duration)>& progress = {});

  // ---- From any thread. Futures become ready when the request is done, and throw SetupError if it failed; after run() has returned,
  // ---- requests are refused, and they throw. ----

  void pause();
  /// At or after the end: continues without an end. After run_until() on a run that is not paused, do not call this: the run may have
  /// reached the new end already. go_on_until() does both at once.
  void go_on();
  /// Continues, and pauses at `end`; at once if that has passed.
  void go_on_until(Duration end);
  /// Makes this number of steps (of Simulation::tick()) and pauses.
  void step(std::int64_t steps = 1);
  /// Simulated seconds per wall second; nothing: as fast as possible. Throws SetupError for an invalid speed.
  void set_speed(std::optional<double> speed);
  /// Time at which it pauses by itself, replacing the argument of run().
  void run_until(Duration end);

  /// A change by PATH = VALUE as of Scene::post, at once, between two steps. It becomes part of the run's commands, by which it can be
  /// repeated.
  std::future<void> change(std::string text);
  /// Several, in order between the same two steps: all of them, or none if one fails.
  std::future<void> change(std::vector<std::string> texts);
  /// `add` adds entities by Scene::add between two steps, or throws SetupError and changes nothing. The run continues as a branch without a
  /// parent: there is no way back to before. A recording keeps it and repeats it.
  std::future<void> extend(std::function<void(scene::Scene&)> add);
  /// Returns to the start, with another seed if given, as a new branch; continues or stays paused as before.
  std::future<void> reset(std::optional<std::uint64_t> seed = {});
  /// To the instant `time` of a branch of the timeline (default: the present one), and pauses there. Continuing
  /// from an earlier instant starts a new branch, without the commands that came later; the old one remains. Of several waiting requests
  /// only the last one is done.
  std::future<void> seek(Duration time, std::optional<int> branch = {});
  /// `load` puts a state from elsewhere into the scene, or throws SetupError and changes nothing; pauses there. The run continues as a
  /// branch without a parent.
  std::future<void> load(std::function<void(scene::Scene&)> load);
  /// Calls `call` between two steps, soon: for reading or saving data that only the simulation's thread may access. It must change nothing.
  std::future<void> visit(std::function<void(scene::Scene&)> call);
  /// SessionOptions::record.
  std::future<void> record(bool on);
  /// Ends run().
  void finish();

  /// For data that never changes while it runs; for everything else there is visit().
  [[nodiscard]] scene::Scene& scene();
  /// PlaybackSource::known_properties.
  [[nodiscard]] const std::vector<std::string>& known_properties() const;
  [[nodiscard]] SessionStatus status() const;
  /// A copy of the timeline.
  [[nodiscard]] std::vector<BranchView> branches() const;
  /// How late it was while it had a speed.
  [[nodiscard]] Lateness lateness() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace murosimf::session
