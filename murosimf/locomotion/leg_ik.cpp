#include "murosimf/locomotion/leg_ik.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

constexpr double almost_straight = 0.9995;  // [1] of the leg's length: beyond it the knee angle is ill-conditioned

}  // namespace

LegAngles leg_angles(double thigh, double shin, const Vec3d& ankle, const Mat3d& foot) noexcept {
  MUROSIMF_ASSERT(thigh > 0 && shin > 0);
  LegAngles result;
  const Vec3d r = -transposed_times(foot, ankle);
  const double longest = almost_straight * (thigh + shin);
  result.reachable = norm(r) <= longest;
  const double length = std::min(norm(r), longest);
  // At the limit the leg points at the target and stays a little bent: acos has an infinite slope for a straight leg.

  const double cos_knee = (length * length - thigh * thigh - shin * shin) / (2 * thigh * shin);
  // Rounding may bring the cosine out of [-1, 1].
  const double knee = std::acos(std::clamp(cos_knee, -1.0, 1.0));
  const double shin_to_line = std::atan2(thigh * std::sin(knee), shin + thigh * std::cos(knee));

  double ankle_roll = std::atan2(r.y, r.z);
  // A foot below the hip: of the two rolls that point the ankle at the hip, the one within a quarter turn.
  if (ankle_roll > pi / 2) ankle_roll -= pi;
  if (ankle_roll < -pi / 2) ankle_roll += pi;
  const double ankle_pitch = -std::atan2(r.x, std::copysign(std::hypot(r.y, r.z), r.z)) - shin_to_line;

  const Mat3d R = foot * rotation_x(-ankle_roll) * rotation_y(-ankle_pitch - knee);
  const double yaw = std::atan2(-R.y.x, R.y.y);
  const double roll = std::atan2(R.y.z, -R.y.x * std::sin(yaw) + R.y.y * std::cos(yaw));
  const double pitch = std::atan2(-R.x.z, R.z.z);
  result.q = {yaw, roll, pitch, knee, ankle_pitch, ankle_roll};
  return result;
}

}  // namespace murosimf::locomotion
