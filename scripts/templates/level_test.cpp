// The level new_name: its robot stays where it stands, moves its joints, and can be exchanged for another level.
#include "murosimf/dynamics/new_name.h"

#include <gtest/gtest.h>

#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

/// kid21, moved by a level of this name.
struct Robot {
  explicit Robot(const std::string& level) : entity(rig.add("robot", test::kid21())) {
    const catalog::LevelType& type = find_entry(catalog::levels(), "level", level);
    if (type.traits.dynamic) rig.attach_ground(entity, {});
    rig.simulation.attach(level, entity, rig.rate, [&](Setup& setup) { return type.make(setup, {}); });
  }
  [[nodiscard]] Vec3d place() const { return entity.base().get(properties::position); }

  test::Rig rig;
  Entity& entity;
};

TEST(NewName, StaysWhereItStands) {
  Robot robot("new_name");
  robot.rig.run(0.001);
  const Vec3d start = robot.place();
  robot.entity.base().set(properties::linear_velocity, {1, 0, 0});
  robot.rig.run(1.0);
  EXPECT_EQ(norm(robot.place() - start), 0);
  EXPECT_EQ(norm(robot.entity.base().get(properties::linear_velocity)), 0);
}

TEST(NewName, GoesWhereItIsPut) {
  Robot robot("new_name");
  robot.rig.run(0.001);
  const Vec3d place{1, 2, 3};
  const Vec3d foot = robot.entity.object("l_sole").get(properties::position) - robot.place();
  robot.entity.base().set(properties::position, place);
  robot.rig.run(0.001);
  EXPECT_EQ(norm(robot.place() - place), 0);
  EXPECT_LT(norm(robot.entity.object("l_sole").get(properties::position) - place - foot), 1e-12) << "rounding";
}

// The filter of the joints lags 17 ms behind: after 0.5 s nothing is left of that.
TEST(NewName, JointsFollowTheirTargets) {
  Robot robot("new_name");
  robot.rig.run(0.001);
  robot.entity.object("j_head").set(properties::joint_target, 0.3);
  robot.rig.run(0.5);
  EXPECT_NEAR(robot.entity.object("j_head").get(properties::joint_position), 0.3, 1e-9);
}

TEST(NewName, TakesOverWithoutAJumpAndHandsOver) {
  Robot robot("full_dynamics");
  robot.rig.run(0.1);
  const Vec3d before = robot.place();
  robot.rig.exchange(robot.entity, "new_name");
  EXPECT_EQ(norm(robot.place() - before), 0);
  robot.rig.run(0.2);
  EXPECT_EQ(norm(robot.place() - before), 0);
  robot.rig.exchange(robot.entity, "full_dynamics");
  robot.rig.run(0.2);
  EXPECT_LT(norm(robot.place() - before), 1e-3) << "it still stands, on feet that sink in by less than 1 mm";
}

TEST(NewName, FreezesARobotWhoseNumbersAreBad) {
  Robot robot("new_name");
  robot.rig.run(0.001);
  robot.entity.object("j_head").set(properties::joint_target, std::nan(""));
  robot.rig.run(0.001);
  EXPECT_TRUE(robot.entity.frozen());
}

}  // namespace
}  // namespace murosimf::dynamics
