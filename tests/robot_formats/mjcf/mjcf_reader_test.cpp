/// mjcf_reader_test - a robot file becomes the right model, and every error in it is named with file and line.
#include "murosimf/robot/robot_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/robot_formats/mjcf/mjcf_geom.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

const std::filesystem::path kid21 = std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml";

/// A file of its own for every test, so that tests can run at the same time.
std::filesystem::path test_file(const std::string& ending) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fixtures::temp_folder() / (std::string("mjcf_") + test->name() + ending);
}

std::filesystem::path write(const std::string& text, const std::string& ending = ".xml") {
  const auto file = test_file(ending);
  std::ofstream(file) << text;
  return file;
}

robot::RobotFile read(const std::string& text, bool lenient = false) {
  return robot::read_robot(write(text), {lenient});
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const SetupError& error) {
    return error.what();
  }
  return "no SetupError";
}

std::string message(const std::string& text, bool lenient = false) {
  return message_of([&] { (void)read(text, lenient); });
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool any_contains(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(texts, [&](const std::string& text) { return contains(text, part); });
}

/// One line that begins with the file, names the line and contains `part`.
void expect_complaint(const std::string& what, int line, const std::string& part) {
  EXPECT_TRUE(contains(what, test_file(".xml").string() + ":" + std::to_string(line) + ": ")) << what;
  EXPECT_TRUE(contains(what, part)) << what;
  EXPECT_FALSE(contains(what, "\n")) << what;
}

/// A base of 1 kg in lines 2 to 4; `inside` begins in line 5.
std::string robot(const std::string& inside, const std::string& before = "") {
  return "<mujoco model='r'>" + before + "\n<worldbody>\n<body name='b' pos='0 0 1'><freejoint name='root'/>\n" +
         "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>\n" + inside + "\n</body></worldbody>\n";
}
std::string closed(const std::string& text) { return text + "</mujoco>"; }
std::string closed_robot(const std::string& inside, const std::string& before = "") {
  return closed(robot(inside, before));
}

/// A limb with one joint; its body is 'limb', its joint 'j'.
std::string limb(const std::string& joint, const std::string& rest = "<inertial mass='1' diaginertia='1 1 1'/>") {
  return "<body name='limb'>" + joint + rest + "</body>";
}

void expect_near(const Vec3d& a, const Vec3d& b) { EXPECT_LT(norm(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z; }

void expect_same_turn(const Mat3d& a, const Mat3d& b) {
  expect_near(a.x, b.x);
  expect_near(a.y, b.y);
  expect_near(a.z, b.z);
}

/// Place of an object in world axes, base at the origin, all joints at `angle`.
Transform<double> pose(const Model& model, const std::string& object, double angle = 0) {
  const auto size = static_cast<std::size_t>(model.size());
  std::vector<double> q(size, angle);
  std::vector<Vec3d> r(size);
  std::vector<Mat3d> R(size);
  multibody::poses<double>(model.tree(), q, r, R);
  const int i = model.object_index(object);
  return {r[i], R[i]};
}

// ---- kid21 ----

TEST(MjcfReader, Kid21HasItsMassAndParts) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  EXPECT_EQ(model->name(), "kid21");
  EXPECT_NEAR(model->tree().mass, 4.30, 1e-12);
  EXPECT_EQ(model->joints().size(), 21u);
  EXPECT_EQ(model->having(properties::mass).size(), 22u);
  EXPECT_EQ(model->bodies().size(), 22u);
  EXPECT_EQ(*model->find(properties::mass, model->object_index("torso")), 1.1);
  EXPECT_EQ(*model->find(properties::mass, model->object_index("l_foot")), 0.15);
  expect_near(*model->find(properties::center_of_mass, model->object_index("r_hip_roll")), {-0.01, 0, 0});
}

TEST(MjcfReader, Kid21HasTheNamesOfTheFile) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  EXPECT_EQ(model->object_index("pelvis"), 0);
  EXPECT_EQ(model->object_index("l_foot"), model->object_index("j_l_foot"));
  EXPECT_EQ(model->objects()[model->object_index("l_foot")].name, "j_l_foot");
  EXPECT_EQ(model->objects()[model->object_index("torso.offset")].kind, Kind::translation);
  EXPECT_EQ(model->objects()[model->object_index("l_sole")].kind, Kind::endpoint);
  // bodies that sit at their parent's origin have no translation
  EXPECT_FALSE(model->find_object("l_thigh.offset"));
}

TEST(MjcfReader, Kid21HasSolesInTheRightPlace) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  const auto soles = model->having(properties::sole);
  ASSERT_EQ(soles.size(), 2u);
  EXPECT_EQ(model->objects()[soles[0]].name, "l_sole");
  EXPECT_EQ(model->find(properties::sole, soles[0])->half_length, 0.075);
  EXPECT_EQ(model->find(properties::sole, soles[0])->half_width, 0.045);
  // hip 0.02 below the pelvis, two limbs of 0.12, and 0.04 from the ankle to the ground
  expect_near(pose(*model, "l_sole").position, {0.015, 0.055, -0.30});
  expect_near(pose(*model, "r_sole").position, {0.015, -0.055, -0.30});
}

