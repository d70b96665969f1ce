/// run_watch.h - notices falls, goals and freezing while a scene runs.
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

  /// What has happened since it was last asked, in words. Between two steps, of a scene that is initialized.
  [[nodiscard]] std::vector<std::string> look();

 private:
  struct Watched {
    const Entity* entity = nullptr;
    double falls = 0;
    bool frozen = false;
  };
  [[nodiscard]] bool ball_in_goal() const;

  const scene::Scene& scene_;
  std::set<std::string> what_;
  std::vector<Watched> entities_;
  bool in_goal_ = false, begun_ = false;
};

/// "fall": a base tilted over 60 degrees. "goal": all of the ball is over a goal line, between the posts and under the crossbar.
/// "freeze": numbers of somebody went bad. "asked": Recorder::ask, of which RunWatch knows nothing.
[[nodiscard]] const std::vector<std::string>& watchable();

}  // namespace murosimf::recording
