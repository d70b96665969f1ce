#include "murosimf/robot/robot_feet.h"

#include <algorithm>
#include <cmath>

#include "murosimf/geometry/support.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot/body_names.h"
#include "murosimf/robot/robot_soles.h"

namespace murosimf::robot {
namespace {

constexpr double level_feet = 0.01;       // [m] feet may end at slightly different heights
constexpr std::size_t joints_of_leg = 2;  // at least; a body behind fewer is carried like the base
constexpr double off_balance =
    0.1;  // [1] distance of the center of mass from the area between the feet, over its height
constexpr double endless = 4 * pi;  // [rad] a wider range is no limit
constexpr double roundness = 0.9;   // [1] smallest reach of a wheel over its largest
constexpr double level_axis = 0.3;  // [1] sine of an axle's slope at most
constexpr int around = 32;          // directions

using robot_formats::BodyDescription;
using robot_formats::RobotDescription;

std::size_t joints_above(const RobotDescription& description, std::size_t body) {
  MUROSIMF_ASSERT(body < description.bodies.size());
  std::size_t count = 0;
  for (int b = static_cast<int>(body); b >= 0; b = description.bodies[b].parent)
    count += description.bodies[b].joints.size();
  return count;
}

bool is_endless(const robot_formats::JointDescription& joint) {
  return joint.kind == Kind::revolute && (!joint.range || joint.range->y - joint.range->x > endless);
}

/// [m] Distance to which the colliding shapes of a body extend from a point of it; body frame.
double reach(const BodyDescription& body, const Vec3d& from, const Vec3d& direction) {
  double farthest = 0;
  for (const robot_formats::ShapeDescription& shape : body.shapes) {
    if (!shape.placed.collides) continue;
    const Transformd place = shape.placed.place();
    const Vec3d tip = geometry::support(shape.placed.shape, transposed_times(place.orientation, direction));
    farthest = std::max(farthest, dot(direction, place.position + place.orientation * tip - from));
  }
  return farthest;
}

/// Round about a level joint that turns without end.
bool is_wheel(const BodyDescription& body, const Transformd& place) {
  if (body.joints.empty() || !is_endless(body.joints.back())) return false;
  const robot_formats::JointDescription& joint = body.joints.back();
  const Vec3d axis = (1.0 / norm(joint.axis)) * joint.axis;
  if (std::abs((place.orientation * axis).z) > level_axis) return false;
  const Vec3d other = std::abs(axis.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d u = (1.0 / norm(cross(axis, other))) * cross(axis, other), v = cross(axis, u);
  double least = 1e300, most = 0;
  for (int i = 0; i < around; ++i) {
    const double angle = i * 2 * pi / around;
    const double radius = reach(body, joint.anchor, std::cos(angle) * u + std::sin(angle) * v);
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  return least > roundness * most;
}

/// The body, or one on the way to it from the base, is part of a hand by its name.
bool is_hand(const RobotDescription& description, std::size_t body) {
  MUROSIMF_ASSERT(body < description.bodies.size());
  for (int b = static_cast<int>(body); b > 0; b = description.bodies[b].parent) {
    const std::string& name = description.bodies[b].name;
    if (names_hand(name) || names_finger(name)) return true;
  }
  return false;
}

bool hangs_on(const RobotDescription& description, std::size_t body, std::size_t other) {
  // Parents precede their children: the way to the base passes `other` or a smaller index.
  MUROSIMF_ASSERT(body < description.bodies.size() && other < description.bodies.size());
  int b = static_cast<int>(body);
  while (b > static_cast<int>(other)) b = description.bodies[b].parent;
  return b == static_cast<int>(other);
}

/// Toes, which are behind another foot, are parts of it.
void join_toes(const RobotDescription& description, std::vector<std::size_t>& feet) {
  const std::vector<std::size_t> all = feet;
  std::erase_if(feet, [&](std::size_t body) {
    return std::ranges::any_of(all,
                               [&](std::size_t other) { return other != body && hangs_on(description, body, other); });
  });
}

/// Whether the center of mass is above the area between the feet, or nearly so: in no horizontal direction is it farther out
/// than every foot.
bool bear_weight(const RobotDescription& description, const std::vector<Transformd>& places,
                 const std::vector<std::size_t>& feet, double ground) {
  std::vector<Vec3d> points;
  for (const std::size_t foot : feet) {
    for (const Vec3d& p : low_points(description.bodies[foot], places[foot])) {
      MUROSIMF_ASSERT(foot < places.size());
      if (p.z <= ground + level_feet) points.push_back(p);
    }
  }
  const robot_formats::MassProperties robot = whole_solid(description);
  if (robot.mass == 0) return true;
  const double tolerance = off_balance * (robot.center.z - ground);
  for (int i = 0; i < around; ++i) {
    const Vec3d out{std::cos(i * 2 * pi / around), std::sin(i * 2 * pi / around), 0};
    const auto by_reach = [&](const Vec3d& p) { return dot(p, out); };
    if (dot(robot.center, out) > by_reach(*std::ranges::max_element(points, {}, by_reach)) + tolerance) return false;
    MUROSIMF_ASSERT(!points.empty());
  }
  return true;
}

bool alike(const RobotDescription& description, const std::vector<std::size_t>& feet) {
  return std::ranges::all_of(feet, [&](std::size_t foot) {
    MUROSIMF_ASSERT(!feet.empty());
    return joints_above(description, foot) == joints_above(description, feet.front());
  });
}

}  // namespace

std::vector<std::size_t> find_feet(const RobotDescription& description) {
  const auto places = body_places(description);
  std::vector<double> bottoms;
  for (std::size_t i = 0; i < description.bodies.size(); ++i)
    bottoms.push_back(lowest(low_points(description.bodies[i], places[i])));
  const double ground = *std::ranges::min_element(bottoms);
  MUROSIMF_ASSERT(!bottoms.empty());
  std::vector<std::size_t> feet;
  for (std::size_t i = 0; i < bottoms.size(); ++i) {
    if (!std::isfinite(bottoms[i]) || bottoms[i] > ground + level_feet) continue;
    if (joints_above(description, i) < joints_of_leg || is_wheel(description.bodies[i], places[i])) return {};
    if (!is_hand(description, i)) feet.push_back(i);
  }
  join_toes(description, feet);
  if (feet.empty() || !alike(description, feet) || !bear_weight(description, places, feet, ground)) return {};
  return feet;
}

}  // namespace murosimf::robot
