/// gait.h - an omnidirectional open-loop walk: places of both feet at every phase.
///
/// Phase ph in [0, 2 pi); the left foot stands during (0, pi). With xi and lift of stride.h for p = ph - pi (left) or ph
/// (right) and d = double_support pi/2, the ankle in the level frame of the pelvis, x and z from the hip center, y from the middle:
///     x = xi vx Ts - x0                        z = -h + ankle height + hz lift
///     y = +-fy + xi vy Ts - ay sin(ph + lead)  yaw = xi wz Ts +- s |wz| Ts/2
/// with Ts = T (pi + 2 d)/(2 pi); the pelvis leans forward by `pitch`, and the standing leg's hip roll lifts the
/// swinging side by `hip_roll` sin(ph) against the droop of its servos.
/// Source: the project's walk study (parameters found by random search in MuJoCo on the kid21 robot).
#pragma once

#include <array>
#include <span>

#include "murosimf/locomotion/leg.h"

namespace murosimf::locomotion {

struct WalkParameters {
  double period = 0.452;           ///< [s] T, two steps
  double sway = 0.0094;            ///< [m] ay, sideways
  double lift = 0.0445;            ///< [m] hz, height of the swinging foot
  double hip_height = 0.2612;      ///< [m] h, hip center above the sole
  double setback = 0.0128;         ///< [m] x0, feet behind the hips
  double pitch = 0.031;            ///< [rad] forward lean of the pelvis
  double double_support = 0.003;   ///< [1] share of the period with both feet down
  double half_width = 0.0557;      ///< [m] fy, ankle from the middle
  double lead = -0.128;            ///< [rad] of the sway
  double hip_roll = 0.055;         ///< [rad] against droop
  double splay = 0;                ///< [1] s: 1: legs turn outward only
  double arm_swing = 0;            ///< [1] of what balances the legs about the vertical (arm_swing.h)
  Vec3d slew{0.375, 0.25, 2};      ///< [m/s^2, m/s^2, rad/s^2] of the walking velocity
  Vec3d fastest{0.25, 0.10, 0.8};  ///< [m/s, m/s, rad/s] commands beyond are clipped
};

/// Joint positions [rad] of both legs, left first, in the order of their joints.
struct GaitPose {
  std::array<std::array<double, most_hinges>, 2> q{};
  bool reachable = true;
};

/// Where the feet are, by side, left first.
struct GaitFeet {
  std::array<Vec3d, 2> ankle;    ///< [m] from the hip center, level axes of the pelvis
  std::array<Mat3d, 2> sole;     ///< their axes in those
  std::array<double, 2> roll{};  ///< [rad] added at the hip
};

/// The equations from above; strides `gain` [1] times as long, feet `setback` [m] farther behind.
[[nodiscard]] GaitFeet gait_feet(const std::array<Leg, 2>& legs, const WalkParameters& parameters, double phase,
                                 double amplitude, const Vec3d& velocity, double gain = 1, double setback = 0) noexcept;

/// Reads the joints of the legs from `values` [rad] of all objects, and writes them back.
[[nodiscard]] GaitPose pose_among(const std::array<Leg, 2>& legs, std::span<const double> values) noexcept;
void write_pose(const std::array<Leg, 2>& legs, const GaitPose& pose, std::span<double> values) noexcept;

/// The home pose of both legs.
[[nodiscard]] GaitPose home_pose(const std::array<Leg, 2>& legs) noexcept;

/// `amplitude` 0 stands, 1 walks; `velocity` [m/s, m/s, rad/s] forward, left, turning left. `start` is where the iteration of legs
/// without a closed form begins: the pose of the previous cycle, or home.
[[nodiscard]] GaitPose gait_pose(const std::array<Leg, 2>& legs, const WalkParameters& parameters, double phase,
                                 double amplitude, const Vec3d& velocity, const GaitPose& start) noexcept;
[[nodiscard]] GaitPose gait_pose(const std::array<Leg, 2>& legs, const WalkParameters& parameters, double phase,
                                 double amplitude, const Vec3d& velocity) noexcept;

}  // namespace murosimf::locomotion
