/// motion_tuning.h - a key-frame motion made better by playing it: `murosimf tune MOTION`.
///
///     const studies::MotionTuning tuned = studies::tune_motion({.motion = "get_up_front", .model = "kid21", .task = {.pitch = pi / 2}});
///     files::write_file("better.toml", to_toml(tuned, "found by tune_motion"));
///
/// CMA-ES (cost_search.h) over the numbers of motion_space.h; costs are those of motion_trials.h, under ten cases of every level
/// (tuning_cases.h), mean and worst level together. Start and best are then tried in twenty other cases of every level. The same options give
/// the same motion for any number of threads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "murosimf/scene/scene_options.h"
#include "murosimf/studies/cost_search.h"
#include "murosimf/studies/motion_trials.h"

namespace murosimf::studies {

/// The levels at which motions are tuned, if nothing else is said.
[[nodiscard]] const std::vector<std::string>& usual_tuning_levels();

/// What is the same for all searches of this folder.
struct TuningBudget {
  std::size_t evaluations = 480;
  double minutes = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;
  std::filesystem::path state;  ///< cost_search.h
  std::string program;          ///< whose states may be taken over
  std::function<void(const CostSearchProgress&)> progress{};
};

struct MotionTuningOptions {
  std::string motion;  ///< a file, or the name of one that comes with the program
  std::string model;   ///< as in scenes
  MotionTask task;     ///< its `threads` and `stop` are not used
  std::vector<std::string> levels = usual_tuning_levels();
  TuningBudget budget;
  scene::SceneOptions common{};  ///< threads, stop, lenient
};

/// How many runs of a level were good.
struct TuningCheck {
  std::string level;
  std::size_t before = 0, after = 0, runs = 0;
};

struct MotionTuning {
  MotionGoal goal = MotionGoal::stands;
  locomotion::KeyframeMotion before, after;
  double rate_before = 0, rate_after = 0;  ///< [rad/s] largest of a target
  CostSearch search;
  std::vector<TuningCheck> checks;  ///< none: it was stopped
};

/// Throws SetupError: an unknown motion, model or level, joints that the model does not have, a state of another search.
[[nodiscard]] MotionTuning tune_motion(const MotionTuningOptions& options);

/// Text for users.
[[nodiscard]] std::string to_text(const MotionTuning& tuning);
/// A motion as scenes read it; `how`: lines for its head, like the command.
[[nodiscard]] std::string to_toml(const MotionTuning& tuning, const std::string& how);

// What searches share.

/// "cost 0.51 before, 0.087 after 480 evaluations in 30 generations"
[[nodiscard]] std::string search_text(const CostSearch& search);
/// A table: in how many runs of each level something was so, before and after.
[[nodiscard]] std::string checks_text(const std::vector<TuningCheck>& checks, const std::string& what);
/// The same lines as comments of a TOML file.
[[nodiscard]] std::string as_comment(const std::string& text);
/// Throws SetupError for a level at which robots always stand: "at level 'kinematic_walking' robots always stand: `so`".
void refuse_levels_that_stand(const std::vector<std::string>& levels, const std::string& so);
/// [points] of a generation: the usual ones of CMA-ES, filled up to rows of robots that step together.
[[nodiscard]] std::size_t population_for(std::size_t numbers);

}  // namespace murosimf::studies
