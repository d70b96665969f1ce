/// score_keeper.h - the score of a scene's two teams at any instant: as a referee said, or else by counting goals.
///
/// Counted is how often the ball comes into a goal (run_watch.h); the goal is one for the team that attacks it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "murosimf/recording/moments.h"
#include "murosimf/recording/recorded_run.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

class ScoreKeeper {
 public:
  /// Keeps nothing of the scene. Throws SetupError: it does not have two teams.
  explicit ScoreKeeper(const scene::Scene& scene);

  /// Counts the goals of a scene that runs, from now on; it must outlive the run, at the same address. After initialize().
  void watch(scene::Scene& scene);
  /// Counts goals that were found in a recording; once.
  void count(const std::vector<Moment>& moments);
  /// Takes the scores in the referee's packets of a recorded run. False, and without effect: there was no referee.
  bool hear(const RecordedRun& run);

  /// By team, in the scene's order.
  [[nodiscard]] std::array<int, 2> at(Duration time) const;

 private:
  struct Change {
    Duration time{};
    std::array<int, 2> goals{};
  };
  void add(Duration time, int goal);
  void look(scene::Scene& scene);

  std::array<double, 2> attacks_{};
  std::array<int, 2> numbers_{};  // of the teams, for a referee
  std::vector<Change> changes_;   // by time
  int goal_ = 0;                  // in which the ball is; 0: in none
};

}  // namespace murosimf::recording
