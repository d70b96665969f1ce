/// step_learning.h - how the steady walk of a robot looks to its own sensors (locomotion/step_table.h), learned by walking.
///
/// The robot walks undisturbed on the plane (scene `walk`, controller `motions`) with several commands, at levels whose joints are rigid and
/// at one with servos: first without feedback, then with the feedback that counts from what was learned before. What its control
/// cycles measured is fitted by least squares. The same robot gives the same table for any number of threads.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/locomotion/step_table.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene_options.h"

namespace murosimf::studies {

struct StepLearningOptions {
  std::string model;  ///< as in scenes: a file, or the name of one that comes with the program
  std::vector<std::string> rigid{"simplified_dynamics", "full_dynamics"},
      compliant{"articulated_dynamics"};            ///< levels
  double duration = 6;                              ///< [s] of each walk
  int rounds = 3;                                   ///< the first one without feedback
  std::shared_ptr<const scene::RobotKind> robot{};  ///< instead of what the file of the model says; null: that
  OptionValues balance{};        ///< numbers of [balance] (locomotion/gait_feedback.h), instead of the robot's own
  scene::SceneOptions common{};  ///< of all walks; `threads`: walks at a time, each is stepped by one
  std::function<void(std::size_t done, std::size_t all)> progress{};  ///< from any thread, one at a time
};

struct StepLearning {
  locomotion::StepTable table;
  struct Round {
    std::size_t walks = 0, fell = 0, samples = 0;
    double error = 0;  ///< [m] root of the mean square of xi - the fitted course
  };
  std::vector<Round> rounds;
  bool stopped = false;  ///< by common.stop
};

/// The model with these numbers of [balance] before its own ones, and this table instead of its own; null: it walks without feedback.
[[nodiscard]] ModelPtr with_balance(const Model& model, const OptionValues& balance,
                                    const locomotion::StepTablePtr& steps);

/// Throws SetupError: a robot that cannot be read or has no legs to walk with, or an unknown level.
[[nodiscard]] StepLearning learn_steps(const StepLearningOptions& options);

/// Text for users: a line for each round.
[[nodiscard]] std::string to_text(const StepLearning& learning);

}  // namespace murosimf::studies