TEST(MjcfReader, Kid21HasServosOfItsTable) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  EXPECT_EQ(model->having(properties::servo).size(), 21u);
  const Servo& knee = *model->find(properties::servo, model->object_index("j_l_shin"));
  EXPECT_EQ(knee.type, "mx64");
  EXPECT_EQ(knee.stall_torque, 6.0);
  EXPECT_EQ(knee.position_gain, 30);
  EXPECT_EQ(model->find(properties::servo, model->object_index("j_head"))->type, "mx28");
  EXPECT_EQ(knee.law, "dc_motor");
  EXPECT_EQ(knee.rotor_inertia, 0.01);
  // kid21.xml has the same data of the same part; both would count it twice
  EXPECT_TRUE(model->having(properties::joint_armature).empty());
  EXPECT_TRUE(model->having(properties::joint_damping).empty());
  EXPECT_TRUE(model->having(properties::joint_friction).empty());
}

TEST(MjcfReader, Kid21HasSurfacesOfItsTable) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  const Shapes& foot = *model->find(properties::shapes, model->object_index("l_foot"));
  ASSERT_EQ(foot.size(), 2u);
  EXPECT_FALSE(foot[1].collides) << "is for the eye";
  EXPECT_EQ(foot[0].surface.material, "rubber");
  EXPECT_EQ(foot[0].surface.friction, 0.8);
  expect_near(std::get<Box>(foot[0].shape).half_size, {0.075, 0.045, 0.01});
  EXPECT_EQ(model->find(properties::shapes, model->object_index("torso"))->front().surface.material, "plastic");
}

TEST(MjcfReader, Kid21HasTwentyBodiesWithOneShapeEachThatCollides) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  const auto with_shapes = model->having(properties::shapes);
  EXPECT_EQ(with_shapes.size(), 20u);
  for (const int i : with_shapes) {
    EXPECT_EQ(std::ranges::count_if(*model->find(properties::shapes, i), &PlacedShape::collides), 1);
  }
  // the ankle servo is above the ground when the foot stands
  const double sole_height = 0.04;
  const Shapes& ankle = *model->find(properties::shapes, model->object_index("l_ankle"));
  EXPECT_LT(std::get<Sphere>(ankle[0].shape).radius, sole_height - 0.01);
}

TEST(MjcfReader, Kid21IgnoresTheFloorWithANote) {
  const auto [model, warnings, notes, table, carried, description] = robot::read_robot(kid21);
  EXPECT_TRUE(any_contains(notes, "world geom 'floor' ignored: the scene brings its own ground"));
  EXPECT_TRUE(any_contains(notes, "element 'option' is not used"));
  for (const std::string& note : notes) EXPECT_TRUE(contains(note, "kid21.xml:")) << note;
  EXPECT_TRUE(warnings.empty());
}

// ---- frames and joints ----

TEST(MjcfReader, AllWaysToWriteAnOrientationAgree) {
  // 90 deg about x
  const Mat3d turn = rotation_x(0.5 * pi);
  for (const char* text :
       {"quat='1 1 0 0'", "euler='90 0 0'", "axisangle='2 0 0 90'", "xyaxes='1 0 0 1 0 1'", "zaxis='0 -3 0'"}) {
    const auto model = read(closed_robot(std::string("<body name='c' ") + text + "/>")).model;
    expect_same_turn(pose(*model, "c").orientation, turn);
  }
}

TEST(MjcfReader, EulerAnglesFollowTheSequence) {
  const std::string body = "<body name='c' euler='0.3 0.2 0.1'/>";
  const auto turn = [&](const std::string& sequence) {
    const auto compiler = "<compiler angle='radian' eulerseq='" + sequence + "'/>";
    return pose(*read(closed_robot(body, compiler)).model, "c").orientation;
  };
  expect_same_turn(turn("xyz"), rotation_x(0.3) * rotation_y(0.2) * rotation_z(0.1));
  expect_same_turn(turn("zyx"), rotation_z(0.3) * rotation_y(0.2) * rotation_x(0.1));
  expect_same_turn(turn("XYZ"), rotation_z(0.1) * rotation_y(0.2) * rotation_x(0.3));
}

TEST(MjcfReader, AJointAwayFromTheOriginTurnsTheBodyAboutItself) {
  const auto model = read(closed_robot("<body name='c' pos='1 0 0'><joint name='j' pos='0 0 1' axis='0 1 0'/>"
                                       "<inertial mass='1' diaginertia='1 1 1'/></body>"))
                         .model;
  // 90 deg about y through (1 0 1): the origin, 1 below, goes to -x
  const auto turned = pose(*model, "c", 0.5 * pi);
  expect_near(turned.position, {0, 0, 1});
  expect_same_turn(turned.orientation, rotation_y(0.5 * pi));
  EXPECT_NE(model->object_index("c"), model->object_index("j"));
  EXPECT_TRUE(model->find(properties::mass, model->object_index("c")));
}

TEST(MjcfReader, RangesAreInRadiansAndOfHingesOnly) {
  const std::string hinge = limb("<joint name='j' axis='0 0 2' range='-90 45'/>");
  const auto range = [](const std::string& text) {
    const auto model = read(text).model;
    const Vec3d* found = model->find(properties::joint_range, model->object_index("j"));
    return found ? *found : Vec3d{};
  };
  expect_near(range(closed_robot(hinge)), {-0.5 * pi, 0.25 * pi, 0});
  expect_near(range(closed_robot(hinge, "<compiler angle='radian'/>")), {-90, 45, 0});
  expect_near(range(closed_robot(hinge, "<compiler autolimits='false'/>")), {});
  expect_near(range(closed_robot(limb("<joint name='j' type='slide' axis='1 0 0' range='-1 2'/>"))), {-1, 2, 0});
  expect_near(range(closed_robot(limb("<joint name='j' axis='1 0 0' range='-1 2' limited='false'/>"))), {});
}

