/// mjcf_words_test - actuators, copies, other files, materials and keys of MJCF files have the same meaning as in MuJoCo. The expected numbers
/// are those that MuJoCo 4.0 has for the same files.
#include "murosimf/robot/robot_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/keyframe.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/visual_mesh.h"
#include "murosimf/robot_formats/mjcf/mjcf_writer.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path here = fixtures::temp_folder() / (std::string("words_") + test->name());
  fs::create_directories(here);
  return here;
}

robot::RobotFile read(const std::string& text) {
  const fs::path file = folder() / "robot.xml";
  std::ofstream(file) << text;
  return robot::read_robot(file);
}

std::string complaint(const std::string& text) {
  try {
    (void)read(text);
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// A base with an arm on joint "j"; `defaults` are those of class "c".
std::string arm(const std::string& actuators, const std::string& defaults = "", const std::string& joint = "") {
  return "<mujoco><compiler angle='radian'/><default><default class='c'>" + defaults +
         "</default></default><worldbody><body name='b'><freejoint/><geom size='.1'/><body name='l' pos='0 0 .3'>"
         "<joint name='j' axis='0 1 0' range='-2 1' " +
         joint + "/><geom size='.1'/></body></body></worldbody><actuator>" + actuators + "</actuator></mujoco>";
}

struct Drive {
  Servo servo;
  std::optional<Vec3d> range;
};

Drive drive(const std::string& text) {
  const auto robot = read(text);
  const int j = robot.model->object_index("j");
  const auto* range = robot.model->find(properties::joint_target_range, j);
  return {*robot.model->find(properties::servo, j), range ? std::optional(*range) : std::nullopt};
}

void expect_range(const std::string& actuators, double lowest, double highest) {
  const auto range = drive(arm(actuators)).range;
  ASSERT_TRUE(range) << actuators;
  EXPECT_DOUBLE_EQ(range->x, lowest) << actuators;
  EXPECT_DOUBLE_EQ(range->y, highest) << actuators;
}

TEST(MjcfWords, CtrlrangesAreTargetsOfTheJoint) {
  expect_range("<position joint='j' kp='3' ctrlrange='-.2 .4'/>", -.2, .4);
  expect_range("<position joint='j' kp='3' ctrlrange='-.2 .4' gear='2'/>", -.1, .2);
  expect_range("<position joint='j' kp='3' ctrlrange='-.2 .4' gear='-2'/>", -.2, .1);
  expect_range("<velocity joint='j' kv='3' ctrlrange='-2 4' gear='2'/>", -1, 2);
  expect_range("<position joint='j' kp='3' inheritrange='.5'/>", -1.25, .25);
  expect_range("<position joint='j' kp='3' inheritrange='.5' gear='2'/>", -.625, .125);
  expect_range("<intvelocity joint='j' kp='3' inheritrange='.5' ctrlrange='-9 9'/>", -1.25, .25);
  // force = 6 u + 1 - 3 q
  expect_range("<general joint='j' gainprm='6' biastype='affine' biasprm='1 -3' ctrlrange='-1 1'/>", -5.0 / 3, 7.0 / 3);
  expect_range("<general joint='j' gainprm='0' biastype='affine' biasprm='1 -4'/>", .25, .25);
  for (const char* free :
       {"<position joint='j' kp='3'/>", "<position joint='j' kp='3' ctrlrange='-1 1' ctrllimited='false'/>",
        "<position joint='j' kp='3' ctrlrange='0 0'/>", "<motor joint='j' ctrlrange='-1 1'/>"}) {
    EXPECT_FALSE(drive(arm(free)).range) << free;
  }
  EXPECT_TRUE(contains(complaint(arm("<position joint='j' ctrllimited='true'/>")), "ctrllimited is true"));
  EXPECT_TRUE(contains(complaint(arm("<position joint='j' inheritrange='1' ctrlrange='-1 1'/>")), "keep one"));
  EXPECT_TRUE(contains(complaint(arm("<intvelocity joint='j' inheritrange='1' actrange='-1 1'/>")),
                       "both actrange and inheritrange; keep one"));
}

TEST(MjcfWords, TorquesAreThoseOfControlForceAndJoint) {
  const auto expect_torques = [](const std::string& text, double lowest, double highest) {
    const Servo servo = drive(text).servo;
    EXPECT_DOUBLE_EQ(servo.lowest_share * servo.stall_torque, lowest) << text;
    EXPECT_DOUBLE_EQ(servo.highest_share * servo.stall_torque, highest) << text;
  };
  expect_torques(arm("<position joint='j' forcerange='-3 4'/>"), -3, 4);
  expect_torques(arm("<position joint='j' forcerange='-3 4' gear='-2'/>"), -8, 6);
  expect_torques(arm("<position joint='j' forcerange='0 5'/>"), 0, 5);
  expect_torques(arm("<motor joint='j' ctrlrange='-1 2' gear='-3' forcerange='-1 1'/>"), -3, 3);
  expect_torques(arm("<general joint='j' ctrlrange='-1 2' gainprm='5'/>"), -5, 10);
  expect_torques(arm("<position joint='j' forcerange='-3 4'/>", "", "actuatorfrcrange='-1 9'"), -1, 4);
  expect_torques(arm("<position joint='j'/>", "", "actuatorfrcrange='-1 9'"), -1, 9);
}

TEST(MjcfWords, ActuatorsShareTheSettingsOfTheirClass) {
  const auto gains = [](const std::string& defaults, const std::string& actuator) {
    const Servo servo = drive(arm(actuator, defaults)).servo;
    return std::array{servo.position_gain, servo.velocity_gain, servo.command_filter};
  };
  using Gains = std::array<double, 3>;
  const std::string general = "<general gainprm='100' biasprm='0 -100 -3' biastype='affine'/>";
  EXPECT_EQ(gains("<position kp='5'/>", "<general class='c' joint='j'/>"), (Gains{5, 0, 0}));
  EXPECT_EQ(gains(general, "<position class='c' joint='j'/>"), (Gains{100, 3, 0}));
  EXPECT_EQ(gains(general, "<motor class='c' joint='j'/>"), (Gains{0, 0, 0}));
  EXPECT_EQ(gains("<position kp='5' kv='2'/>", "<position class='c' joint='j' kp='9'/>"), (Gains{9, 2, 0}));
  EXPECT_EQ(gains("<position kp='5' timeconst='.3'/>", "<position class='c' joint='j'/>"), (Gains{5, 0, .3}));
  EXPECT_EQ(gains("<position kp='5' timeconst='.3'/>", "<velocity class='c' joint='j'/>"), (Gains{0, 1, 0}));
  EXPECT_EQ(gains("<velocity kv='5'/>", "<position class='c' joint='j'/>"), (Gains{1, 0, 0}));
  EXPECT_EQ(gains("",
                  "<general joint='j' biastype='affine' biasprm='0 0 -2' gainprm='2' dyntype='filter' dynprm='.1'/>"),
            (Gains{0, 2, .1}));
  const auto own =
      drive(arm("<position class='c' joint='j' ctrlrange='-.3 .3'/>", "<position inheritrange='1'/>")).range;
  EXPECT_DOUBLE_EQ(own->y, .3);
  EXPECT_TRUE(drive(arm("<motor class='c' joint='j'/>", "<general forcerange='-3 3'/>")).servo.stall_torque == 3);
}

TEST(MjcfWords, WhatIsNotSimulatedOfActuatorsIsAWarning) {
  const auto says_that_nothing_moves = [](const std::string& actuator) {
    const auto robot = read(arm(actuator));
    EXPECT_EQ(robot.model->find(properties::servo, robot.model->object_index("j")), nullptr) << actuator;
    return std::ranges::any_of(robot.warnings, [](const std::string& warning) {
      return contains(warning, "robot.xml:1: actuator '") && contains(warning, "moves nothing");
    });
  };
  for (const char* words : {"gaintype='affine'", "biastype='muscle'", "dyntype='integrator'",
                            "dyntype='filter' dynprm='0'", "biastype='affine' biasprm='3'"}) {
    EXPECT_TRUE(says_that_nothing_moves(std::string("<general joint='j' ") + words + "/>")) << words;
  }
  for (const char* other : {"<muscle joint='j'/>", "<damper joint='j' kv='1' ctrlrange='0 1'/>",
                            "<adhesion body='l' ctrlrange='0 1'/>", "<motor site='s'/>", "<motor tendon='t'/>"}) {
    EXPECT_TRUE(says_that_nothing_moves(other)) << other;
  }
  EXPECT_TRUE(contains(complaint(arm("<motor joint='j' kp='3'/>")), "unknown attribute of motor 'kp'"));
}

TEST(MjcfWords, IntegratedRatesAreTargetsHeldToTheirActivation) {
  for (const char* words : {"<intvelocity joint='j' kp='3' kv='2' actrange='-.2 .4' ctrlrange='-9 9'/>",
                            "<general joint='j' gainprm='3' biastype='affine' biasprm='0 -3 -2' dyntype='integrator' "
                            "actrange='-.2 .4' ctrlrange='-9 9'/>"}) {
    const auto [servo, range] = drive(arm(words));
    EXPECT_EQ(servo.position_gain, 3) << words;
    EXPECT_EQ(servo.velocity_gain, 2) << words;
    EXPECT_EQ(servo.command_filter, 0) << words;
    ASSERT_TRUE(range) << words;
    EXPECT_EQ(fixtures::difference(*range, Vec3d{-.2, .4, 0}), 0) << words;
  }
}

TEST(MjcfWords, ReplicatesAreCopiesWithWhatNamesThem) {
  const auto robot = read(R"(<mujoco><compiler angle='radian'/><worldbody><body name='b'><freejoint/><geom size='.1'/>
    <body name='x'><joint name='x'/><geom size='.1'/></body>
    <replicate count='2' offset='0 1 0' euler='1 0 0'><replicate count='3' sep='-' offset='1 0 0' euler='0 .5 0'>
    <body name='l' pos='0 0 .3'><joint name='j' axis='0 1 0'/><geom name='g' size='.1'/><site name='s'/></body></replicate></replicate>
    <body name='y'><joint name='y'/><geom size='.1'/></body></body></worldbody>
    <contact><exclude name='e' body1='b' body2='l'/></contact>
    <actuator><position name='px' joint='x'/><position name='a' joint='j'/><motor name='py' joint='y'/></actuator>
    <sensor><gyro name='gyro' site='s'/><actuatorfrc name='f' actuator='a'/></sensor></mujoco>)");
  std::vector<std::string> joints;
  for (const int j : robot.model->joints()) joints.push_back(robot.model->objects()[j].name);
  EXPECT_EQ(joints, (std::vector<std::string>{"x", "j-00", "j-10", "j-20", "j-01", "j-11", "j-21", "y"}));
  EXPECT_EQ(robot.description.exclusions.size(), 6U);
  EXPECT_EQ(robot.description.exclusions[1].body2, "l-10");
  std::vector<std::string> sensors;
  for (const auto& sensor : robot.sensors) sensors.push_back(sensor.name);
  EXPECT_EQ(sensors.size(), 12U);
  EXPECT_EQ(std::ranges::count(sensors, "gyro-21"), 1);
  const auto body = std::ranges::find(robot.description.bodies, "l-21", &robot_formats::BodyDescription::name);
  ASSERT_NE(body, robot.description.bodies.end());
  EXPECT_TRUE(contains(body->where, "robot.xml:4")) << body->where;
  const Vec3d p = body->place.position;  // as MuJoCo has it
  const Vec3d inner{1.8775825618903728 + .3 * std::sin(1), 0, -0.479425538604203 + .3 * std::cos(1)};
  EXPECT_NEAR(p.x, inner.x, 1e-12);
  EXPECT_NEAR(p.y, 1 - std::sin(1) * inner.z, 1e-12);
  EXPECT_NEAR(p.z, std::cos(1) * inner.z, 1e-12);
  const auto with_count = [](const std::string& count) {
    return "<mujoco><worldbody><body><freejoint/><geom size='.1'/><replicate " + count +
           "><geom size='.1'/></replicate></body></worldbody></mujoco>";
  };
  EXPECT_TRUE(contains(complaint(with_count("count='0'")), "count '0' of replicate"));
  EXPECT_TRUE(contains(complaint(with_count("count='90000'")), "more than 100000 elements"));
  EXPECT_TRUE(contains(complaint(with_count("count='2' size='3'")), "unknown attribute of replicate 'size'"));
}

constexpr const char* arm_file = R"(<mujoco model='arm'><compiler angle='degree'/>
<default><geom rgba='1 0 0 1'/><default class='c'><joint damping='2'/></default></default>
<asset><material name='m' rgba='0 1 0 1'/></asset><worldbody><light pos='0 0 1'/>
<body name='up' pos='0 0 1'><joint name='j' class='c' axis='0 1 0' range='-90 90'/><geom name='g' size='.1' material='m' rgba='.5 .5 .5 1'/>
<body name='low' pos='0 0 -.2' euler='0 90 0'><joint name='k' axis='0 1 0'/><geom size='.05'/><site name='s'/></body></body>
<body name='other'><geom size='.1'/></body></worldbody><actuator><position name='a' joint='j' kp='3'/></actuator>
<sensor><gyro name='gy' site='s'/></sensor><contact><exclude body1='up' body2='low'/></contact>
<keyframe><key name='h' qpos='.1 .2'/></keyframe></mujoco>)";

TEST(MjcfWords, ModelsAreAttachedWithAllThatBelongsToThem) {
  std::ofstream(folder() / "arm.xml") << arm_file;
  const auto robot = read(R"(<mujoco><compiler angle='radian'/><default><geom rgba='0 0 1 1'/></default>
    <asset><model name='arm' file='arm.xml'/></asset><worldbody><body name='b'><freejoint/><geom name='trunk' size='.1'/>
    <frame pos='0 .1 0' euler='0 0 1'><attach model='arm' body='up' prefix='l_'/></frame>
    <attach model='arm' body='up' prefix='r_'/></body></worldbody><actuator><motor name='q' joint='l_k'/></actuator></mujoco>)");
  const Model& model = *robot.model;
  const Vec3d range = *model.find(properties::joint_range, model.object_index("l_j"));
  EXPECT_NEAR(range.y, .5 * pi, 1e-12);
  EXPECT_EQ(robot.description.bodies[1].joints[0].damping, 2);
  EXPECT_EQ(robot.description.bodies[0].shapes[0].placed.color, (Color{0, 0, 1, 1}));
  EXPECT_EQ(robot.description.bodies[1].name, "l_up");
  EXPECT_NEAR(robot.description.bodies[1].place.position.y, .1, 1e-15);
  EXPECT_EQ(robot.description.bodies[1].shapes[0].placed.color, (Color{0, 1, 0, 1}));  // of the material
  EXPECT_EQ(robot.description.bodies[2].shapes[0].placed.color, (Color{1, 0, 0, 1}));  // of the other file's class
  EXPECT_NEAR(robot.description.bodies[2].place.orientation.x.z, -1, 1e-12);           // 90 degrees
  EXPECT_EQ(model.find(properties::servo, model.object_index("r_j"))->position_gain, 3);
  ASSERT_EQ(robot.sensors.size(), 2U);
  EXPECT_EQ(robot.sensors[1].name, "r_gy");
  EXPECT_EQ(robot.description.exclusions[1].body1, "r_up");
  EXPECT_TRUE(std::ranges::any_of(robot.notes, [](const auto& note) { return contains(note, "arm.xml:8: keyframe"); }));

  const auto attached = [](const std::string& words) {
    return "<mujoco><asset><model name='arm' file='arm.xml'/><model name='none' "
           "file='none.xml'/></asset><worldbody><body name='b'>"
           "<freejoint/><geom size='.1'/><attach " +
           words + "/></body></worldbody></mujoco>";
  };
  EXPECT_TRUE(contains(complaint(attached("model='am'")), "unknown model 'am'"));
  EXPECT_TRUE(contains(complaint(attached("model='arm' body='no'")), "arm.xml has no body 'no'"));
  EXPECT_TRUE(contains(complaint(attached("model='none'")), "none.xml"));
  EXPECT_EQ(read(attached("model='arm'")).model->joints().size(), 2U);  // all of the other world
  std::ofstream(folder() / "none.xml") << attached("model='none'");
  EXPECT_TRUE(contains(complaint(attached("model='none'")), "more than 8 times"));
}

TEST(MjcfWords, GeomsHaveTheColorsOfTheirMaterials) {
  const auto robot = read(R"(<mujoco><default><material rgba='1 0 0 1'/><default class='c'><material rgba='0 1 0 .5'/>
    <geom rgba='1 1 0 1'/></default></default><asset><material name='m'/><material name='n' class='c'/><material name='o' rgba='0 0 1 1'/>
    </asset><worldbody><body name='b'><freejoint/><geom size='.1' material='m'/><geom size='.1' material='n'/>
    <geom size='.1' material='o' rgba='0 1 1 1'/><geom size='.1' material='o' rgba='.5 .5 .5 1'/><geom size='.1' class='c' material='o'/>
    <geom size='.1' rgba='1 1 1 0'/></body></worldbody></mujoco>)");
  std::vector<Color> colors;
  for (const auto& shape : robot.description.bodies[0].shapes) colors.push_back(shape.placed.color);
  EXPECT_EQ(colors,
            (std::vector<Color>{{1, 0, 0, 1}, {0, 1, 0, .5}, {0, 1, 1, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {1, 1, 1, 0}}));
  const auto material = [](const std::string& assets) {
    return "<mujoco><asset>" + assets +
           "</asset><worldbody><body><freejoint/><geom size='.1' material='x'/></body></worldbody></mujoco>";
  };
  EXPECT_TRUE(contains(complaint(material("<material name='y'/>")), "unknown material 'x'"));
  EXPECT_TRUE(contains(complaint(material("<material name='x' rgba='1 0 0 2'/>")), "each number must be from 0 to 1"));
}

TEST(MjcfWords, MaterialsHaveTheMeanColorOfBuiltinTextures) {
  const auto color = [](const std::string& texture, const std::string& rgba) {
    const auto robot = read("<mujoco><asset><texture name='t' " + texture + "/><material name='m' texture='t' " + rgba +
                            "/></asset><worldbody><body name='b'><freejoint/><geom size='.1' material='m'/></body>"
                            "</worldbody></mujoco>");
    return robot.description.bodies[0].shapes[0].placed.color;
  };
  EXPECT_EQ(color("builtin='flat' rgb1='1 .5 .25' rgb2='0 0 0'", ""), (Color{1, .5, .25, 1}));
  EXPECT_EQ(color("builtin='checker' rgb1='1 .5 .25' rgb2='0 .5 .75'", ""), (Color{.5, .5, .5, 1}));
  EXPECT_EQ(color("builtin='gradient' rgb1='1 .5 .25' rgb2='0 .5 .75'", "rgba='1 .5 0 .3'"), (Color{.5, .25, 0, .3}));
  EXPECT_EQ(color("file='wood.png'", "rgba='1 .5 0 1'"), (Color{1, .5, 0, 1})) << "no file is read";
}

// Rule: MuJoCo's documentation, XML reference, asset/texture and compiler: texturedir, assetdir, strippath.
TEST(MjcfWords, VisualMeshesHaveTexturesOfTheTypeOfPictures) {
  const auto read_visual = [](const std::string& compiler, const std::string& texture, const std::string& geom) {
    const auto robot =
        read("<mujoco>" + compiler + "<asset><mesh name='m' file='m.obj' material='own'/><texture " + texture +
             "/><material name='own'/><material name='skin' texture='t' rgba='1 .5 0 1'/>"
             "</asset><worldbody><body name='b'><freejoint/><geom size='.1'/><geom type='mesh' mesh='m' "
             "contype='0' conaffinity='0' mass='0' " +
             geom + "/></body></worldbody></mujoco>");
    const Visuals* visuals = robot.model->find(properties::visuals, robot.model->having(properties::visuals).at(0));
    return visuals->at(0);
  };
  const auto picture = [&](const std::string& compiler, const std::string& texture, const std::string& geom) {
    return std::filesystem::path(read_visual(compiler, texture, geom).picture).lexically_relative(folder()).string();
  };
  const std::string file = "name='t' type='2d' file='a/skin.png'", skin = "material='skin'";
  EXPECT_EQ(picture("", file, skin), "a/skin.png");
  EXPECT_EQ(read_visual("", file, skin).color, (Color{1, .5, 0, 1}));
  EXPECT_EQ(picture("<compiler assetdir='x' meshdir='y'/>", file, skin), "x/a/skin.png");
  EXPECT_EQ(picture("<compiler texturedir='z' assetdir='x' strippath='true'/>", file, skin), "z/skin.png");
  EXPECT_EQ(picture("", file, "material='skin' rgba='1 0 0 1'"), "a/skin.png") << "the color alone is replaced";
  EXPECT_EQ(read_visual("", file, "").picture, "") << "the mesh's own material";
  EXPECT_EQ(read_visual("", "name='t' type='cube' file='skin.png'", skin).picture, "");
  EXPECT_EQ(read_visual("", "name='t' type='2d' builtin='flat' file='skin.png'", skin).picture, "");
}

TEST(MjcfWords, KeysHavePosturesAndTargets) {
  const auto robot =
      read(arm("<motor joint='j'/><position joint='j' kp='3' gear='2'/></actuator><keyframe>"
               "<key name='home' qpos='1 2 3 0 2 0 0 .4' ctrl='9 1'/><key/></keyframe><actuator>"));
  const Keyframes& keys = *robot.model->find(properties::keyframes, 0);
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].name, "home");
  EXPECT_EQ(keys[0].positions[0].second, .4);
  EXPECT_EQ(keys[0].targets[0].second, .5);
  EXPECT_NEAR(keys[0].base.z.z, -1, 1e-15);
  EXPECT_EQ(keys[1].name, "key2");
  EXPECT_TRUE(keys[1].targets.empty());
  EXPECT_TRUE(contains(complaint(arm("</actuator><keyframe><key qpos='1 2 3'/></keyframe><actuator>")),
                       "qpos of key needs 8 numbers"));
}

