/// robot_conversion_test - robots that are read, written and read again are equal.
#include "murosimf/robot/robot_conversion.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/mjcf/mjcf_writer.h"
#include "tests/robot/same_model.h"
#include "tests/robot_data.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

namespace fs = std::filesystem;
using robot_formats::urdf::urdf_files::test_folder;
using robot_formats::urdf::urdf_files::write;
using same_model::expect_same;

fs::path own_model(const std::string& name) { return fs::path(MUROSIMF_SOURCE_DIR) / "models" / (name + ".xml"); }

/// Converts, writes both files and reads them.
RobotFile converted(const fs::path& file, std::optional<geometry::PrimitiveKind> fit = {}, bool with_table = true) {
  const fs::path out = test_folder() / "out" / "converted.xml";
  fs::create_directories(out.parent_path());
  const RobotConversion robot = convert_robot(file, {.folder = out.parent_path(), .fit = fit});
  write("out/converted.xml", robot.text);
  fs::remove(fs::path(out).replace_extension(".toml"));
  if (with_table) write("out/converted.toml", robot.toml);
  return read_robot(out);
}

/// With the largest rates of the joints alone, which MJCF does not have: servos of the table would replace the joints' friction.
RobotFile converted_with_rates(const fs::path& file) {
  (void)converted(file);
  const fs::path out = test_folder() / "out" / "converted.xml", table = fs::path(out).replace_extension(".toml");
  std::stringstream text;
  text << std::ifstream(table).rdbuf();
  const std::size_t rates = text.str().find("[rate_limits]");
  write("out/converted.toml", rates == std::string::npos ? "" : text.str().substr(rates));
  return read_robot(out);
}

class OwnModel : public testing::TestWithParam<const char*> {};

TEST_P(OwnModel, ComesBackAsItWas) {
  const auto file = own_model(GetParam());
  expect_same(*converted(file).model, *read_robot(file).model);
}
TEST_P(OwnModel, ComesBackAsItWasWithoutItsTable) {
  const auto file = write("alone.xml", [&] {
    std::stringstream text;
    text << std::ifstream(own_model(GetParam())).rdbuf();
    return text.str();
  }());
  expect_same(*converted(file, {}, false).model, *read_robot(file).model);
}

// Contact parameters of MuJoCo have no effect here, so they are not written: one line names them.
TEST(Conversion, NamesWhatHasNoEffectHere) {
  const fs::path file = write("soft.xml",
                              "<mujoco><default><geom solref='0.01 1'/></default><worldbody><body><freejoint/>"
                              "<geom size='0.1' solimp='0.9 0.95 0.001'/></body></worldbody></mujoco>");
  const RobotConversion robot = convert_robot(file, {.folder = test_folder() / "out"});
  ASSERT_EQ(robot.left_out.size(), 1u);
  EXPECT_TRUE(fixtures::says(robot.left_out[0], {"soft.xml", "without effect here", "geom.solref", "geom.solimp"}));
}

// A program that reads the MJCF file alone has the gains that the robot is simulated with.
TEST(Conversion, WritesTheGainsOfTheTable) {
  const std::string body =
      "<mujoco><worldbody><body><freejoint/><geom size='0.1'/><body pos='0 0 1'><joint name='knee'/><geom size='0.1'/>"
      "</body></body></worldbody><actuator><position joint='knee' kp='39' forcerange='-6 6'/></actuator></mujoco>";
  const fs::path file = write("gains.xml", body);
  write("gains.toml",
        "[servos.mx]\nstall_torque = 5\nposition_gain = 30\nno_load_speed = 6\nrotor_inertia = 0.01\ncoulomb_friction "
        "= 0.1\njoints = ['knee']\n");
  const RobotFile alone = converted(file, {}, false);
  const Servo& servo = *alone.model->find(properties::servo, alone.model->object_index("knee"));
  EXPECT_EQ(servo.position_gain, 30);
  EXPECT_EQ(servo.stall_torque, 6) << "the limit is that of the file";
  fs::remove(fs::path(file).replace_extension(".toml"));
}

INSTANTIATE_TEST_SUITE_P(Mjcf, OwnModel,
                         testing::Values("kid21", "quadruped", "car", "spark_nao0", "spark_nao4", "booster_k1"),
                         [](const auto& model) { return std::string(model.param); });

using TeamFile = std::pair<std::string, fs::path (*)()>;
class TeamRobot : public testing::TestWithParam<TeamFile> {};

TEST_P(TeamRobot, ComesBackAsItWas) {
  const fs::path file = GetParam().second();
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  expect_same(*converted_with_rates(file).model, *read_robot(file).model);
}