TEST(MjcfReader, BodiesWithoutJointOrNameAreFine) {
  const auto model = read(closed_robot("<body pos='1 0 0'><body quat='0 1 0 0'/><body><joint axis='1 0 0'/>"
                                       "<joint axis='0 1 0'/><inertial mass='2' diaginertia='1 1 1'/></body></body>"))
                         .model;
  EXPECT_EQ(model->joints().size(), 2u);
  EXPECT_EQ(model->objects()[model->object_index("body_2")].kind, Kind::endpoint);
  expect_near(pose(*model, "body_2").position, {1, 0, 0});
  expect_near(pose(*model, "body_3").orientation.z, {0, 0, -1});
  EXPECT_EQ(model->object_index("body_4"), model->object_index("body_4.joint2"));
  EXPECT_EQ(model->objects()[model->object_index("body_4.joint2")].parent, model->object_index("body_4.joint"));
  EXPECT_EQ(model->object_index("root"), 0);
}

TEST(MjcfReader, ABodyMayShareItsNameWithAJoint) {
  const auto own =
      read(closed_robot("<body name='a'><joint name='a' axis='1 0 0'/>"
                        "<inertial mass='1' diaginertia='1 1 1'/></body>"));
  EXPECT_EQ(own.model->objects()[own.model->object_index("a")].kind, Kind::revolute);
  EXPECT_TRUE(own.warnings.empty());
  const auto other =
      read(closed_robot("<body name='a'><joint name='c' axis='1 0 0'/><inertial mass='1' "
                        "diaginertia='1 1 1'/><body name='c' pos='0 0 1'><site name='a'/></body></body>"));
  EXPECT_EQ(other.model->objects()[other.model->object_index("c.body")].kind, Kind::endpoint);
  EXPECT_EQ(other.model->objects()[other.model->object_index("a.site")].kind, Kind::endpoint);
  EXPECT_EQ(other.warnings.size(), 2u);
}

TEST(MjcfReader, SitesNamedSoleAreSolesWithoutATable) {
  const auto model = read(closed_robot("<site name='left_sole' type='box' size='0.1 0.05 0.01' pos='0 1 0' "
                                       "euler='0 0 90'/><site name='imu'/><site name='round_sole' size='1'/>"))
                         .model;
  EXPECT_EQ(model->having(properties::sole), std::vector{model->object_index("left_sole")});
  expect_near(pose(*model, "left_sole").position, {0, 1, 0});
  expect_same_turn(pose(*model, "left_sole").orientation, rotation_z(0.5 * pi));
  EXPECT_EQ(model->objects()[model->object_index("imu")].kind, Kind::endpoint);
}

// ---- classes ----

TEST(MjcfReader, DefaultsReachElementsThroughClasses) {
  const std::string defaults =
      "<default><geom density='0' rgba='1 0 0 1'/><default class='leg'><joint axis='0 1 0' damping='2'/>"
      "<geom type='box' size='1 2 3'/><default class='knee'><joint damping='3'/></default></default></default>";
  const auto model =
      read(closed_robot("<body name='c' childclass='leg'><joint name='j1'/><joint name='j2' class='knee'/>"
                        "<geom/><geom class='main' size='4'/>"
                        "<inertial mass='1' diaginertia='1 1 1'/></body>",
                        defaults))
          .model;
  const int j1 = model->object_index("j1"), j2 = model->object_index("j2");
  expect_near(model->objects()[j2].vector, {0, 1, 0});
  EXPECT_EQ(*model->find(properties::joint_damping, j1), 2);
  EXPECT_EQ(*model->find(properties::joint_damping, j2), 3);
  const Shapes& shapes = *model->find(properties::shapes, j2);
  expect_near(std::get<Box>(shapes[0].shape).half_size, {1, 2, 3});
  EXPECT_EQ(std::get<Sphere>(shapes[1].shape).radius, 4);
  EXPECT_EQ(shapes[0].color.red, 1);
}

// ---- mass and shape ----

TEST(MjcfReader, SolidsHaveTheInertiaOfTheirShape) {
  expect_near({robot_formats::unit_inertia(Sphere{2}).xx, robot_formats::unit_inertia(Sphere{2}).zz, 0}, {1.6, 1.6, 0});
  const SymMat3d box = robot_formats::unit_inertia(Box{{1, 2, 3}});
  expect_near({box.xx, box.yy, box.zz}, {13.0 / 3, 10.0 / 3, 5.0 / 3});
  const SymMat3d ellipsoid = robot_formats::unit_inertia(Ellipsoid{{1, 2, 3}});
  expect_near({ellipsoid.xx, ellipsoid.yy, ellipsoid.zz}, {2.6, 2.0, 1.0});
  const SymMat3d cylinder = robot_formats::unit_inertia(Cylinder{2, 3});
  expect_near({cylinder.xx, cylinder.yy, cylinder.zz}, {4, 4, 2});
  EXPECT_NEAR(robot_formats::volume(Capsule{1, 1}), 4.0 / 3 * pi + 2 * pi, 1e-12);
}

