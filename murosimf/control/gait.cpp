#include "murosimf/control/gait.h"

#include <cmath>

#include "murosimf/control/leg_ik.h"

namespace murosimf::control {
namespace {

/// Progress of one foot through its half steps.
struct Stride {
  double xi = 0;    ///< [1] place along the stride, +1/2 front, -1/2 back
  double lift = 0;  ///< [1] 0 on the ground, 1 at the top
};

/// p: phase of this foot, its swing is inside (0, pi).
Stride stride(double p, double d) {
  if (p < 0) p += 2 * pi;
  if (p > d && p < pi - d) {
    const double u = (p - d) / (pi - 2 * d);
    return {-0.5 * std::cos(pi * u), 0.5 * (1 - std::cos(2 * pi * u))};
  }
  double since_landing = p - (pi - d);
  if (since_landing < 0) since_landing += 2 * pi;
  return {0.5 - since_landing / (pi + 2 * d), 0};
}

}  // namespace

WalkParameters seeded_parameters(const std::array<Leg, 2>& legs) {
  constexpr double kid21_leg = 0.24;             // [m] thigh and shin
  constexpr double kid21_half_hip_width = 0.05;  // [m]
  constexpr double gravity = 9.81;               // [m/s^2]
  WalkParameters p;
  const double scale = (legs[0].thigh + legs[0].shin) / kid21_leg;
  const double half_hip_width = 0.5 * (legs[0].hip.y - legs[1].hip.y);
  const double kid21_ankle_height = 0.04;  // [m]
  p.hip_height = (p.hip_height - kid21_ankle_height) * scale + legs[0].ankle_height;
  p.period *= std::sqrt(scale);
  p.lift *= scale;
  p.setback *= scale;
  p.half_width = half_hip_width + (p.half_width - kid21_half_hip_width) * scale;
  p.slew.x *= scale;
  p.slew.y *= scale;
  p.fastest.x *= std::sqrt(scale);
  p.fastest.y *= std::sqrt(scale);
  const double w = std::sqrt(gravity / (1.072 * p.hip_height));
  p.sway = half_hip_width * (1 - 1 / std::cosh(w * p.period / 4));
  return p;
}

GaitPose gait_pose(const std::array<Leg, 2>& legs, const WalkParameters& p, double phase, double amplitude,
                   const Vec3d& velocity) noexcept {
  const double d = p.double_support * pi / 2;
  const double stance_time = p.period * (pi + 2 * d) / (2 * pi);
  const double sway = amplitude * p.sway * std::sin(phase + p.lead);
  const Mat3d level_to_pelvis = rotation_y(-p.pitch);
  GaitPose pose;
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs[side];
    const double outward = side == 0 ? 1 : -1;
    const Stride s = stride(side == 0 ? phase - pi : phase, d);
    const Vec3d ankle{s.xi * velocity.x * stance_time - p.setback,
                      outward * p.half_width - leg.hip.y + s.xi * velocity.y * stance_time - sway,
                      -p.hip_height + leg.ankle_height + amplitude * p.lift * s.lift};
    const Mat3d foot = level_to_pelvis * rotation_z(s.xi * velocity.z * stance_time);
    const LegAngles angles = leg_angles(leg.thigh, leg.shin, level_to_pelvis * ankle, foot);
    pose.q[side] = angles.q;
    pose.reachable = pose.reachable && angles.reachable;
    const double standing = side == 0 ? std::sin(phase) : -std::sin(phase);
    if (standing > 0) pose.q[side][1] += outward * amplitude * p.hip_roll * standing;
  }
  return pose;
}

}  // namespace murosimf::control
