/// motion_state.h - requests to the motion engine and its state (motion_engine.h).
#pragma once

#include <array>

#include "murosimf/math/vec3.h"
#include "murosimf/model/value.h"

namespace murosimf::locomotion {

inline constexpr std::size_t most_motions = 32;  ///< of one robot

/// One number for each motion of a robot, in the order of their names. A change to another number than 0 requests the motion, once.
struct MotionRequests {
  std::array<double, most_motions> number{};
};

/// A kick in a direction: the engine chooses the motion, walks to where it kicks so, and plays it (kick_plan.h).
struct KickRequest {
  double number = 0;     ///< a change to another than 0 requests it, once; 0: one to which it still walks is dropped
  double direction = 0;  ///< [rad] in which the ball shall go, in the robot's frame, to the left of forward
  double side = 0;       ///< of the foot that kicks: above 0 left, below 0 right, 0 either
  /// [m] where it lies, in the robot's frame; both 0: where the motion has it, once the robot has turned
  double ball_x = 0;
  double ball_y = 0;
};

enum class MotionMode { walk, play, protect, lie, get_up };

/// Doubles and nothing else, so that it is a property.
struct MotionState {
  double mode = 0;      ///< a MotionMode
  double motion = -1;   ///< number of the one that is played, from 0; -1: none
  double time = 0;      ///< [s] since it began
  double blend = 0;     ///< [s] in which the joints come from where they were
  double duration = 0;  ///< [s] of that motion
  double quiet = 0;     ///< [s] for which it lies without moving
  double falls = 0;     ///< [1] so far; dives do not count
  MotionRequests seen;  ///< in the cycle before
  // a kick to which it walks
  double kick = -1;      ///< number of its motion; -1: none
  double kick_seen = 0;  ///< number of the request in the cycle before
  double approach = 0;   ///< [s] since it began
  Vec3d goal;            ///< [m, m, rad] where it kicks, in the frame of the odometry
  Vec3d ball;            ///< [m] likewise, z: 0
  double clearance = 0;  ///< [m] from the ball on the way; 0: its place is unknown
  Vec3d place;           ///< [m, m, rad] the odometry, without the sway of the steps
};

}  // namespace murosimf::locomotion

namespace murosimf {

template <>
struct ValueTraits<locomotion::MotionRequests> : OfDoubles<locomotion::MotionRequests> {};
template <>
struct ValueTraits<locomotion::KickRequest> : OfDoubles<locomotion::KickRequest> {};
template <>
struct ValueTraits<locomotion::MotionState> : OfDoubles<locomotion::MotionState> {};

}  // namespace murosimf
