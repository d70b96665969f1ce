/// mjcf_loops_test - `connect` and `weld` become loops between the right frames, and errors in them are named.
#include "murosimf/robot_formats/mjcf/mjcf_loops.h"

#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/math/quaternion.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/loops.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// Two arms beside each other, the second one turned; `bolt` is welded to the second.
std::string file_with(const std::string& equality) {
  return fmt::format(
      "<mujoco><compiler angle='radian'/><worldbody><body name='base' pos='1 2 3'><freejoint/><geom size='.1'/>\n"
      "<body name='one' pos='0 .2 0'><joint name='a' axis='0 1 0'/><geom size='.1'/><site name='s' pos='.3 0 "
      "0'/></body>\n"
      "<body name='other' pos='.1 .3 0' euler='0 0 .5'><joint name='b' axis='0 1 0'/><geom size='.1'/><site "
      "name='t'/>\n"
      "<body name='bolt' pos='0 0 .4'><geom size='.05'/><site name='u' pos='0 .1 0'/></body></body>\n"
      "</body></worldbody>\n<equality>{}</equality></mujoco>",
      equality);
}

robot::RobotFile read(const std::string& equality) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = fixtures::temp_folder() / (std::string("mjcf_loops_") + test->name() + ".xml");
  std::ofstream(file) << file_with(equality);
  return robot::read_robot(file, {.guess = false});
}

/// Both frames of the only loop, in the base, all joints at zero.
struct Ends {
  Transformd first, second;
  bool welded = false;
};
Ends ends_of(const robot::RobotFile& robot) {
  const Model& model = *robot.model;
  const auto loops = multibody::loops_of(model);
  EXPECT_EQ(loops.size(), 1U);
  const std::vector<double> zero(static_cast<std::size_t>(model.size()));
  const auto place = [&](const multibody::Loop::End& end) {
    return multibody::pose_in_base<double>(model.tree(), end.path, end.frame, zero);
  };
  return {place(loops.at(0).ends[0]), place(loops[0].ends[1]), loops[0].welded};
}

void expect_near(const Vec3d& found, const Vec3d& expected) { EXPECT_LT(norm(found - expected), 1e-12); }

/// [rad] from one to the other.
double turn_between(const Mat3d& a, const Mat3d& b) { return norm(rotation_vector(from_matrix(transpose(a) * b))); }

// The anchor is a point of body1, and of body2 the point that is there in the pose of the file.
TEST(MjcfLoops, ConnectHoldsThePointsThatCoincideInTheFile) {
  const Ends ends = ends_of(read("<connect body1='one' body2='bolt' anchor='.3 .05 0'/>"));
  expect_near(ends.first.position, {0.3, 0.25, 0});
  expect_near(ends.second.position, {0.3, 0.25, 0});
  EXPECT_FALSE(ends.welded);
}

TEST(MjcfLoops, SitesAreTheEnds) {
  const auto robot = read("<connect site1='s' site2='u'/>");
  const Ends ends = ends_of(robot);
  expect_near(ends.first.position, {0.3, 0.2, 0});
  expect_near(ends.second.position, Vec3d{0.1, 0.3, 0.4} + rotation_z(0.5) * Vec3d{0, 0.1, 0});
  ASSERT_EQ(robot.warnings.size(), 1U);
  EXPECT_TRUE(fixtures::says(robot.warnings[0], {"xml:6", "'s_u'", "open", "mm"}));
}

// Without relpose the file's pose holds; with it, its position is where the anchor of body2 belongs in body1.
TEST(MjcfLoops, WeldHasAnAnchorInTheSecondBody) {
  const Ends plain = ends_of(read("<weld body1='one' body2='other' anchor='.1 0 0'/>"));
  expect_near(plain.second.position, Vec3d{0.1, 0.3, 0} + rotation_z(0.5) * Vec3d{0.1, 0, 0});
  expect_near(plain.first.position, plain.second.position);
  EXPECT_LT(turn_between(plain.first.orientation, plain.second.orientation), 1e-12);
  EXPECT_TRUE(plain.welded);
  const Ends posed = ends_of(read("<weld body1='one' body2='other' anchor='.1 0 0' relpose='.2 0 0 1 0 0 1'/>"));
  expect_near(posed.first.position, {0.2, 0.2, 0});
  EXPECT_LT(turn_between(posed.first.orientation, rotation_z(pi / 2)), 1e-12);
  const Ends ignored = ends_of(read("<weld body1='one' body2='other' relpose='.2 0 0 0 0 0 0'/>"));
  expect_near(ignored.first.position, {0.1, 0.3, 0});
}

TEST(MjcfLoops, WhatIsNotActiveIsNotThere) {
  EXPECT_TRUE(read("<connect active='false' body1='one' body2='other' anchor='0 0 0'/>").description.loops.empty());
}

// The base floats, so nothing holds it to the world.
TEST(MjcfLoops, OneWithTheWorldDoesNotAct) {
  const auto robot = read("<connect body1='one' anchor='0 0 0'/>");
  EXPECT_TRUE(robot.description.loops.empty());
  ASSERT_EQ(robot.warnings.size(), 1U);
  EXPECT_TRUE(fixtures::says(robot.warnings[0], {"xml:6", "connect", "'one'", "does not act"}));
}

// A site that closes two loops is the second end of one and the first of the other.
TEST(MjcfLoops, OneSiteMayEndTwoLoops) {
  const auto robot = read("<connect site1='s' site2='t'/><connect site1='u' site2='s'/><connect site1='u' site2='s'/>");
  EXPECT_EQ(multibody::loops_of(*robot.model).size(), 3U);
}

TEST(MjcfLoops, MistakesAreNamed) {
  const auto error = [](const std::string& text) { return fixtures::error_of([&] { (void)read(text); }); };
  using fixtures::says;
  EXPECT_TRUE(says(error("<connect body1='one' body2='othr' anchor='0 0 0'/>"), {"xml:6", "'othr'", "'other'"}));
  EXPECT_TRUE(says(error("<connect body1='one' body2='other'/>"), {"xml:6", "anchor"}));
  EXPECT_TRUE(says(error("<connect site1='s' site2='v'/>"), {"xml:6", "site", "'v'"}));
  EXPECT_TRUE(says(error("<connect site1='s'/>"), {"xml:6", "site2"}));
  EXPECT_TRUE(says(error("<connect site1='s' site2='t' anchor='0 0 0'/>"), {"xml:6", "anchor"}));
  EXPECT_TRUE(says(error("<weld body1='one' body2='one'/>"), {"xml:6", "itself"}));
  EXPECT_TRUE(says(error("<connect body1='other' body2='bolt' anchor='0 0 0'/>"), {"xml:6", "itself"}));
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
