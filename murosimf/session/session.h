/// session.h - a running scene that others steer from their threads: viewers, servers, supervisors.
///
///     scene::Scene scene("three_on_three", {.pushable = true, .stop = interrupted});
///     session::Session session(scene, {.speed = 1.0});
///     std::thread run([&] { session.run(60s); });
///     session.pause();                                       // from here on: any thread
///     session.change("blue1.level = full_dynamics").get();   // also while it is paused
///     session.seek(2s);                                      // back in time; the rest of the run stays as a branch
///     session.go_on();
///
/// One thread runs the scene; what others ask it does between two steps, also while it is paused. Steering changes nothing of what
/// is computed: the same scene, seed and changes give the same states, at any speed and with any pauses. Control software, referees and
/// others outside are asked for no instant twice: until where the run goes on live they are answered for by what they had said. From there
/// on they go on as they are, and SessionStatus::diagnostic says so.
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
  bool paused = false;            ///< begins so
  bool stays = true;              ///< at its end: pauses there until finish(); false: run() returns
  TimelineOptions timeline{};     ///< what is kept for going back
  std::function<void(const Overrun&)> publish_overruns{};  ///< called by the thread that runs it (Clock)
  /// Has the run recorded, or no longer; called between two steps by the thread that runs it. None: nobody can ask for it.
  std::function<void(bool on)> record{};
  std::string no_way_back{};  ///< why it cannot be reset or go back in time ("it is recorded"); empty: it can
};

/// A copy, at one moment between two steps.
struct SessionStatus {
  Duration time{};              ///< simulated
  Duration end{};               ///< where it pauses by itself
  Duration first{}, last{};     ///< of the present branch of the timeline, with what led to it
  bool paused = false;          ///< stands still
  bool at_end = false;          ///< of a recording, behind which nothing comes: go_on() begins again
  std::optional<double> speed;  ///< wanted
  double factor = 0;            ///< simulated seconds per wall second, over about the last second; 0 while it is paused
  std::uint64_t jumps = 0;      ///< how often time has jumped: resets, seeks, loaded states
  int branch = 0;               ///< of the timeline
  std::size_t events = 0, warnings = 0;  ///< of the simulation, so far
  std::optional<bool> recorded;          ///< whether somebody asks for it; nothing: nobody can
  std::string
      diagnostic{};  ///< since the last jump: what will not go on as it was there before, and why; empty: everything will
};

class Session {
 public:
  /// The scene must outlive it. Initializes the scene. Throws SetupError for an impossible speed.
  explicit Session(scene::Scene& scene, const SessionOptions& options = {});
  /// Of something else than a scene that is computed: a recording. `timeline` and `no_way_back` are the source's business.
  explicit Session(std::unique_ptr<PlaybackSource> source, const SessionOptions& options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// The thread that calls it runs the scene until finish(), a stop of the simulation (SceneOptions::stop), or, if it does not stay, its
  /// end. At simulated time `end` it pauses: one may still look back, change things, and go on further. `progress`, if given, is
  /// called about ten times per wall second while it runs.
  void run(Duration end, const std::function<void(Duration)>& progress = {});

  // ---- From any thread. Futures are ready when it was done, and throw SetupError if it could not be; after run() has returned,
  // ---- nothing is done any more, and they throw. ----

  void pause();
  /// At or behind the end: without end. Who gives a run that is not paused a new end, by run_until(), must not call it after that: it may
  /// have come there already. go_on_until() does both at once.
  void go_on();
  /// Goes on, and pauses by itself at `end`; at once if that has passed.
  void go_on_until(Duration end);
  /// Makes so many steps (of Simulation::tick()) and pauses.
  void step(std::int64_t steps = 1);
  /// Simulated seconds per wall second; nothing: as fast as possible. Throws SetupError for an impossible one.
  void set_speed(std::optional<double> speed);
  /// Where it pauses by itself, instead of what run() was told.
  void run_until(Duration end);

  /// A change by PATH = VALUE as of Scene::post, at once, between two steps. It becomes part of the run's commands, by which it can be
  /// repeated.
  std::future<void> change(std::string text);
  /// Several, one after the other between the same two steps: all of them, or none if one cannot be done.
  std::future<void> change(std::vector<std::string> texts);
  /// Back to the start, with another seed if given, as a new branch; goes on or stays paused as before.
  std::future<void> reset(std::optional<std::uint64_t> seed = {});
  /// To the instant `time` of a branch of the timeline (the present one if not given), which was there before, and pauses there. What goes
  /// on from an earlier instant is a new branch, without the commands that came later; the old one stays. While several wait, only the
  /// last one is done.
  std::future<void> seek(Duration time, std::optional<int> branch = {});
  /// `load` puts a state of somewhere else into the scene, or throws SetupError and changes nothing; pauses there. What follows is a
  /// branch without a parent.
  std::future<void> load(std::function<void(scene::Scene&)> load);
  /// Has `call` made between two steps, soon: for who reads or saves what only the simulation's thread may touch. It must change nothing.
  std::future<void> visit(std::function<void(scene::Scene&)> call);
  /// SessionOptions::record.
  std::future<void> record(bool on);
  /// Ends run().
  void finish();

  /// For what never changes while it runs; for everything else there is visit().
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