TEST(MjcfWords, JointsMayStandInFrames) {
  const auto robot = read(
      R"(<mujoco><worldbody><frame euler='0 0 90'><body name='b'><frame><freejoint/></frame><geom size='.1'/><body name='l'>
    <frame pos='1 0 0' euler='0 0 90'><joint name='j' axis='1 0 0' pos='0 0 1'/><geom size='.2'/></frame></body></body></frame></worldbody></mujoco>)");
  const robot_formats::JointDescription& joint = robot.description.bodies[1].joints[0];
  EXPECT_NEAR(norm(joint.axis - Vec3d{0, 1, 0}), 0, 1e-15);
  EXPECT_NEAR(norm(joint.anchor - Vec3d{1, 0, 1}), 0, 1e-15);
}

/// The reader reads the writer's output as the same robot.
TEST(MjcfWords, WrittenFilesSayTheSame) {
  const auto robot =
      read(arm("<position joint='j' kp='30' kv='3' ctrlrange='-.2 .3' forcerange='-1 3' timeconst='.1'/></actuator>"
               "<keyframe><key name='home' qpos='1 2 3 1 0 0 0 .4' ctrl='.1'/></keyframe><actuator>",
               "", "ref='.3' actuatorfrcrange='-1 9'"));
  const std::string text = to_mjcf(robot.description);
  const auto again = read(text);
  EXPECT_EQ(to_mjcf(again.description), text);
  for (const char* words : {"ctrlrange=\"-0.2 0.3\"", "forcerange=\"-1 3\"", "timeconst=\"0.1\"",
                            "actuatorfrcrange=\"-1 9\"", "ref=\"0.3\"", "ctrl=\"0.1\""}) {
    EXPECT_TRUE(contains(text, words)) << words << " is not in " << text;
  }
  const auto fixed = read(arm("<general joint='j' gainprm='0' biastype='affine' biasprm='1 -4'/>"));
  EXPECT_EQ(to_mjcf(read(to_mjcf(fixed.description)).description), to_mjcf(fixed.description));
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