INSTANTIATE_TEST_SUITE_P(Files, TeamRobot,
                         testing::Values(TeamFile("k1_urdf", k1_urdf), TeamFile("k1_mjcf", k1_mjcf),
                                         TeamFile("wolfgang_urdf", wolfgang_urdf)),
                         [](const auto& robot) { return robot.param.first; });

std::string all_of_urdf() {
  return "<robot name='a &amp; b'>\n"
         "<link name='base'><inertial><origin xyz='0.01 0 0.02' rpy='0.1 0.2 0.3'/><mass value='1'/>"
         "<inertia ixx='0.01' iyy='0.02' izz='0.025' ixy='0.001'/></inertial>"
         "<collision name='hull'><origin xyz='0 0 0.1' rpy='0.5 0 0'/><geometry><mesh filename='tetra.obj' "
         "scale='0.1 0.2 -0.1'/></geometry></collision>"
         "<visual><origin xyz='0 0 0.1'/><geometry><mesh filename='tetra.obj'/></geometry></visual></link>\n"
         "<link name='fixed'><inertial><mass value='0.2'/><inertia ixx='0' iyy='0' izz='0'/>"
         "</inertial>"
         "<collision name='hull'><geometry><sphere radius='0.03'/></geometry></collision></link>\n"
         "<link name='imu'/>\n"
         "<link name='arm'><inertial><mass value='0.5'/><inertia ixx='0.001' iyy='0.001' izz='0.001'/></inertial>"
         "<collision><origin rpy='1 2 3'/><geometry><capsule radius='0.02' "
         "length='0.2'/></geometry></collision></link>\n"
         "<link name='slider'><inertial><mass value='0.5'/><inertia ixx='0.001' iyy='0.001' izz='0.001'/></inertial>"
         "</link>\n"
         "<joint name='f' type='fixed'><parent link='base'/><child link='fixed'/><origin xyz='0.1 0 0' rpy='0 0 1'/>"
         "</joint>\n"
         "<joint name='g' type='fixed'><parent link='fixed'/><child link='imu'/><origin xyz='0 0.1 0' rpy='0 1 0'/>"
         "</joint>\n"
         "<joint name='j' type='revolute'><parent link='fixed'/><child link='arm'/><origin xyz='0 0.1 0' "
         "rpy='0.3 0.2 0.1'/><axis xyz='1 1 0'/><limit lower='-1' upper='2' effort='6' velocity='5'/>"
         "<dynamics damping='0.1' friction='0.2'/></joint>\n"
         "<joint name='s' type='prismatic'><parent link='arm'/><child link='slider'/><axis xyz='0 0 1'/>"
         "<limit lower='-0.1' upper='0.1' effort='3' velocity='1'/><mimic joint='j' multiplier='0.05' offset='0.01'/>"
         "</joint>\n"
         "</robot>\n";
}

fs::path write_all_of_urdf() {
  write("tetra.obj", robot_formats::urdf::urdf_files::tetrahedron());
  return write("robot.urdf", all_of_urdf());
}

TEST(RobotConversion, AUrdfRobotComesBackAsItWas) {
  const auto file = write_all_of_urdf();
  const RobotFile before = read_robot(file), after = converted_with_rates(file);
  expect_same(*after.model, *before.model);
  EXPECT_EQ(after.model->name(), "a & b");
  ASSERT_EQ(after.description.bodies[0].visuals.size(), 1u);
  EXPECT_EQ(after.description.bodies[1].joints[0].effort_limit, 6);
  EXPECT_EQ(after.description.bodies[0].name, "base");
}

TEST(RobotConversion, LumpedDescriptionsAreWrittenToo) {
  const RobotFile before = read_robot(write_all_of_urdf());
  std::string rates = "[rate_limits]\n";  // MJCF has no word for them
  for (const robot_formats::BodyDescription& body : before.description.bodies) {
    for (const auto& joint : body.joints) rates += fmt::format("\"{}\" = {}\n", joint.name, joint.rate_limit);
  }
  write("welded.toml", rates);
  const RobotFile after =
      read_robot(write("welded.xml", robot_formats::mjcf::to_mjcf(before.description, {test_folder()})));
  expect_same(*after.model, *before.model);
}

