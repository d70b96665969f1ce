/// motion_trials.h - plays key-frame motions under many circumstances at once, and computes their costs.
///
/// Of one run, T the motion's duration, each part from 0 to about 1, what counts first with a step of 1:
///     stands   [not standing] + 1 - u + e, u the mean over 1.2 s after T of half the cosine of the torso's lean and half its height, over the
///              height in the last frame (at most 1); standing: leans less than 37 degrees (0.8) and is 0.85 of that high, all of the 1.2 s
///     kicks    [fell or not standing at the end] + 1.5/(1.5 + v) + e, v [m/s] the ball's largest speed in the wanted direction, at least 0
///     lies     [not lying at the end] + min(1, t/1 s) + (1 - w)/2 + e, t when the torso leans by 60 degrees first, w how far it
///              goes in the wanted direction until 0.6 s after T, over its height, 0 to 1; lying: leans by more than 60 degrees
///     e        0.05 effort + 0.05 haste + 0.02 T/(1 s): effort the mean over joints and time of (torque / stall torque)^2, each at most 4, at levels
///              that have torques; haste the mean over frames of (largest rate of a target / that of its joint)^2
/// Sensors are off: key frames read none.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/runtime/pacer.h"
#include "murosimf/scene_file/ball.h"
#include "murosimf/studies/motion_space.h"
#include "murosimf/studies/tuning_cases.h"

namespace murosimf::studies {

enum class MotionGoal : std::uint8_t { stands, kicks, lies };

struct MotionTask {
  MotionGoal goal = MotionGoal::stands;
  double roll = 0, pitch = 0;              ///< [rad] in which it begins
  double direction = 0;                    ///< [rad] wanted, counterclockwise from where it looks
  Vec3d ball;                              ///< [m] where the ball lies, from the robot: of a kick
  scene_file::BallOptions ball_options{};  ///< likewise
  double fastest = 0;                      ///< [rad/s] motion_space.h
  int threads = 1;
  StopRequest stop{};
};

struct MotionOutcome {
  bool good = false;  ///< the bracket from above is 0
  double cost = 0;
};

class MotionTrials {
 public:
  /// All live as long. Throws SetupError for a scene that cannot be built: a level that cannot begin so, or a model without what it needs.
  MotionTrials(const VariedRobot& robot, const locomotion::KeyframeMotion& motion, MotionTask task);
  ~MotionTrials();

  /// By motion, then by case; empty if it was stopped. The motions have the columns of the first. The same for any number of threads.
  [[nodiscard]] std::vector<std::vector<MotionOutcome>> run(const std::vector<locomotion::KeyframeMotion>& motions,
                                                            const std::vector<TuningCase>& cases);

 private:
  struct World;
  [[nodiscard]] std::unique_ptr<World> make_world(const TuningCase& one, std::size_t robots) const;

  const VariedRobot& robot_;
  locomotion::KeyframeMotion motion_;
  MotionTask task_;
  MotionSpace space_;
  double height_ = 0;  // [m] of the base when the robot stands as in the last frame
  std::vector<std::unique_ptr<World>> worlds_;
  std::vector<std::string> worlds_of_;  // what they were built for
};

}  // namespace murosimf::studies
