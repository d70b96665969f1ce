/// mjcf_trees_test - files of robots that are fixed to the world, are one of several bodies, have ball joints, or have parts without effect.
#include "murosimf/robot/robot_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/math/quaternion.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/model/keyframe.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot_formats/mjcf/mjcf_joint.h"
#include "murosimf/robot_formats/mjcf/mjcf_writer.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

using fixtures::difference;

robot::RobotFile read(const std::string& text, bool lenient = false) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = fixtures::temp_folder() / (std::string("trees_") + test->name() + ".xml");
  std::ofstream(file) << text;
  return robot::read_robot(file, {lenient});
}

std::string world(const std::string& inside, const std::string& after = "", const std::string& before = "") {
  return "<mujoco><compiler angle='radian'/>" + before + "<worldbody>" + inside + "</worldbody>" + after + "</mujoco>";
}

bool any_says(const std::vector<std::string>& lines, const std::string& part) {
  return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

std::vector<std::string> joints_of(const robot::RobotFile& robot) {
  std::vector<std::string> names;
  for (const int joint : robot.model->joints()) names.push_back(robot.model->objects()[joint].name);
  return names;
}

double mass_of(const robot::RobotFile& robot) { return robot.model->tree().mass; }

using Names = std::vector<std::string>;

constexpr const char* arm =
    "<body name='arm' pos='0 0 1'><joint name='j' axis='0 1 0'/><geom type='capsule' fromto='0 0 0 0 0 .3' "
    "size='.03'/></body>";
constexpr const char* ball = "<body name='ball'><freejoint/><geom size='.1' mass='.4'/></body>";

robot::RobotFile read_body(const std::string& text, const std::string& body) {
  const auto file = fixtures::temp_folder() / "trees_body.xml";
  std::ofstream(file) << text;
  return robot::read_robot(file, {.body = body});
}

// Two robots that float, an arm on the ground, and a body that software moves.
TEST(MjcfTrees, AnyOfSeveralRobotsCanBeChosen) {
  const std::string two =
      "<body name='two'><freejoint/><geom size='.1' mass='2'/><body name='limb'><joint name='k'/><geom "
      "size='.1' mass='.5'/></body></body>";
  const std::string text = world(ball + two + arm + "<body name='hand' mocap='true'><geom size='.1'/></body>");
  EXPECT_NEAR(mass_of(read_body(text, "ball")), .4, 1e-12);
  EXPECT_NEAR(mass_of(read_body(text, "limb")), 2.5, 1e-12) << "any body of it";
  EXPECT_EQ(joints_of(read_body(text, "two")), Names{"k"});
  for (const char* bolted : {"arm", "world"}) {
    const auto robot = read_body(text, bolted);
    EXPECT_EQ(joints_of(robot), Names{"j"});
    EXPECT_TRUE(has_fixed_base(*robot.model));
  }
  const auto complaint = [&](const char* body) { return fixtures::error_of([&] { (void)read_body(text, body); }); };
  EXPECT_TRUE(fixtures::says(complaint("bal"), {"trees_body.xml:1: unknown body 'bal'", "did you mean 'ball'?"}));
  EXPECT_TRUE(fixtures::says(complaint("hand"), {"body 'hand' is no robot: software moves it (mocap)"}));
  const auto alone = fixtures::error_of([&] { (void)read_body(world(two), "world"); });
  EXPECT_TRUE(fixtures::says(alone, {"nothing is bolted to the world"}));
}

TEST(MjcfTrees, ABodyWithoutFreeJointIsBoltedToTheWorld) {
  const auto robot = read(world(std::string(arm) + "<site name='mark' pos='1 0 0'/><geom type='plane' size='1 1 1'/>"));
  const Model& model = *robot.model;
  EXPECT_TRUE(has_fixed_base(model));
  EXPECT_EQ(model.objects()[0].name, "world");
  EXPECT_EQ(model.find(properties::mass, 0), nullptr);
  EXPECT_EQ(joints_of(robot), Names{"j"});
  EXPECT_EQ(difference(robot.description.bodies[1].place.position, Vec3d{0, 0, 1}), 0);
  EXPECT_TRUE(model.find_object("mark"));
  EXPECT_TRUE(any_says(robot.notes, "body 'arm' is bolted to the world, since it has no free joint"));
  EXPECT_TRUE(any_says(robot.notes, "the scene brings its own ground"));
  EXPECT_FALSE(any_says(robot.warnings, "has no mass")) << "the world needs none";
  EXPECT_FALSE(has_fixed_base(*read(world(ball)).model));
}

TEST(MjcfTrees, WhatHasNoJointsIsPartOfTheBoltedBase) {
  const auto robot = read(world("<body name='table' pos='0 0 .5'><geom type='box' size='.5 .5 .5' mass='30'/>" +
                                std::string(arm) + "</body>"));
  EXPECT_EQ(*robot.model->find(properties::mass, 0), 30);
  EXPECT_EQ(difference(robot.description.bodies[1].place.position, Vec3d{0, 0, 1.5}), 0);
  EXPECT_TRUE(robot.model->find_object("table")) << "its frame stays";
}

TEST(MjcfTrees, RailsOfAPlanarWalkerAreJoints) {
  const auto robot =
      read(world("<body name='torso' pos='0 0 1.3'><joint name='x' type='slide' axis='1 0 0'/>"
                 "<joint name='z' type='slide' axis='0 0 1' ref='1.3'/><joint name='y' axis='0 1 0'/>"
                 "<geom size='.1' mass='2'/><body name='leg' pos='0 0 -.2'><joint name='hip' axis='0 1 0'/>"
                 "<geom size='.1' mass='1'/></body></body>",
                 "<keyframe><key name='k' qpos='.1 1.4 .2 .3'/></keyframe>"));
  EXPECT_EQ(joints_of(robot), (Names{"x", "z", "y", "hip"}));
  EXPECT_EQ(mass_of(robot), 3);
  const Keyframe& key = robot.model->find(properties::keyframes, 0)->at(0);
  EXPECT_EQ(std::ranges::find(key.positions, "z", [](const auto& one) { return one.first; })->second, 1.4);
}

TEST(MjcfTrees, AllThatIsBoltedIsOneRobotAndWhatFloatsBesideItIsLeftOut) {
  const std::string spinner = "<body name='spinner'><joint name='s'/><geom size='.1' mass='1'/></body>";
  const std::string hand = "<body name='hand' mocap='true'><geom size='.1' mass='9'/></body>";
  const auto robot =
      read(world(ball + hand + spinner + arm,
                 "<actuator><motor name='m' joint='s'/></actuator><contact><exclude body1='ball' body2='arm'/>"
                 "<exclude body1='arm' body2='spinner'/></contact><keyframe>"
                 "<key name='k' qpos='1 2 3 1 0 0 0 .4 .5' ctrl='1'/></keyframe>"));
  EXPECT_EQ(joints_of(robot), (Names{"s", "j"}));
  EXPECT_TRUE(any_says(robot.notes, "body 'ball' is left out: it floats beside the robot"));
  EXPECT_TRUE(any_says(robot.notes, "body 'hand' is left out: software moves it"));
  ASSERT_EQ(robot.description.exclusions.size(), 1U);
  EXPECT_EQ(robot.description.exclusions[0].body2, "spinner");
  const auto& positions = robot.description.keyframes.at(0).positions;
  EXPECT_EQ(positions.at("s"), .4);
  EXPECT_EQ(positions.at("j"), .5);
}

TEST(MjcfTrees, TheRobotIsWhatHasTheMostJoints) {
  const std::string walker = "<body name='trunk'><freejoint/><geom size='.1'/>" + std::string(arm) +
                             "<body name='head'><joint name='h'/><geom size='.1'/></body></body>";
  const std::string door = "<body name='door'><joint name='d'/><geom size='.1'/></body>";
  const auto robot = read(world(ball + door + walker,
                                "<actuator><motor joint='d'/><motor joint='h'/></actuator>"
                                "<keyframe><key qpos='0 0 1 1 0 0 0 9 1 2 3 0 1 0 0 .1 .2'/></keyframe>"));
  EXPECT_FALSE(has_fixed_base(*robot.model));
  EXPECT_EQ(robot.model->objects()[0].name, "trunk");
  EXPECT_EQ(joints_of(robot), (Names{"j", "h"}));
  EXPECT_TRUE(any_says(robot.notes, "body 'door' is left out: it stands in the world"));
  EXPECT_TRUE(any_says(robot.warnings, "moves nothing: its joint is not the robot's"));
  const auto& key = robot.description.keyframes.at(0);
  EXPECT_EQ(difference(key.base.position, Vec3d{1, 2, 3}), 0);
  EXPECT_EQ(key.positions.at("h"), .2);
  // of bodies without joints one that floats is the robot, not those that are fixed
  EXPECT_EQ(read(world("<body name='table'><geom size='1'/></body>" + std::string(ball))).model->objects()[0].name,
            "ball");
}

TEST(MjcfTrees, ABallJointIsThreeHinges) {
  const auto robot = read(world(
      "<body name='b' pos='0 0 1'><joint name='q' type='ball' range='0 .6' damping='2' stiffness='3' pos='0 0 .1'/>"
      "<geom size='.1' mass='1'/></body>",
      "<keyframe><key name='k' qpos='.8 .2 -.4 .4'/></keyframe><actuator><motor joint='q'/></actuator>"));
  EXPECT_EQ(joints_of(robot), (Names{"q.x", "q.y", "q.z"}));
  for (const auto& joint : robot.description.bodies[1].joints) {
    EXPECT_EQ(joint.damping, 2);
    EXPECT_EQ(joint.stiffness, 3);
    EXPECT_EQ(difference(joint.anchor, Vec3d{0, 0, .1}), 0);
    EXPECT_EQ(difference(*joint.range, Vec3d{-.6, .6, 0}), 0);
    EXPECT_FALSE(joint.servo);
  }
  EXPECT_TRUE(any_says(robot.notes, "ball joint 'q' is read as three hinges"));
  EXPECT_TRUE(any_says(robot.warnings, "actuators of joint 'q' move nothing"));
  const auto& at = robot.description.keyframes.at(0).positions;
  const Mat3d turn = rotation_x(at.at("q.x")) * rotation_y(at.at("q.y")) * rotation_z(at.at("q.z"));
  const Mat3d wanted = to_matrix(normalized(Quaterniond{.8, .2, -.4, .4}));
  EXPECT_NEAR(norm(turn.x - wanted.x) + norm(turn.y - wanted.y), 0, 1e-14);
}

TEST(MjcfTrees, AnglesOfABallTurnAsTheBallDoes) {
  fixtures::Dice dice("ball angles");
  const auto differs = [](const Mat3d& wanted) {
    const Vec3d a = ball_angles(wanted);
    const Mat3d turn = rotation_x(a.x) * rotation_y(a.y) * rotation_z(a.z);
    return norm(turn.x - wanted.x) + norm(turn.y - wanted.y) + norm(turn.z - wanted.z);
  };
  for (int i = 0; i < 100; ++i) EXPECT_LT(differs(dice.turn()), 1e-12);
  for (const double b : {0.5 * pi, -0.5 * pi})
    EXPECT_LT(differs(rotation_x(.3) * rotation_y(b) * rotation_z(.4)), 1e-8);
}

/// Two sliders in a row: the first alone moves both, but pushed where nothing holds the second it moves its own body only.
TEST(MjcfTrees, SpringdampersCountWhatTheJointFeelsWhileOthersAreFree) {
  const auto robot = read(
      world("<body name='a'><joint name='i' type='slide' axis='1 0 0' springdamper='.5 2'/><geom size='.1' mass='2'/>"
            "<body name='b'><joint name='j' type='slide' axis='1 0 0' springdamper='.1 1' armature='.25'/><geom "
            "size='.1' mass='3'/>"
            "</body></body>"));
  const auto& first = robot.description.bodies[1].joints[0];
  const auto& second = robot.description.bodies[2].joints[0];
  // M = (5 3; 3 3.25): 1 / (M^-1)_ii = det / M_jj
  const double det = 5 * 3.25 - 9;
  EXPECT_NEAR(first.stiffness, det / 3.25 / (.5 * .5 * 4), 1e-12);
  EXPECT_NEAR(first.damping, 2 * det / 3.25 / .5, 1e-12);
  EXPECT_NEAR(second.stiffness, det / 5 / .01, 1e-10);
  EXPECT_NEAR(second.damping, 2 * det / 5 / .1, 1e-12);
}

TEST(MjcfTrees, WhatHoldsThingsTogetherAndDoesNotActIsNamed) {
  const auto robot =
      read(world(std::string(arm) + "<body name='other'><joint name='k' axis='0 1 0'/><geom size='.1'/></body>"
                                    "<body name='hand' mocap='true'><site name='s'/><site name='beside'/></body>",
                 "<tendon><fixed name='idle'><joint joint='j' coef='1'/></fixed><fixed name='rope' range='0 1'><joint "
                 "joint='j' coef='1'/><joint joint='k' coef='1'/></fixed>"
                 "<spatial name='rubber' class='c'><site site='s'/><site "
                 "site='beside'/></spatial></tendon><equality><connect body1='arm' "
                 "body2='hand' anchor='0 0 0'/>"
                 "<weld body1='arm' body2='other' active='false'/><joint joint1='j'/></equality>",
                 "<default><default class='c'><tendon stiffness='3' damping='1'/></default></default>"));
  EXPECT_TRUE(any_says(robot.notes, "tendon 'idle' only measures a length"));
  EXPECT_FALSE(any_says(robot.warnings, "tendon 'rope'")) << "which is a joint of its own";
  EXPECT_TRUE(any_says(robot.warnings, "tendon 'rubber' does not act: spring, damper"));
  EXPECT_TRUE(any_says(robot.warnings, "connect of 'arm' and 'hand' does not act"));
  EXPECT_TRUE(any_says(robot.notes, "weld of 'arm' and 'other' is not active"));
  EXPECT_TRUE(any_says(robot.warnings, "nothing holds joint 'j'"));
}

TEST(MjcfTrees, MasslessMarksMayHangOnBodies) {
  const auto robot =
      read(world("<body name='arm'><joint name='j'/><geom size='.1' mass='2'/><body name='mark'>"
                 "<inertial mass='0' pos='0 0 0' diaginertia='0 0 0'/></body><body name='bead' pos='1 0 0'>"
                 "<inertial mass='.5' pos='0 0 0' diaginertia='0 0 0'/></body></body>"));
  EXPECT_EQ(mass_of(robot), 2.5);
}

TEST(MjcfTrees, WeightIsNotTakenFromBodies) {
  const auto weightless = [](const std::string& share) {
    return world("<body name='arm' gravcomp='" + share + "'><joint name='j'/><geom size='.1'/></body>");
  };
  EXPECT_EQ(joints_of(read(weightless("0"))), Names{"j"});
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)read(weightless("1")); }), {"gravcomp", "--lenient"}));
  EXPECT_TRUE(any_says(read(weightless("1"), true).warnings, "body 'arm' feels another gravity"));
}

/// A robot that is fixed to the world is written so that it is read as the same.
TEST(MjcfTrees, WrittenFilesAreBoltedAsWell) {
  const auto robot = read(
      world(std::string(arm) + "<body name='table'><geom type='box' size='.5 .5 .5' mass='30'/></body>",
            "<contact><exclude body1='world' body2='arm'/></contact><keyframe><key name='k' qpos='.1'/></keyframe>"));
  const std::string text = to_mjcf(robot.description);
  const auto again = read(text);
  EXPECT_TRUE(has_fixed_base(*again.model));
  EXPECT_EQ(joints_of(again), Names{"j"});
  EXPECT_EQ(mass_of(again), mass_of(robot));
  EXPECT_EQ(again.description.exclusions.size(), 1U);
  EXPECT_EQ(again.description.keyframes.at(0).positions.at("j"), .1);
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
