/// running_scene.h - a scene, or a recording of one, that a session runs in a thread of its own during the lifetime of this object.
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <thread>

#include "murosimf/session/session.h"

namespace murosimf::viewer {

class RunningScene {
 public:
  /// Throws exceptions of `make`. It pauses at `end`.
  RunningScene(const session::MakeSource& make, const session::SessionOptions& options, Duration end);
  ~RunningScene();
  RunningScene(const RunningScene&) = delete;
  RunningScene& operator=(const RunningScene&) = delete;

  [[nodiscard]] session::Session& session() { return *session_; }
  /// For data that never changes while it runs; for everything else there is Session::visit. When it has ended: for everything.
  [[nodiscard]] scene::Scene& scene() { return session_->scene(); }

  /// Whether the run has ended: by finish(), a stop, or an error.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Ends the thread. Throws the error that has ended it early.
  void finish();

 private:
  std::unique_ptr<session::Session> session_;
  std::exception_ptr trouble_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace murosimf::viewer