std::string all_of_mjcf() {
  return R"(<mujoco model="m"><compiler angle="degree" eulerseq="zyx"/>
<default><joint damping="0.5" armature="0.01"/><default class="d"><geom friction="0.3" rgba="0.1 0.2 0.3 1"/></default></default>
<asset><mesh name="inline" vertex="0 0 0  0.1 0 0  0 0.1 0  0 0 0.1" scale="1 2 1" refpos="0.01 0.02 0.03"
  refquat="1 1 0 0"/><mesh name="parts" file="parts.obj" scale="0.1 0.1 0.1" refpos="0.1 0 0"/></asset>
<worldbody><geom name="floor" type="plane" size="1 1 1"/><body name="base" pos="0 0 1"><freejoint name="root"/>
<geom class="d" name="g1" type="box" size="0.1 0.1 0.1" euler="10 20 30" contype="5" conaffinity="-1"/>
<geom type="mesh" mesh="inline" pos="0.1 0 0" euler="1 2 3"/><site name="left_sole" type="box" size="0.1 0.05 0.01"
  pos="0 0 -0.1"/><site name="quot&quot;&lt;" euler="90 0 0"/><camera name="eye" pos="0.1 0 0" euler="0 10 0"/>
<body name="two" pos="0.1 0 0" euler="0 0 45"><joint name="a" axis="0 0 2" pos="0 0.1 0" range="-90 90" ref="10"
  stiffness="3" springref="5" frictionloss="0.1" actuatorfrcrange="-4 4"/><joint name="b" axis="0 1 0"/>
<geom name="g2" type="cylinder" size="0.05" fromto="0 0 0 0.1 0.1 0.1" contype="0" conaffinity="0"/>
<geom name="m2" type="mesh" mesh="parts" pos="0 0.3 0" euler="0 0 30"/>
<body name="three" pos="0 0 0.2"><joint name="c" axis="1 0 0" type="slide" limited="false"/>
<geom name="g3" type="ellipsoid" size="0.1 0.05 0.02"/><body name="tip" pos="0 0 0.1"><geom name="g4" size="0.02"/>
</body></body></body></body></worldbody>
<actuator><position joint="a" kp="20" kv="1" forcerange="-9 9" gear="2"/><velocity joint="b" kv="0.5"/>
<motor joint="c" ctrlrange="-7 7"/></actuator>
<equality><joint joint1="c" joint2="b" polycoef="0.01 0.1 0 0 0"/><connect body1="base" body2="tip" anchor="0 0.1 0"/>
<weld name="held" body1="two" body2="tip" relpose="0.01 0 0.3 1 0 0.1 0" anchor="0 0.01 0"/></equality>
<contact><exclude body1="base" body2="tip"/><pair geom1="g2" geom2="g1"/><pair geom1="g4" geom2="floor"/></contact>
<sensor><gyro name="gyro" site="left_sole"/></sensor></mujoco>)";
}

/// Two tetrahedra side by side, as groups.
std::string two_parts() {
  return "g one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
         "g two\nv 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";
}

fs::path write_all_of_mjcf() {
  write("parts.obj", two_parts());
  write("robot.toml", "[meshes]\npart_per_group = [\"parts\"]\n");
  return write("robot.xml", all_of_mjcf());
}

using NamedPairs = std::vector<std::pair<std::string, std::string>>;

TEST(RobotConversion, AllThatMjcfCanSayComesBack) {
  const auto file = write_all_of_mjcf();
  const RobotFile before = read_robot(file), after = converted(file);
  expect_same(*after.model, *before.model);
  EXPECT_EQ(*after.model->find(properties::excluded_pairs, 0), *before.model->find(properties::excluded_pairs, 0));
  const auto& pairs = *after.model->find(properties::allowed_pairs, 0);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first.object, "two");
  EXPECT_EQ(after.model->find_object("root"), 0);
  EXPECT_TRUE(after.model->find(properties::sole, after.model->object_index("left_sole")));
  EXPECT_TRUE(after.model->find_object("eye"));
  EXPECT_EQ(after.description.bodies[1].shapes.size(), 3u) << "one cylinder and two parts of a mesh";
}

TEST(RobotConversion, TheTextIsTheSameTheSecondTime) {
  const std::string first = convert_robot(own_model("kid21")).text;
  const std::string second = convert_robot(write("again.xml", first)).text;
  EXPECT_EQ(second, first);
}

