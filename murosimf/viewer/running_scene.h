/// running_scene.h - a scene, or a recording of one, that a session leads through time in a thread of its own, as long as this lives.
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <thread>

#include "murosimf/session/session.h"

namespace murosimf::viewer {

class RunningScene {
 public:
  /// Throws what `make` throws. It pauses at `end`.
  RunningScene(const session::MakeCourse& make, const session::SessionOptions& options, Duration end);
  ~RunningScene();
  RunningScene(const RunningScene&) = delete;
  RunningScene& operator=(const RunningScene&) = delete;

  [[nodiscard]] session::Session& session() { return *session_; }
  /// For what never changes while it runs; for everything else there is Session::visit. When it has ended: for all.
  [[nodiscard]] scene::Scene& scene() { return session_->scene(); }

  /// Nothing is run any more: by finish(), a stop, or something that went wrong.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Ends the thread. Throws what has ended it early.
  void finish();

 private:
  std::unique_ptr<session::Session> session_;
  std::exception_ptr trouble_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace murosimf::viewer
