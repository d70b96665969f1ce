#include "murosimf/locomotion/leg_shape.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

constexpr double sideways = 0.7;   // [1] of a knee's axis
constexpr double shortest = 1e-3;  // [m] of thigh and shin
constexpr double one_sided =
    1.5;  // [1] ratio of a range's two sides from which on it determines the direction of a knee

double distance_from_axis(const ChainPose& pose, std::size_t hinge, const Vec3d& point) {
  MUROSIMF_ASSERT(hinge < most_hinges);
  return norm(tangential(point - pose.place[hinge], pose.axis[hinge]));
}

std::size_t find_knee(const ChainPose& pose, std::size_t hinges) {
  MUROSIMF_ASSERT(hinges >= 3 && hinges <= most_hinges);
  std::size_t knee = 1;
  double widest = -1;
  for (std::size_t i = 1; i < hinges; ++i) {
    const double width = std::min(distance_from_axis(pose, i, pose.place[0]), distance_from_axis(pose, i, pose.tip));
    if (width <= widest) continue;  // of equal widths the inner hinge, whatever the rounding of the outer ones
    widest = width;
    knee = i;
  }
  return knee;
}

/// Finds angle and direction of the knee's bend from the two ends of the leg, seen from the knee and square to its axis.
void find_bend(const LegHinge& knee, const Vec3d& axis, const Vec3d& to_hip, const Vec3d& to_ankle, LegShape& shape) {
  MUROSIMF_ASSERT(std::abs(norm(axis) - 1) < 1e-6);
  shape.straight = std::atan2(dot(axis, cross(to_ankle, -to_hip)), dot(to_ankle, -to_hip));
  const double up = knee.highest - shape.straight, down = shape.straight - knee.lowest;
  if (up > one_sided * down) {
    shape.bend = 1;
  } else if (down > one_sided * up) {
    shape.bend = -1;
  } else {
    shape.bend = cross(axis, -to_hip).x < 0 ? 1 : -1;  // the foot of a straight leg goes back
  }
}

}  // namespace

LegShape shape_of(const LegChain& chain, std::string& problem) {
  LegShape shape;
  const std::size_t hinges = chain.hinges.size();
  if (hinges < 3) {
    problem = fmt::format("{} hinges are no leg: it takes 3 to place a foot", hinges);
    return shape;
  }
  const std::array<double, most_hinges> zero{};
  const ChainPose pose = pose_of(chain, std::span(zero).first(hinges));
  shape.knee = find_knee(pose, hinges);
  const Vec3d& place = pose.place[shape.knee];
  const Vec3d& axis = pose.axis[shape.knee];
  shape.hip = center_of_axes(pose, 0, shape.knee, pose.place[shape.knee - 1]);
  shape.ankle = center_of_axes(pose, shape.knee + 1, hinges, pose.tip);
  const Vec3d to_hip = tangential(shape.hip - place, axis), to_ankle = tangential(shape.ankle - place, axis);
  shape.thigh = norm(to_hip);
  shape.shin = norm(to_ankle);
  if (std::abs(axis.y) < sideways) {
    problem = fmt::format("its knee turns about ({:.3g} {:.3g} {:.3g}), not sideways", axis.x, axis.y, axis.z);
  } else if (shape.thigh < shortest || shape.shin < shortest) {
    problem = "no hinge of it is a knee, away from both hip and sole";
  }
  find_bend(chain.hinges[shape.knee], axis, to_hip, to_ankle, shape);
  return shape;
}

}  // namespace murosimf::locomotion