TEST(RobotConversion, FittedMeshesKeepVolumeMassAndNames) {
  const auto file = write_all_of_mjcf();
  const RobotFile before = read_robot(file), after = converted(file, geometry::PrimitiveKind::box);
  EXPECT_DOUBLE_EQ(after.model->tree().mass, before.model->tree().mass);
  const auto& was = before.description.bodies[1].shapes;
  const auto& is = after.description.bodies[1].shapes;
  ASSERT_EQ(is.size(), was.size());
  EXPECT_EQ(is[1].name, "m2");
  EXPECT_EQ(is[2].name, "m2.2");
  for (std::size_t i = 1; i < is.size(); ++i) {
    EXPECT_TRUE(std::holds_alternative<Box>(is[i].placed.shape));
    EXPECT_NEAR(robot_formats::volume(is[i].placed.shape) / robot_formats::volume(was[i].placed.shape), 1, 1e-9);
    const auto& hull = *std::get<Convex>(was[i].placed.shape).hull;
    const Vec3d center = was[i].placed.position + was[i].placed.orientation * geometry::solid_mass(hull).center;
    EXPECT_LT(fixtures::difference(is[i].placed.position, center), 1e-12);
  }
  ASSERT_EQ(after.description.bodies[1].visuals.size(), 1u) << "the mesh itself is still to be seen";
  const auto fits = convert_robot(file, {.fit = geometry::PrimitiveKind::best}).fits;
  ASSERT_EQ(fits.size(), 3u);
  for (const MeshFit& fit : fits) EXPECT_GT(fit.overlap, 0.3) << fit.mesh;
}

TEST(RobotConversion, UnknownKindsOfPrimitivesAreRefused) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)primitive_kind("capsul"); }), {"did you mean 'capsule'?"}));
}

TEST(ServoSections, ActuatorsOfTheFileAreComplete) {
  const auto file = write("robot.xml", all_of_mjcf());
  write("parts.obj", two_parts());
  const auto table = read_robot_config(write("stub.toml", convert_robot(file).toml));
  ASSERT_EQ(table.servos.size(), 2u) << "joint c follows b and has no servo of its own";
  const Servo& servo = table.servos.at("a").servo;
  EXPECT_EQ(servo.law, "ideal_pd");
  EXPECT_EQ(servo.stall_torque, 4);
  EXPECT_EQ(servo.position_gain, 80);
  EXPECT_EQ(servo.velocity_gain, 4);
  EXPECT_EQ(servo.rotor_inertia, 0.01);
  EXPECT_EQ(servo.friction.coulomb, 0.1);
  EXPECT_EQ(servo.friction.viscous, 0.5);
}

TEST(ServoSections, WhatTheFileLacksIsGuessed) {
  const auto servos = read_robot_config(write("stub.toml", convert_robot(write_all_of_urdf()).toml)).servos;
  ASSERT_EQ(servos.size(), 1u);
  const Servo& servo = servos.at("j").servo;
  EXPECT_EQ(servo.law, "ideal_pd");
  EXPECT_EQ(servo.stall_torque, 6);
  EXPECT_NEAR(servo.position_gain, 60, 1e-12);
  EXPECT_EQ(servo.friction.coulomb, 0.2);
}

/// Writes URDF and its meshes and reads them, with the table or without.
RobotFile as_urdf(const fs::path& file, bool with_table = true) {
  const fs::path out = test_folder() / "out" / "converted.urdf";
  const RobotConversion robot = convert_robot(file, {.folder = out.parent_path(), .format = WrittenFormat::urdf});
  for (const auto& [name, text] : robot.meshes) write("out/" + name, text);
  write("out/converted.urdf", robot.text);
  fs::remove(fs::path(out).replace_extension(".toml"));
  if (with_table) write("out/converted.toml", robot.toml);
  return read_robot(out);
}

class AsUrdf : public testing::TestWithParam<const char*> {};

