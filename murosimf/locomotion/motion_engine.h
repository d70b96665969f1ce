/// motion_engine.h - algorithm: stands, walks, plays motions, and gets up after a fall, from the robot's own sensors.
///
/// Modes (motion_state.h), later ones precede earlier ones:
///     walk      stands or walks with the velocity in `walk_command` (balanced_gait.h); without a command and undisturbed it stands,
///               its feet as far apart as where key frames begin
///     play      a key-frame motion that `motion_request` asked for (motion_state.h). It begins when the robot has stopped, a dive at once;
///               `lie_down` ends lying, and the robot lies until it is asked to walk or for a motion get_up_*;
///               a kick that `kick_request` asked for, when the robot has walked to where it sends the ball there (kick_plan.h)
///     protect   it falls (leans over 35 degrees): plays protect_front, _back, _left or _right, if the robot has it
///     lie       it has fallen (60 degrees): waits until it lies still
///     get_up    plays get_up_front, _back, _left or _right by the side that it lies on, and again if it does not stand then
/// A motion begins with a blend from the present joint targets, in the time that the slowest joint needs; targets never change by more than
/// a joint's largest rate (dynamics/rate_limit.h).
/// Control software may take joints from the engine, and give them back, at any time (`motion_joints`). While it has one of a leg, the engine moves
/// none and answers no request; when all legs are the engine's again it stands up from the present targets, or gets up.
/// At `kinematic_walking`, where robots cannot fall, a dive is a wide step to its side (wide_step.h), and motions for robots that fall or
/// lie are not played.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "murosimf/locomotion/arm_swing.h"
#include "murosimf/locomotion/balanced_gait.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/keyframe_targets.h"
#include "murosimf/locomotion/kick_plan.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

struct MotionEngineOptions {
  WalkParameters walk;
  GaitFeedback feedback;
  double stance = 0;     ///< [m] distance of the ankles from the middle while it stands
  StepTablePtr steps;    ///< null: walks without feedback
  NamedMotions motions;  ///< in the order of their names
};

/// What the model's file gives; `given` (balanced_walk_options) precedes it. Throws SetupError as gait_feedback.
[[nodiscard]] MotionEngineOptions motion_engine_options(const Model& model, const OptionValues& given);

class MotionEngine final : public Algorithm {
 public:
  /// `command` [m/s, m/s, rad/s]: walk_command until another is set. Throws SetupError if the robot lacks sensors (walk_senses.h) or
  /// legs (leg.h), or a motion does not fit the model.
  MotionEngine(Setup& setup, const Vec3d& command, const MotionEngineOptions& options);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  struct PlayedMotion {
    std::string name;
    KeyframeMotion motion;
    double duration = 0;  // [s]
    KeyframeTargets targets;
    std::vector<double> values;  // of this instant, by column
    bool dives = false;
    bool lies = false;   ///< the robot is meant to go down, or to come from there
    bool rests = false;  ///< it stays down until it is asked to walk or to get up
    int standing = -1;   ///< what is played instead where a robot cannot fall: itself, a wide step, or -1, nothing
  };

  void read_requests() noexcept;
  void add_motion(const Model& model, const NamedMotion& motion);
  void request_motion(int motion) noexcept;
  void request_kick() noexcept;
  void approach(double dt) noexcept;
  [[nodiscard]] PlayedMotion& played() noexcept;
  void choose(double dt) noexcept;
  void begin(MotionMode mode, int motion) noexcept;
  void lie_down() noexcept;
  void walk(double dt) noexcept;
  void play() noexcept;
  void blend_from_start() noexcept;
  void write_motion(PlayedMotion& played, double time) noexcept;
  void write_walk(const GaitPose& pose) noexcept;
  void limit_rates(double dt) noexcept;
  [[nodiscard]] bool has(int joint) const noexcept { return own_.empty() || own_[joint] != 0; }
  [[nodiscard]] bool has_legs() const noexcept;
  void stand_aside() noexcept;
  [[nodiscard]] double blend_time() const noexcept;
  [[nodiscard]] MotionMode mode() const noexcept { return static_cast<MotionMode>(state_.mode); }
  [[nodiscard]] bool rests() const noexcept;
  [[nodiscard]] bool can_fall() const noexcept { return dynamic_ != 0; }
  [[nodiscard]] int find_motion(std::string_view kind) const noexcept;

  const std::array<Leg, 2>& legs_;
  BalancedGait gait_;
  ArmSwing arms_;
  WalkSenses senses_;
  GaitClock clock_;
  std::vector<PlayedMotion> motions_;  // the robot's, and wide steps behind them
  std::size_t named_ = 0;              // number of the robot's own
  std::vector<KickChoice> kicks_;
  std::vector<int> joints_;
  std::vector<double> rates_;    // [rad/s | m/s] by object
  std::vector<double> rest_;     // [rad | m] by object
  std::vector<double> next_;     // [rad | m] targets of this cycle, by object; made anew in each
  std::span<const double> own_;  // 0: control software moves it, by object; empty: no software can
  const double& dynamic_;        // 0: at kinematic_walking, which cannot fall: sensors are ignored
  const MotionRequests& requests_;
  const KickRequest& kick_request_;
  GaitState& gait_state_;
  MotionState& state_;
  const Vec3d& odometry_;
  std::span<double> start_;   // [rad | m] by object
  std::span<double> target_;  // [rad | m] by object
};

}  // namespace murosimf::locomotion