/// Sum over thin discs, of a solid of unit mass: I_zz = int r^2/2 dm, I_xx = int (r^2/4 + z^2) dm.
TEST(MjcfReader, ACapsuleHasTheInertiaOfItsDiscs) {
  const double radius = 0.3, half = 0.5, top = half + radius;
  constexpr int discs = 200000;
  double mass = 0, xx = 0, zz = 0;
  for (int i = 0; i < discs; ++i) {
    const double z = top * (2.0 * (i + 0.5) / discs - 1.0);
    const double beyond = std::max(0.0, std::abs(z) - half);
    const double rr = radius * radius - beyond * beyond;
    mass += rr;
    xx += rr * (0.25 * rr + z * z);
    zz += rr * 0.5 * rr;
  }
  const SymMat3d inertia = robot_formats::unit_inertia(Capsule{radius, half});
  // the sum of discs errs by about 1/discs^2
  EXPECT_NEAR(inertia.xx, xx / mass, 1e-9);
  EXPECT_NEAR(inertia.zz, zz / mass, 1e-9);
}

TEST(MjcfReader, MassComesFromGeomsWhereThereIsNoInertial) {
  const std::string geoms = "<geom type='box' size='0.1 0.1 0.1' pos='1 0 0'/><geom size='0.1' pos='-1 0 0' mass='8'/>";
  const auto model = read(closed_robot(limb("<joint name='j' axis='0 0 1'/>", geoms))).model;
  const int j = model->object_index("j");
  EXPECT_NEAR(*model->find(properties::mass, j), 16, 1e-12);  // 0.008 m^3 of 1000 kg/m^3, and 8 kg
  expect_near(*model->find(properties::center_of_mass, j), {});
  const SymMat3d& inertia = *model->find(properties::inertia, j);
  EXPECT_NEAR(inertia.xx, 8 * 0.02 / 3 + 8 * 0.004, 1e-12);
  EXPECT_NEAR(inertia.zz, 8 * 0.02 / 3 + 8 * 0.004 + 16, 1e-12);
}

TEST(MjcfReader, InertialsMayBeTurnedOrFull) {
  const auto inertia = [](const std::string& inertial) {
    const auto model = read(closed_robot(limb("<joint name='j' axis='0 0 1'/>", inertial))).model;
    return *model->find(properties::inertia, model->object_index("j"));
  };
  const SymMat3d turned = inertia("<inertial mass='1' diaginertia='3 4 5' euler='0 0 90'/>");
  expect_near({turned.xx, turned.yy, turned.zz}, {4, 3, 5});
  const SymMat3d full = inertia("<inertial mass='1' fullinertia='3 4 5 .1 .2 .3'/>");
  expect_near({full.xy, full.xz, full.yz}, {.1, .2, .3});
}

TEST(MjcfReader, AnImpossibleInertiaIsAWarning) {
  const auto result = read(closed_robot(limb("<joint axis='0 0 1'/>", "<inertial mass='1' diaginertia='1 1 3'/>")));
  EXPECT_TRUE(any_contains(result.warnings, ":5: no solid body has the principal moments 1 1 3"));
}

TEST(MjcfReader, FromToPlacesLongShapes) {
  const auto model = read(closed_robot("<geom type='capsule' size='0.1' fromto='0 1 2 0 1 6'/>"
                                       "<geom type='cylinder' size='0.1' fromto='0 0 0 2 0 0' friction='0.3 0 0' "
                                       "rgba='.1 .2 .3 1' contype='0' conaffinity='0'/>"))
                         .model;
  const Shapes& shapes = *model->find(properties::shapes, 0);
  EXPECT_EQ(std::get<Capsule>(shapes[0].shape).half_length, 2);
  expect_near(shapes[0].position, {0, 1, 4});
  EXPECT_TRUE(shapes[0].collides);
  EXPECT_EQ(shapes[0].surface.friction, 1.0);
  EXPECT_EQ(std::get<Cylinder>(shapes[1].shape).half_length, 1);
  EXPECT_NEAR(std::abs(shapes[1].orientation.z.x), 1, 1e-12);
  EXPECT_EQ(shapes[1].surface.friction, 0.3);
  EXPECT_EQ(shapes[1].color.blue, 0.3);
  EXPECT_FALSE(shapes[1].collides);
}

// ---- servos ----

const std::string rough_joint = limb("<joint name='j' axis='0 0 1' armature='0.1' damping='0.3' frictionloss='0.2'/>");

ModelPtr actuated(const std::string& actuators, const std::string& joint = rough_joint) {
  return read(closed(robot(joint) + "<actuator>\n" + actuators + "</actuator>")).model;
}
Servo servo(const std::string& actuators, const std::string& joint = rough_joint) {
  const auto model = actuated(actuators, joint);
  return *model->find(properties::servo, model->object_index("j"));
}

TEST(MjcfReader, ActuatorsBecomeServos) {
  const Servo position = servo("<position joint='j' kp='20' forcerange='-3 4' kv='1'/>");
  EXPECT_EQ(position.type, "position");
  EXPECT_EQ(position.law, "ideal_pd");
  EXPECT_EQ(position.position_gain, 20);
  EXPECT_EQ(position.velocity_gain, 1);
  EXPECT_EQ(position.stall_torque, 4);
  EXPECT_EQ(servo("<motor joint='j' gear='10' ctrlrange='-1 1'/>").stall_torque, 10);
  EXPECT_EQ(servo("<motor joint='j'/>").position_gain, 0);
  const Servo general = servo("<general joint='j' gainprm='7' biastype='affine' biasprm='0 -7 -2'/>");
  EXPECT_EQ(general.position_gain, 7);
  EXPECT_EQ(general.velocity_gain, 2);
  const Servo geared = servo("<position joint='j' kp='5' kv='3' gear='2'/>");
  EXPECT_EQ(geared.position_gain, 20);
  EXPECT_EQ(geared.velocity_gain, 12);
  // the usual pair before position actuators had kv
  const Servo pair = servo("<position joint='j' kp='5'/><velocity joint='j' kv='3'/>");
  EXPECT_EQ(pair.position_gain, 5);
  EXPECT_EQ(pair.velocity_gain, 3);
}

