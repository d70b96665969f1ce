/// urdf_held_test - joints that cannot move, and those that follow no other.
#include <cmath>

#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;

const robot_formats::BodyDescription& body_named(const robot_formats::RobotDescription& description,
                                                 const std::string& name) {
  return *std::ranges::find(description.bodies, name, &robot_formats::BodyDescription::name);
}

TEST(UrdfHeldJoints, AreFixedWhereTheirLimitsHoldThem) {
  for (const std::string type : {"revolute", "prismatic"}) {
    const auto description = read(with_joint(type,
                                             "<origin xyz='1 0 0'/><axis xyz='0 0 2'/>"
                                             "<limit lower='0.5' upper='0.5' effort='1' velocity='1'/>"));
    const robot_formats::BodyDescription& body = description.bodies.at(1);
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

// k at 0.25 of 2 x 0.5 + 0.1: two joints in a row that follow one at rest.
TEST(UrdfMimic, HoldsWhatFollowsAHeldJoint) {
  const std::string held = "<limit lower='0.5' upper='0.5' effort='1' velocity='1'/>";
  const auto description =
      read(robot_xml(link("a", solid()) + link("b", solid()) + link("c", solid()) + link("d", solid()) +
                     joint("continuous", "b", "c", "<mimic joint='k' multiplier='0.5'/>", "l") +
                     joint("prismatic", "a", "b", any_limit + "<mimic joint='j' multiplier='2' offset='0.1'/>", "k") +
                     joint("revolute", "base", "a", held, "j") +
                     joint("revolute", "base", "d", any_limit + "<mimic joint='j' multiplier='-1'/>", "m")));
  EXPECT_TRUE(description.mimics.empty());
  for (const robot_formats::BodyDescription& body : description.bodies) EXPECT_TRUE(body.joints.empty()) << body.name;
  expect_near(body_named(description, "b").place.position, {1.1, 0, 0});
  expect_near(body_named(description, "c").place.orientation.y, {0, std::cos(0.55), std::sin(0.55)});
  expect_near(body_named(description, "d").place.orientation.y, {0, std::cos(0.5), -std::sin(0.5)});
  EXPECT_TRUE(any_contains(description.warnings, "joint 'l' cannot move: it mimics 'k', which is fixed"));
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
