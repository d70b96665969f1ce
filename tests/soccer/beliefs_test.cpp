#include "murosimf/soccer/beliefs.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "murosimf/soccer/behavior_properties.h"
#include "murosimf/world/world.h"
#include "tests/fixtures.h"

namespace murosimf::soccer {
namespace {

TEST(Beliefs, AreThoseOfWhoHasAnOpinionAndIsThere) {
  World world;
  Entity& robot = world.add("robot", std::make_shared<const Model>(fixtures::ball_model(0.1, 1)));
  EXPECT_FALSE(believed_pose(robot));
  auto& pose = robot.column(properties::pose_estimate).values[0];
  pose = {1, -2, 0.5};
  ASSERT_TRUE(believed_pose(robot));
  EXPECT_EQ(believed_pose(robot)->y, -2);
  EXPECT_EQ(believed_pose(robot)->z, 0.5);
  pose.z = std::nan("");
  EXPECT_FALSE(believed_pose(robot)) << "lost";
}

}  // namespace
}  // namespace murosimf::soccer