TEST(MjcfReader, RotorAndFrictionOfTheFileStayWithTheJoint) {
  const auto model = actuated("<position joint='j' kp='20'/>");
  const int j = model->object_index("j");
  EXPECT_EQ(*model->find(properties::joint_armature, j), 0.1);
  EXPECT_EQ(*model->find(properties::joint_damping, j), 0.3);
  EXPECT_EQ(*model->find(properties::joint_friction, j), 0.2);
  const Servo& servo = *model->find(properties::servo, j);
  EXPECT_EQ(servo.rotor_inertia, 0);
  EXPECT_EQ(servo.friction.coulomb, 0);
  EXPECT_EQ(servo.friction.viscous, 0);
}

TEST(MjcfReader, TheForceRangeOfAJointLimitsItsServo) {
  const std::string joint = limb("<joint name='j' axis='0 0 1' actuatorfrcrange='-2 2'/>");
  EXPECT_EQ(servo("<position joint='j'/>", joint).stall_torque, 2);
  EXPECT_EQ(servo("<position joint='j' forcerange='-1 1'/>", joint).stall_torque, 1);
}

TEST(MjcfReader, NegativeGainsAreNamed) {
  const auto complaint = [](const std::string& actuator) { return message_of([&] { (void)actuated(actuator); }); };
  expect_complaint(complaint("<position joint='j' kp='-1'/>"), 8, "kp of position is negative");
  expect_complaint(complaint("<position joint='j' kv='-1'/>"), 8, "kv of position is negative");
  expect_complaint(complaint("<general joint='j' biastype='affine' biasprm='0 -2 1'/>"), 8, "is negative");
}

TEST(MjcfReader, AServoOfTheTableReplacesJointAndActuator) {
  write("[servos.big]\ntype = 'mx64'\nstall_torque = 9\njoints = ['j']\n", ".toml");
  const auto model = actuated("<position joint='j' kp='20' forcerange='-3 3'/>");
  std::filesystem::remove(test_file(".toml"));
  const int j = model->object_index("j");
  const Servo& servo = *model->find(properties::servo, j);
  EXPECT_EQ(servo.type, "mx64");
  EXPECT_EQ(servo.law, "dc_motor");
  EXPECT_EQ(servo.stall_torque, 9);
  EXPECT_EQ(servo.velocity_gain, 0);
  EXPECT_FALSE(model->find(properties::joint_armature, j));
  EXPECT_FALSE(model->find(properties::joint_damping, j));
  EXPECT_FALSE(model->find(properties::joint_friction, j));
}

TEST(MjcfReader, TheTableBesideMustSpeakOfTheRobot) {
  const auto complaint = [](const std::string& table) {
    write(table, ".toml");
    const auto text = message(closed_robot("<site name='foot' size='1'/>" + limb("<joint name='j' axis='0 0 1'/>")));
    std::filesystem::remove(test_file(".toml"));
    return text;
  };
  EXPECT_TRUE(contains(complaint("[soles]\nleft = 'fot'\n"), ".toml:2:8: unknown frame 'fot'; did you mean 'foot'?"));
  EXPECT_TRUE(contains(complaint("[surfaces]\nlimp = 'rubber'\n"), ".toml:2:1: unknown body 'limp'"));
  EXPECT_TRUE(
      contains(complaint("[soles]\nleft = 'foot'\n"), ".toml:2:8: 'foot' cannot be a sole: its body has no shape"));
}

// ---- couplings, contacts, sensors, frames, includes ----

TEST(MjcfReader, ReadsSpringsAndTheReferenceOfAJoint) {
  const auto [model, warnings, notes, table, carried, description] =
      read(closed_robot("<body name='a' pos='0 0 1'><joint name='j' axis='0 2 0' ref='90' stiffness='3' "
                        "springref='45'/><geom size='1'/><site name='tip' pos='0 0 -1'/></body>"));
  const robot_formats::JointDescription& joint = description.bodies[1].joints[0];
  EXPECT_EQ(joint.stiffness, 3);
  EXPECT_NEAR(joint.reference, pi / 2, 1e-15);
  EXPECT_NEAR(joint.spring_reference, pi / 4, 1e-15);
  // at joint position 90 degrees the tip is where the file has it, at 0 it is turned back
  expect_near(pose(*model, "tip", pi / 2).position, {0, 0, 0});
  expect_near(pose(*model, "tip", 0).position, {1, 0, 1});
}

TEST(MjcfReader, FramesShiftAndTurnWhatStandsInThem) {
  const auto [model, warnings, notes, table, carried, description] =
      read(closed_robot("<frame pos='1 0 0' euler='0 0 90'><frame pos='0 1 0'><geom name='g' size='1' pos='1 0 0'/>"
                        "</frame><body name='c' pos='2 0 0'><joint axis='0 0 1'/><geom size='1'/></body>"
                        "<site name='s'/></frame>"));
  expect_near(description.bodies[0].shapes[0].placed.position, {0, 1, 0});
  expect_near(description.bodies[1].place.position, {1, 2, 0});
  expect_near(description.bodies[1].place.orientation.x, {0, 1, 0});
  expect_near(description.bodies[0].frames[0].place.position, {1, 0, 0});
}

