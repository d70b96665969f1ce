/// running_scene.h - a scene that a session runs in a thread of its own, as long as this lives.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <thread>

#include "murosimf/session/session.h"

namespace murosimf::viewer {

using MakeScene = std::function<std::unique_ptr<scene::Scene>()>;

class RunningScene {
 public:
  /// Throws what `make` throws. It pauses at `end`.
  RunningScene(const MakeScene& make, const session::SessionOptions& options, Duration end);
  ~RunningScene();
  RunningScene(const RunningScene&) = delete;
  RunningScene& operator=(const RunningScene&) = delete;

  [[nodiscard]] session::Session& session() { return *session_; }
  /// For what never changes while it runs; for everything else there is Session::visit. When it has ended: for all.
  [[nodiscard]] scene::Scene& scene() { return *scene_; }

  /// Nothing is run any more: by finish(), a stop, or something that went wrong.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Ends the thread. Throws what has ended it early.
  void finish();

 private:
  std::unique_ptr<scene::Scene> scene_;
  std::unique_ptr<session::Session> session_;
  std::exception_ptr trouble_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace murosimf::viewer
