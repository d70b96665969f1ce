/// motion_report.h - the present activity of the motion engine as reported to control software, logs and players.
#pragma once

#include "murosimf/locomotion/gait_state.h"
#include "murosimf/locomotion/motion_state.h"
#include "murosimf/locomotion/named_motions.h"

namespace murosimf::locomotion {

/// [1] Cosine of the lean from which on a robot counts as fallen, 60 degrees.
inline constexpr double cos_fallen = 0.5;

/// Reported as a number; docs/library.md has the table.
enum class Activity { stand, walk, play, dive, fall, protect, lie, get_up };

struct MotionReport {
  Activity activity = Activity::stand;
  int motion = -1;      ///< number among the robot's motions of the one that is played; -1: none
  double phase = 0;     ///< [1] of that motion, 0 while the joints come to its beginning, 1 at its end
  bool fallen = false;  ///< it lies or gets up, or the torso leans over 60 degrees by its own sensors
};

/// `amplitude` [1] of the gait. Without an engine: a robot that stands.
[[nodiscard]] MotionReport motion_report(const NamedMotions& motions, const MotionState& state, const GaitState& gait,
                                         double amplitude) noexcept;

}  // namespace murosimf::locomotion
