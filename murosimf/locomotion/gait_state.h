/// gait_state.h - state of the balanced gait from one control cycle to the next, besides its phase, amplitude and velocity.
#pragma once

#include <array>

#include "murosimf/locomotion/attitude_filter.h"
#include "murosimf/locomotion/step_table.h"
#include "murosimf/model/value.h"

namespace murosimf::locomotion {

inline constexpr std::size_t most_waist = 4;  ///< hinges between the base and the inertial sensor

/// Doubles and nothing else. By side: left first.
struct GaitState {
  AttitudeFilter attitude;
  std::array<Vec3d, 2> center;       ///< [m] of mass, from the ankle; axes of the base
  std::array<Vec3d, 2> center_rate;  ///< [m/s] its rate in those axes
  std::array<Vec3d, 2>
      offset;  ///< [m] of the foot from where the open-loop walk has it, level axes of the pelvis; z: 0
  std::array<double, most_waist>
      waist{};       ///< [rad] of the hinges between the base and the inertial sensor, outermost first
  Vec3d waist_rate;  ///< [rad/s] of that sensor's link against the base, axes of the base
  std::array<double, 2> roll_target{};  ///< [rad] of the hip, before sag
  std::array<double, 2> roll_lag{};     ///< [rad]
  StepSignals signals;                  ///< measured
  StepSignals deviation;                ///< from the steady walk
  double compliance = 0;                ///< [1] 0: joints are where their targets are
  double lag = 0;                       ///< [rad] mean distance of the legs' joints from their targets
  double cycles = 0;                    ///< [1] since the start, at most two
  StepSignals upright;                  ///< mean of the signals while it stands, the left foot as the standing one
  double settled = 0;                   ///< [s] length of that mean, at most one
  double still = 0;                     ///< [s] since it stands without moving
  double alarm = 0;                     ///< [s] for which it continues to step on the spot
  std::array<double, 2> width{};        ///< [m] by which each ankle is farther from the middle than in the walk
  double slope = 0;                     ///< [rad] pitch of the ground under the standing sole: above 0 downhill
  Vec3d trim;                 ///< [m/s, m/s, rad/s] that strides differ from the command, so that the robot follows it
  std::array<Vec3d, 2> mark;  ///< [m, m, rad] odometry where that foot began to stand
  std::array<double, 2> passed{};  ///< [s] since then; 0: it has not stood in this walk
  Vec3d foot;                      ///< [m, m, rad] standing ankle and heading of the base, from where it started
};

}  // namespace murosimf::locomotion

namespace murosimf {

template <>
struct ValueTraits<locomotion::GaitState> : OfDoubles<locomotion::GaitState> {};

}  // namespace murosimf
