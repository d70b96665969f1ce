// A slow walk never comes near the edge of the feet that carry it.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// Positive if a, b, c turn left, seen from above: twice the area of their triangle.
double left_turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a).z; }

/// Corners of the convex hull on the ground, counterclockwise (Andrew's monotone chain).
std::vector<Vec3d> hull(std::vector<Vec3d> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec3d& a, const Vec3d& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec3d> corners;
  const auto add = [&](const Vec3d& p, std::size_t fixed) {
    while (corners.size() > fixed && left_turn(corners[corners.size() - 2], corners.back(), p) <= 0) corners.pop_back();
    corners.push_back(p);
  };
  for (const Vec3d& p : points) add(p, 1);
  const std::size_t lower = corners.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  corners.pop_back();
  return corners;
}

/// Distance [m] of a point inside from the nearest edge; negative outside, or if there is no area.
double margin(const std::vector<Vec3d>& corners, const Vec3d& p) {
  if (corners.size() < 3) return -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
    nearest = std::min(nearest, left_turn(a, b, p) / std::hypot(b.x - a.x, b.y - a.y));
  }
  return nearest;
}

/// Corners of the soles whose feet touch the ground.
std::vector<Vec3d> support_points(Entity& robot) {
  const Model& model = robot.model();
  std::vector<Vec3d> points;
  for (const int object : model.having(properties::sole)) {
    const auto i = static_cast<std::size_t>(object);
    const auto touches = [&](const collision::ContactPoint& c) {
      return model.tree().link_of[static_cast<std::size_t>(c.object)] == model.tree().link_of[i];
    };
    const auto& contacts = robot.find(collision::contacts)->values[0].points;
    if (std::none_of(contacts.begin(), contacts.end(), touches)) continue;
    const Sole& sole = *model.find(properties::sole, object);
    for (const auto& [x, y] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      points.push_back(robot.find(properties::position)->values[i] +
                       robot.find(properties::orientation)->values[i] *
                           Vec3d{x * sole.half_length, y * sole.half_width, 0});
    }
  }
  return points;
}

/// [m] the zero moment point's distance from the edge of the support polygon.
double support_margin(Entity& robot) {
  Wrenchd sum;  // about the world's origin
  for (const int object : robot.model().bodies()) {
    const auto i = static_cast<std::size_t>(object);
    sum += moved(robot.find(properties::external_force)->values[i], -robot.find(properties::position)->values[i]);
  }
  const std::vector<Vec3d> points = support_points(robot);
  if (points.empty()) return -1;
  return margin(hull(points), {-sum.n.y / sum.f.z, sum.n.x / sum.f.z, 0});
}

/// Two steps in 3 s, most of the time on both feet, with the weight swayed far over the standing foot. `hip_roll` against
/// the droop of the servos, which prescribed joints do not have.
locomotion::WalkParameters slow_walk(double hip_roll) {
  locomotion::WalkParameters p = locomotion::seeded_parameters(locomotion::find_legs(*kid21()));
  p.period = 3;
  p.sway = 0.06;
  p.double_support = 0.6;
  p.lead = 0;
  p.hip_roll = hip_roll;
  return p;
}

class SlowWalk : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, SlowWalk, testing::Values("full_dynamics", "articulated_dynamics"), level_name);

// From the second cycle on, for three cycles. Too little sway, or none of the hip roll, and the robot tips over an edge:
// the margin is zero.
TEST_P(SlowWalk, StaysAwayFromTheEdgeOfTheFeet) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                Vec3d{0.02, 0, 0},
                                                slow_walk(GetParam() == "full_dynamics" ? 0.02 : 0.09));
  rig.attach_dynamics(robot, {.level = GetParam()});
  rig.simulation.initialize();
  robot.base().set(properties::gait_amplitude, 1.0);  // the ramp would lift a foot before the weight has left it
  rig.run(3.0);
  const Vec3d start = Rig::place(robot);
  law::Worst beyond;  // how little the margin is
  for (int i = 0; i < 9000; ++i) {
    rig.simulation.step();
    beyond.see(-1e3 * support_margin(robot), "step", i);
  }
  EXPECT_GT(norm(Rig::place(robot) - start), 0.1) << "it did not walk";
  const law::Measured worst = beyond;
  law::expect_above({.law =
                         "walk with 3 s per cycle: smallest distance of the zero moment point from the support's edge",
                     .level = GetParam(),
                     .source = "inside the feet that carry"},
                    {-worst.value, worst.where}, 5, "mm");
}

}  // namespace
}  // namespace murosimf::test
