/// balanced_gait.h - the walk of gait.h with feedback: joint targets of the legs for each control cycle.
///
/// While it walks, deviations count from the steady walk (step_table.h); a robot without a table walks without feedback. While it
/// stands, they count from its own rest position, ankles respond, and what ankles cannot hold makes it step (gait_feedback.h).
/// The stance may be narrower than the walk: each foot moves there in its last steps, and back in its first ones.
#pragma once

#include <optional>

#include "murosimf/locomotion/gait_clock.h"
#include "murosimf/locomotion/gait_feedback.h"
#include "murosimf/locomotion/walk_senses.h"

namespace murosimf::locomotion {

class BalancedGait {
 public:
  /// `stance` [m]: distance of the ankles from the middle while it stands; `table` may be null.
  BalancedGait(const std::array<Leg, 2>& legs, const WalkParameters& walk, const GaitFeedback& feedback, double stance,
               StepTablePtr table);

  /// Sets the width of the stance in `state`.
  void stand(GaitState& state) const noexcept { state.width.fill(stands_wider_); }
  /// The pose of the legs at rest.
  [[nodiscard]] GaitPose stance() const noexcept;
  [[nodiscard]] const Vec3d& fastest() const noexcept { return walk_.fastest; }  ///< [m/s, m/s, rad/s]
  /// Updates the signals after a cycle of `dt` [s] in which the joints had the `targets` [rad], by object.
  void feel(double dt, const GaitClock& clock, std::span<const double> targets, WalkSenses& senses,
            GaitState& state) const noexcept;
  struct Intent {
    bool stops = false;               ///< stops, independent of the command
    bool answers = true;              ///< responds to deviations
    std::optional<Vec3d> velocity{};  ///< [m/s, m/s, rad/s] instead of the command
  };
  /// The pose of the next cycle. `start` as in gait_pose.
  [[nodiscard]] GaitPose step(double dt, GaitClock& clock, const WalkSenses& senses, GaitState& state,
                              const GaitPose& start, const Intent& intent) const noexcept;

 private:
  void find_deviation(const GaitClock& clock, GaitState& state) const noexcept;
  [[nodiscard]] bool has_width(const GaitState& state, double width) const noexcept;
  void feel_slope(double dt, const GaitClock& clock, const WalkSenses& senses, GaitState& state) const noexcept;
  void move_apart(double dt, const GaitClock& clock, double width, GaitState& state) const noexcept;
  void follow_command(double dt, std::size_t stood, const GaitClock& clock, const GaitLimits& limits,
                      const WalkSenses& senses, GaitState& state) const noexcept;
  void watch(double dt, GaitClock& clock, GaitState& state) const noexcept;
  [[nodiscard]] double phase_rate(const GaitState& state) const noexcept;
  void place_steps(double dt, const GaitClock& clock, std::size_t stood, double left, GaitState& state) const noexcept;
  [[nodiscard]] GaitFeet open_loop(const GaitClock& clock, const GaitState& state) const noexcept;
  void turn_feet(const GaitClock& clock, const GaitState& state, GaitFeet& feet) const noexcept;
  [[nodiscard]] GaitPose bend_legs(const GaitClock& clock, const GaitFeet& feet, GaitState& state,
                                   const GaitPose& start) const noexcept;

  const std::array<Leg, 2>& legs_;
  WalkParameters walk_;
  GaitFeedback feedback_;
  double stands_wider_;  // [m] than it walks, of each ankle
  StepTablePtr table_;
  std::array<std::size_t, 2> roll_hinge_{};  // of the legs' hinges: the first about the forward axis
  std::array<double, 2> roll_sign_{};        // 1: it turns about +x; 0: the leg has none
};

}  // namespace murosimf::locomotion
