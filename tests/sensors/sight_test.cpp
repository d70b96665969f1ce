// Which part of a body is in sight.
#include "murosimf/sensors/sight.h"

#include <gtest/gtest.h>

#include "tests/sensors/range_rig.h"

namespace murosimf::sensors {
namespace {

using fixtures::placed;
using test::RangeRig;

/// A ball of 10 cm at x = 4, behind a wall that covers y > edge [m] in the view from the origin.
/// Checks on the way that is_in_sight says the same.
double share_of_ball(double edge) {
  RangeRig rig;
  rig.add_walls({placed(Box{{0.01, 1, 5}}, {2, 1 + edge / 2, 0})});
  Entity& ball = rig.add_ball("ball");
  rig.begin();
  RangeRig::put(ball, {4, 0, 1});
  collision::QueryScene scene(rig.simulation.world());
  const Seen body{&ball, ball.find(properties::position)->values, ball.find(properties::orientation)->values,
                  scene.shapes(ball)};
  const double share = share_in_sight(scene, {0, 0, 1}, nullptr, body);
  for (const double wanted : {0.0, 1 / 9.0, 0.25, 3 / 9.0, 0.5, 6 / 9.0, 0.8, 8 / 9.0, 1.0}) {
    EXPECT_EQ(is_in_sight(scene, {0, 0, 1}, nullptr, body, wanted), share > 0 && share >= wanted) << edge << wanted;
  }
  return share;
}

// The points are at y = 0, 0.0566 m and 0.08 m to both sides, as seen from the origin.
TEST(Sight, AWallHidesThePointsBehindIt) {
  EXPECT_EQ(share_of_ball(0.09), 1);
  EXPECT_EQ(share_of_ball(0.07), 8 / 9.0);
  EXPECT_EQ(share_of_ball(0.03), 6 / 9.0);
  EXPECT_EQ(share_of_ball(-0.03), 3 / 9.0);
  EXPECT_EQ(share_of_ball(-0.07), 1 / 9.0);
  EXPECT_EQ(share_of_ball(-0.11), 0);
}

// What has no shape is a point. Behind it stands a wall, which does not count; in front of it, another one does.
TEST(Sight, OnlyWhatStandsBetweenHides) {
  for (const double place : {3.0, 1.0}) {
    RangeRig rig;
    rig.add_walls({placed(Box{{0.01, 1, 5}}, {place, 0, 0})});
    Entity& mark = rig.add_moving_entity(
        "mark", std::make_shared<const Model>(
                    "mark", Chain{}.base().with(properties::mass, 1.0).with(properties::inertia, diagonal(1.0))));
    rig.begin();
    RangeRig::put(mark, {2, 0.3, 1});
    collision::QueryScene scene(rig.simulation.world());
    const Seen body{&mark, mark.find(properties::position)->values, mark.find(properties::orientation)->values, {}};
    EXPECT_EQ(share_in_sight(scene, {0, 0, 1}, nullptr, body), place > 2 ? 1 : 0);
    for (const double wanted : {0.0, 0.5, 1.0}) {
      EXPECT_EQ(is_in_sight(scene, {0, 0, 1}, nullptr, body, wanted), place > 2) << wanted;
    }
  }
}

// Law: nothing but other bodies hides a point, whatever the robot's posture and wherever it is seen from.
TEST(Sight, ARobotInTheOpenIsSeenWhole) {
  fixtures::Dice dice("in the open");
  RangeRig rig;
  Entity& robot = rig.add_moving_entity("robot", test::kid21());
  rig.begin();
  collision::QueryScene scene(rig.simulation.world());
  const Seen body{&robot, robot.find(properties::position)->values, robot.find(properties::orientation)->values,
                  scene.shapes(robot)};
  ASSERT_GT(body.shapes.size(), 10u);
  for (int i = 0; i < 50; ++i) {
    const Vec3d away = dice.uniform(0.5, 5) * dice.unit();
    const Vec3d eye = body.r[0] + Vec3d{away.x, away.y, std::fabs(away.z)};
    EXPECT_EQ(share_in_sight(scene, eye, nullptr, body), 1);
  }
}

}  // namespace
}  // namespace murosimf::sensors