// URDF and the table beside it together: masses, places, servos and soles; of joints all but what the servo's table has.
TEST_P(AsUrdf, WithItsTableItIsTheSameRobot) {
  const RobotFile before = read_robot(own_model(GetParam())), after = as_urdf(own_model(GetParam()));
  const Model &found = *after.model, &expected = *before.model;
  ASSERT_EQ(found.joints().size(), expected.joints().size());
  EXPECT_TRUE(same_model::is_near(found.tree().mass, expected.tree().mass));
  EXPECT_EQ(after.sensors.size(), before.sensors.size());
  const auto poses = same_model::bent(found), right = same_model::bent(expected);
  for (int k = 0; k < expected.size(); ++k) {
    const Object& object = expected.objects()[k];
    const auto i = found.find_object(object.name);
    if (object.kind == Kind::fork || object.structural) continue;
    ASSERT_TRUE(i) << object.name << " is lost";
    if (found.objects()[*i].kind != object.kind)
      continue;  // the frame of a body with its joint elsewhere is at the joint now
    EXPECT_LT(fixtures::difference(poses.r[*i], right.r[k]), 1e-12) << object.name;
    EXPECT_LT(fixtures::difference(poses.R[*i], right.R[k]), 1e-12) << object.name;
    same_model::expect_same_servo(found.find(properties::servo, *i), expected.find(properties::servo, k), object.name);
    const Sole *sole = found.find(properties::sole, *i), *was = expected.find(properties::sole, k);
    ASSERT_EQ(sole == nullptr, was == nullptr) << object.name;
    if (was) {
      EXPECT_NEAR(sole->half_length, was->half_length, 1e-12) << object.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Mjcf, AsUrdf,
                         testing::Values("kid21", "quadruped", "car", "spark_nao0", "spark_nao4", "booster_k1"),
                         [](const auto& model) { return std::string(model.param); });

std::string urdf_with(const std::string& limit, const std::string& gazebo = "") {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/></inertial>";
  const auto ball = [](const char* at) {
    return fmt::format("<collision><origin xyz='{}'/><geometry><sphere radius='0.1'/></geometry></collision>", at);
  };
  return "<robot name='r'><link name='base'>" + inertial + ball("0 0 0") + "</link><link name='arm'>" + inertial +
         "</link><link name='hand'>" + inertial + ball("0 0 0.05") +
         "</link><joint name='j' type='revolute'><parent link='base'/><child link='arm'/><axis xyz='0 1 0'/>" + limit +
         "</joint><joint name='k' type='revolute'><parent link='arm'/><child link='hand'/><axis xyz='0 1 0'/>" + limit +
         "</joint>" + gazebo + "</robot>";
}

// By hand: 6 N m at 0.1 rad are 60 N m/rad, 0.05 s of which are 3 N m s/rad; balls of 0.1 m overlap and are no neighbors.
TEST(RobotConversion, WhatIsGuessedDrivesInMujoco) {
  const auto file = write("bare.urdf", urdf_with("<limit lower='-1' upper='2' effort='6' velocity='5'/>"));
  const RobotFile after = converted(file, {}, false);
  const robot_formats::JointDescription& joint = after.description.bodies[1].joints[0];
  ASSERT_TRUE(joint.servo);
  EXPECT_NEAR(joint.servo->position_gain, 60, 1e-12);
  EXPECT_NEAR(joint.servo->velocity_gain, 3, 1e-12);
  EXPECT_EQ(joint.servo->stall_torque, 6);
  EXPECT_EQ(joint.target_range->x, -1);
  EXPECT_EQ(joint.target_range->y, 2);
  ASSERT_EQ(after.description.keyframes.size(), 1u);
  EXPECT_NEAR(after.description.keyframes[0].base.position.z, 0.1, 1e-15) << "on its lowest ball";
  ASSERT_EQ(after.description.exclusions.size(), 1u);
  EXPECT_EQ(after.description.exclusions[0].body1, "base");
  EXPECT_EQ(after.description.exclusions[0].body2, "hand");
}

// A DC motor's damping is the slope of its line: 5 N m over 10 rad/s.
TEST(RobotConversion, AMotorOfTheTableIsAnActuator) {
  const auto file = write("bare.urdf", urdf_with("<limit lower='-1' upper='2' effort='6' velocity='5'/>"));
  write("bare.toml",
        "[servos.motor]\nlaw = 'dc_motor'\nvoltage = 12\nstall_torque = 5\nno_load_speed = 10\nposition_gain "
        "= 30\nrotor_inertia = 0.02\ncoulomb_friction = 0.1\nviscous_friction = 0.3\njoints = ['j', 'k']\n");
  const RobotFile after = converted(file, {}, false);
  const robot_formats::JointDescription& joint = after.description.bodies[1].joints[0];
  ASSERT_TRUE(joint.servo);
  EXPECT_EQ(joint.servo->position_gain, 30);
  EXPECT_EQ(joint.servo->velocity_gain, 0.5);
  EXPECT_EQ(joint.servo->stall_torque, 5);
  EXPECT_EQ(joint.armature, 0.02);
  EXPECT_EQ(joint.damping, 0.3);
  EXPECT_EQ(joint.friction, 0.1);
}

TEST(RobotConversion, SensorsOfUrdfAreThereForOtherPrograms) {
  const auto file =
      write("bare.urdf", urdf_with("<limit lower='-1' upper='2' effort='6' velocity='5'/>",
                                   "<gazebo reference='base'><sensor name='imu' type='imu'><pose>0 0 0.1 0 0 "
                                   "0</pose></sensor></gazebo>"));
  const RobotConversion robot = convert_robot(file);
  for (const char* element :
       {"<gyro name=\"imu_gyro\" site=\"imu_site\"/>", "<accelerometer name=", "<framequat name="}) {
    EXPECT_NE(robot.text.find(element), std::string::npos) << element;
  }
  ASSERT_EQ(converted(file).sensors.size(), 1u) << "the table has it as one";
}

}  // namespace
}  // namespace murosimf::robot