TEST(MjcfReader, WeldsBodiesWithoutJointsAndKeepsTheirFrames) {
  const auto [model, warnings, notes, table, carried, description] =
      read(closed_robot("<body name='bar' pos='2 0 0' euler='0 0 90'>"
                        "<inertial mass='1' pos='2 0 0' diaginertia='1 2 2'/><geom type='box' size='1 2 3'/>"
                        "<site name='end' pos='1 0 0'/><body name='tip' pos='0 1 0'>"
                        "<joint name='j' axis='0 0 1'/><geom size='1'/></body></body>"));
  ASSERT_EQ(description.bodies.size(), 2U);
  const robot_formats::BodyDescription& base = description.bodies[0];
  EXPECT_EQ(base.solid.mass, 2);
  expect_near(base.solid.center, {1, 1, 0});
  EXPECT_NEAR(base.solid.inertia.zz, 1 + 2 + 2 * 2, 1e-12);  // two masses of 1 kg at 1.414 m
  EXPECT_NEAR(base.solid.inertia.yy, 1 + 1 + 2, 1e-12);      // the bar's own xx is yy here
  EXPECT_NEAR(base.solid.inertia.xy, -2, 1e-12);
  expect_near(base.shapes[0].placed.position, {2, 0, 0});
  expect_near(description.bodies[1].place.position, {1, 0, 0});
  for (const char* frame : {"bar", "end"}) EXPECT_TRUE(model->find_object(frame)) << frame;
}

TEST(MjcfReader, ReadsCoupledJointsExclusionsAndSensors) {
  const std::string two = limb("<joint name='a' axis='0 0 1'/><joint name='a2' axis='0 1 0'/><site name='imu'/>");
  const auto description =
      read(closed(robot(two) + "<equality><joint joint1='a2' joint2='a' polycoef='0.1 -2 0 0 0'/></equality>"
                               "<contact><exclude body1='b' body2='limb'/></contact>"
                               "<sensor><gyro name='g' site='imu'/><jointpos joint='a'/></sensor>"))
          .description;
  ASSERT_EQ(description.mimics.size(), 1U);
  EXPECT_EQ(description.mimics[0].joint, "a2");
  EXPECT_EQ(description.mimics[0].leader, "a");
  EXPECT_EQ(description.mimics[0].ratio, -2);
  EXPECT_EQ(description.mimics[0].offset, 0.1);
  ASSERT_EQ(description.exclusions.size(), 1U);
  EXPECT_EQ(description.exclusions[0].body2, "limb");
  ASSERT_EQ(description.sensors.size(), 2U);
  EXPECT_EQ(description.sensors[0].kind, "gyro");
  EXPECT_EQ(description.sensors[1].frame, "a");
}

TEST(MjcfReader, ThingsOfDifferentKindsMayShareAName) {
  const std::string inside = "<body name='imu'><site name='imu'/><camera name='imu'/></body><site name='root'/>" +
                             limb("<joint name='eye' axis='0 0 1'/><camera name='limb'/>");
  const auto robot = read(closed_robot(inside + "<camera name='eye'/>"));
  for (const char* name : {"imu", "imu.site", "imu.camera", "root", "root.site", "eye", "eye.camera", "limb.camera"}) {
    EXPECT_TRUE(robot.model->find_object(name)) << name;
  }
  EXPECT_EQ(robot.model->object_index("root"), 0);
  EXPECT_TRUE(any_contains(robot.warnings, "site 'imu' is called 'imu.site' here"));
}

TEST(MjcfReader, CoupledJointsCountFromTheirReferences) {
  const std::string two = limb("<joint name='a' axis='0 0 1' ref='90'/><joint name='a2' axis='0 1 0' ref='-90'/>");
  const auto description =
      read(closed(robot(two) + "<equality><joint joint1='a2' joint2='a' polycoef='0.1'/></equality>")).description;
  EXPECT_EQ(description.mimics[0].ratio, 1);
  EXPECT_NEAR(description.mimics[0].offset, 0.1 - pi, 1e-12);  // -pi/2 + 0.1 = offset + pi/2 in the pose of the file
}

TEST(MjcfReader, AGeomPairedWithTheFloorCollides) {
  const std::string foot = "<geom name='foot' size='1' contype='0' conaffinity='0'/>";
  const std::string pair = "<contact><pair geom1='foot' geom2='floor'/></contact>";
  const auto with_floor = [&](const std::string& contact) {
    const std::string floor = "<worldbody><geom name='floor' type='plane' size='1 1 1'/></worldbody>";
    return read(closed(robot(foot, floor) + contact));
  };
  EXPECT_FALSE(with_floor("").description.bodies[0].shapes[0].placed.collides);
  EXPECT_TRUE(with_floor(pair).description.bodies[0].shapes[0].placed.collides);
}

TEST(MjcfReader, AGeomThatStandsOnTheFilesFloorStandsOnOurs) {
  const auto shape = [](const std::string& masks, const std::string& floor) {
    const std::string world = "<worldbody><geom type='plane' size='1 1 1' " + floor + "/></worldbody>";
    return read(closed_robot("<geom size='1' " + masks + "/>", world)).description.bodies[0].shapes[0].placed;
  };
  const PlacedShape usual{};
  EXPECT_TRUE(may_touch(shape("contype='2' conaffinity='2'", "contype='2' conaffinity='2'"), usual));
  EXPECT_FALSE(may_touch(shape("contype='2' conaffinity='2'", ""), usual)) << "does not stand on it in the file either";
  EXPECT_EQ(shape("contype='1' conaffinity='2'", "").contact_affinity, 2U);
}

