/// urdf_held_test - joints that cannot move, and those that follow nothing.
#include <cmath>

#include "tests/formats/urdf/urdf_files.h"

namespace murosimf::formats::urdf {
namespace {

using namespace urdf_files;

TEST(UrdfHeldJoints, AreFixedWhereTheirLimitsHoldThem) {
  for (const std::string type : {"revolute", "prismatic"}) {
    const auto description = read(with_joint(type,
                                             "<origin xyz='1 0 0'/><axis xyz='0 0 2'/>"
                                             "<limit lower='0.5' upper='0.5' effort='1' velocity='1'/>"));
    const description::BodyDescription& body = description.bodies.at(1);
    EXPECT_TRUE(body.joints.empty());
    EXPECT_TRUE(
        any_contains(description.warnings, "robot.urdf:3: joint 'j' cannot move: lower and upper limit are both 0.5"));
    const bool turns = type == "revolute";
    expect_near(body.place.position, turns ? Vec3d{1, 0, 0} : Vec3d{1, 0, 0.5});
    expect_near(body.place.orientation.x, turns ? Vec3d{std::cos(0.5), std::sin(0.5), 0} : Vec3d{1, 0, 0});
  }
}

TEST(UrdfHeldJoints, MoveWhereNoLimitIsWritten) {
  const auto description = read(with_joint("revolute", "<limit effort='1' velocity='2'/>"));
  EXPECT_FALSE(description.bodies.at(1).joints.at(0).range);
  EXPECT_EQ(description.bodies[1].joints[0].rate_limit, 2);
  EXPECT_TRUE(any_contains(description.warnings, "robot.urdf:3: joint 'j' has no lower and upper limit"));
}

TEST(UrdfMimic, IsLeftOutWithoutItsLeader) {
  const auto description = read(with_joint("continuous", "<mimic joint='k'/>"));
  EXPECT_TRUE(description.mimics.empty());
  EXPECT_TRUE(
      any_contains(description.warnings, "robot.urdf:3: joint 'j' moves by itself: it mimics an unknown joint 'k'"));
}

}  // namespace
}  // namespace murosimf::formats::urdf
