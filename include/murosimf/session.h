/// session.h - a running scene under control of other threads: pause, speed, changes, jumps back in time (docs/embedding.md, "Steering").
///
///     murosimf::Session session(scene, {.speed = 1.0});
///     std::thread run([&] { session.run(60.0); });
///     session.change("blue1.level=full_dynamics");   // from any other thread
///     session.pause();
///     session.seek(2.0);
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/scene.h"

namespace murosimf {

namespace api {
struct SessionInside;
}

inline namespace v0 {

struct SessionOptions {
  std::optional<double> speed;  ///< simulated seconds per wall second; nothing: as fast as possible
  bool paused = false;          ///< begins so
  bool stays = false;           ///< at its end it pauses there until finish(); false: run() returns
};

/// The state of a session between two steps.
struct SessionStatus {
  double time = 0, end = 0;    ///< [s] simulated; where it pauses by itself
  double first = 0, last = 0;  ///< [s] range of seek() on the present branch
  bool paused = false;
  double factor = 0;  ///< simulated seconds per wall second, lately
  int branch = 0;     ///< of the run: every jump back begins a new one
};

/// While run() runs, nothing but the session uses the scene and its handles.
class MUROSIMF_API Session {
 public:
  /// Keeps the scene alive inside the library. Throws InputError for an impossible speed.
  explicit Session(const Scene& scene, const SessionOptions& options = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// The calling thread runs the scene until finish() or, unless it stays, until simulated time `end` [s].
  void run(double end);

  // From any other thread; those that return when it is done throw as error.h says if it fails, and Error after run() has returned.
  void pause();
  void go_on();
  void step(std::int64_t steps = 1);
  void set_speed(std::optional<double> speed);
  void change(const std::string& assignment);
  void change(const std::vector<std::string>& assignments);
  void reset(std::optional<std::uint64_t> seed = {});
  /// Jumps back to the instant `time` [s] and pauses there.
  void seek(double time);
  void finish();
  [[nodiscard]] SessionStatus status() const;

 private:
  std::unique_ptr<api::SessionInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