TEST(MjcfReader, IncludesOtherFiles) {
  write("<mujocoinclude><body name='part'><joint name='j' axis='0 0 1'/><geom size='1'/></body></mujocoinclude>",
        ".inc");
  const std::string name = test_file(".inc").filename().string();
  EXPECT_TRUE(read(closed_robot("<include file='" + name + "'/>")).model->find_object("part"));
  EXPECT_TRUE(contains(message(closed_robot("<include file='" + name + "'/><include file='" + name + "'/>")),
                       "is included a second time"));
  EXPECT_TRUE(contains(message(closed_robot("<include file='nowhere.xml'/>")), "nowhere.xml: there is no such file"));
  write("<mujocoinclude>\n<body name='part'><joint axis='0 0 0'/></body></mujocoinclude>", ".inc");
  EXPECT_TRUE(contains(message(closed_robot("<include file='" + name + "'/>")), ".inc:2: axis of joint"));
  write("<mujocoinclude><include file='" + name + "'/></mujocoinclude>", ".inc");
  EXPECT_TRUE(contains(message(closed_robot("<include file='" + name + "'/>")), "is included a second time"));
  std::filesystem::remove(test_file(".inc"));
}

TEST(MjcfReader, MassesFollowTheCompilersRules) {
  const auto read_with = [](const std::string& compiler, const std::string& inertial) {
    return read(closed_robot(limb("<joint axis='0 0 1'/>", inertial), "<compiler " + compiler + "/>")).description;
  };
  const std::string thin = "<inertial mass='1' diaginertia='1 1 4'/>";
  const auto balanced = read_with("balanceinertia='true'", thin);
  EXPECT_EQ(balanced.bodies[1].solid.inertia.zz, 2);
  EXPECT_EQ(balanced.bodies[1].solid.inertia.xx, 2);
  const auto bounded = read_with("boundmass='3' boundinertia='2'", thin);
  EXPECT_EQ(bounded.bodies[1].solid.mass, 3);
  EXPECT_NEAR(bounded.bodies[1].solid.inertia.xx, 2, 1e-14);
  EXPECT_NEAR(bounded.bodies[1].solid.inertia.zz, 4, 1e-14);
  const auto scaled = read_with("settotalmass='10'", thin);
  EXPECT_NEAR(scaled.bodies[0].solid.mass + scaled.bodies[1].solid.mass, 10, 1e-14);
}

TEST(MjcfReader, ADampingRatioIsTurnedIntoAGain) {
  // 2 kg in 3 m and the rotor; the trunk has no effect
  const std::string heavy = "<body name='c' pos='3 0 0'><inertial mass='2' pos='0 0 0' diaginertia='1 1 1'/></body>";
  const Servo damped =
      servo("<position joint='j' kp='4' dampratio='0.5'/>",
            limb("<joint name='j' axis='0 0 1' armature='0.5'/>", "<inertial mass='1' diaginertia='1 1 1'/>" + heavy));
  EXPECT_NEAR(damped.velocity_gain, 2 * 0.5 * std::sqrt(4 * (0.5 + 1 + 1 + 2 * 9)), 1e-12);
  EXPECT_EQ(damped.position_gain, 4);
  EXPECT_TRUE(contains(message_of([] { (void)servo("<position joint='j' kp='4' kv='1' dampratio='0.5'/>"); }),
                       "both kv and dampratio"));
}

// ---- errors ----

TEST(MjcfReader, NamesMissingAndBrokenFiles) {
  EXPECT_TRUE(
      contains(message_of([] { (void)robot::read_robot("nowhere.xml"); }), "nowhere.xml: there is no such file"));
  EXPECT_TRUE(contains(message_of([] { (void)robot::read_robot(fixtures::temp_folder()); }), "this is a folder"));
  expect_complaint(message("<mujoco>\n<worldbody>\n</mujoco>"), 2, "not well-formed XML");
  expect_complaint(message(""), 1, "not well-formed XML");
  expect_complaint(message("just text"), 1, "not well-formed XML");
  expect_complaint(
      message("<!-- -->\n<collada/>"), 2,
      "unknown format of a robot file: its root is <collada>; known: mjcf (<mujoco>), urdf (<robot>), sdf (<sdf>)");
}

TEST(MjcfReader, NamesUnknownWords) {
  expect_complaint(message(closed_robot("<body nmae='c'/>")), 5,
                   "unknown attribute of body 'nmae'; did you mean 'name'?");
  expect_complaint(message(closed_robot("<bdy/>")), 5, "unknown element in body 'bdy'; did you mean 'body'?");
  expect_complaint(message(closed_robot("<body foo='1'><bar/></body>\n<baz/>")), 5, "and 2 more like this");
  expect_complaint(message(closed_robot(limb("<joint axis='0 0 1' springyield='3'/>"))), 5,
                   "'springyield' of joint is not supp");
  expect_complaint(message(closed(robot("") + "<deformable/>")), 7, "element 'deformable' is not supported");
}

TEST(MjcfReader, LenientReadingWarnsOfUnknownWords) {
  const auto result = read(closed_robot("<body foo='1'><bar/></body>\n<baz/><geom type='mesh' mesh='m'/>"), true);
  EXPECT_TRUE(any_contains(result.warnings, ":5: unknown attribute of body 'foo'"));
  EXPECT_TRUE(any_contains(result.warnings, ":5: unknown element in body 'bar'"));
  EXPECT_TRUE(any_contains(result.warnings, ":6: unknown element in body 'baz'"));
  EXPECT_TRUE(any_contains(result.warnings, ":6: mesh 'm' ignored"));
}

