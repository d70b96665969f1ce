/// run_watch.h - detects falls, goals and freezing while a scene runs.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::recording {

class RunWatch {
 public:
  /// `what`: of watchable(). The scene must outlive it.
  RunWatch(const scene::Scene& scene, std::set<std::string> what);

  /// Events since the last call, as texts. Between two steps, of an initialized scene.
  [[nodiscard]] std::vector<std::string> look();

 private:
  struct Watched {
    const Entity* entity = nullptr;
    double falls = 0;
    bool frozen = false;
  };

  const scene::Scene& scene_;
  std::set<std::string> what_;
  std::vector<Watched> entities_;
  bool in_goal_ = false, begun_ = false;
};

/// The goal that has the whole ball behind its line, between the posts and under the crossbar: +1, the one at positive x; -1, the other one; 0:
/// none has it.
[[nodiscard]] int goal_with_ball(const scene::Scene& scene);

/// "fall": a base tilted over 60 degrees. "goal": ball_in_goal() becomes true. "freeze": an entity was
/// frozen because of invalid numbers. "asked": Recorder::ask, which is handled outside of RunWatch.
[[nodiscard]] const std::vector<std::string>& watchable();

}  // namespace murosimf::recording