TEST(MjcfReader, NamesWhatIsWrongWithTheBase) {
  expect_complaint(message("<mujoco>\n<worldbody/></mujoco>"), 1, "no body in worldbody");

  expect_complaint(message(closed_robot("\n<joint axis='0 0 1'/>")), 6, "second joint");
  EXPECT_EQ(read("<mujoco><worldbody><body name='b'><joint type='free'/></body></worldbody></mujoco>").model->size(),
            2);
}

TEST(MjcfReader, NamesWhatIsWrongWithJoints) {
  expect_complaint(message(closed_robot(limb("<joint name='j' axis='0 0 0'/>"))), 5,
                   "axis of joint 'j' has no direction");
  EXPECT_EQ(read(closed_robot(limb("<joint name='j'/>"))).description.bodies[1].joints[0].axis.z, 1)
      << "the format's default";

  expect_complaint(message(closed_robot(limb("<joint type='hing' axis='0 0 1'/>"))), 5, "did you mean 'hinge'?");
  expect_complaint(message(closed_robot(limb("<joint type='free'/>"))), 5, "only its base may be free");
  expect_complaint(message(closed_robot(limb("<joint axis='1 0 0' range='2 1'/>"))), 5, "must go from lower to higher");
  expect_complaint(message(closed_robot(limb("<joint axis='1 0 0' damping='-1'/>"))), 5,
                   "damping of joint is negative");
  expect_complaint(message(closed_robot(limb("<joint axis='1 0 0' limited='true'/>"))), 5, "there is no range");
  expect_complaint(message(closed_robot(limb("<joint axis='1 0 0' class='leg'/>"))), 5, "unknown default class 'leg'");
  expect_complaint(message(closed(robot(limb("<joint name='knee' axis='1 0 0'/>")) +
                                  "<actuator>\n<motor joint='kne'/></actuator>")),
                   8, "unknown joint 'kne'; did you mean 'knee'?");
}

TEST(MjcfReader, NamesBadNumbers) {
  expect_complaint(message(closed_robot("<body pos='0 nan 0'/>")), 5, "pos of body is '0 nan 0'; write finite numbers");
  expect_complaint(message(closed_robot("<body pos='0 1e999 0'/>")), 5, "write finite numbers");
  expect_complaint(message(closed_robot("<body pos='0 1,5 0'/>")), 5, "write finite numbers");
  expect_complaint(message(closed_robot("<body pos='0 1'/>")), 5, "pos of body needs 3 numbers, '0 1' has 2");
  expect_complaint(message(closed_robot("<body quat='0 0 0 0'/>")), 5, "quat of length zero");
  expect_complaint(message(closed_robot("<body quat='1 0 0 0' euler='0 0 0'/>")), 5, "two orientations");
  expect_complaint(message(closed_robot("<geom/>", "\n<default><geom size='x'/></default>")), 2, "size of geom is 'x'");
}

TEST(MjcfReader, NamesImpossibleMasses) {
  const auto mass = [](const std::string& attributes) {
    return message(closed_robot("\n" + limb("<joint axis='1 0 0'/>", "<inertial " + attributes + "/>")));
  };
  expect_complaint(mass("mass='-1' diaginertia='1 1 1'"), 6, "mass -1 kg is not positive");
  expect_complaint(mass("diaginertia='1 1 1'"), 6, "inertial without mass");
  expect_complaint(mass("mass='1'"), 6, "either diaginertia or fullinertia");
  expect_complaint(mass("mass='1' diaginertia='1 -1 1'"), 6, "inertia is not positive definite");
  expect_complaint(mass("mass='1' fullinertia='1 1 1 2 0 0'"), 6, "inertia is not positive definite");
  expect_complaint(message(closed_robot("<geom size='1' mass='-2'/>")), 5, "mass of geom is negative");
}

TEST(MjcfReader, NamesImpossibleGeoms) {
  expect_complaint(message(closed_robot("<geom type='box' size='1 2'/>")), 5, "size of a box needs 3 numbers");
  expect_complaint(message(closed_robot("<geom size='0'/>")), 5, "must be positive");
  expect_complaint(message(closed_robot("<geom type='mesh' mesh='m'/>")), 5, "unknown mesh 'm'");
  expect_complaint(message(closed_robot("<geom type='capsule' size='1' fromto='0 0 0 0 0 0'/>")), 5,
                   "two different points");
  expect_complaint(message(closed_robot("<geom type='plane' size='1 1 1'/>")), 5, "a plane cannot be part of a robot");
}

TEST(MjcfReader, NamesDuplicates) {
  expect_complaint(message(closed_robot("<body name='c'/>\n<body name='c'/>")), 6,
                   "body 'c' appears twice, first in line 5");
  expect_complaint(message(closed_robot(limb("<joint name='j' axis='1 0 0'/>\n<joint name='j' axis='1 0 0'/>"))), 6,
                   "joint 'j' appears twice, first in line 5");
  expect_complaint(message(closed_robot("<site name='s'/><site name='s'/>")), 5, "site 's' appears twice");
  expect_complaint(message(closed_robot("", "<default>\n<default class='a'/><default class='a'/></default>")), 2,
                   "default class 'a' is already there");
  // a name that the reader itself makes
  expect_complaint(message(closed_robot("<body name='c' pos='1 0 0'>" + limb("<joint axis='1 0 0'/>") +
                                        "</body>"
                                        "<body name='c.offset'/>")),
                   3, "two objects are called 'c.offset'");
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
