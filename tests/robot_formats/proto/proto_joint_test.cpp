/// proto_joint_test - joints, motors, sensors and the tree.
#include <cmath>

#include "tests/robot_formats/proto/proto_files.h"

namespace murosimf::robot_formats::proto {
namespace {

using namespace proto_files;

/// A HingeJoint at line 5 with its limb.
std::string hinge(const std::string& parameters, const std::string& devices = "", const std::string& end = limb()) {
  return "HingeJoint { jointParameters HingeJointParameters { " + parameters + " } device [ " + devices +
         " ] endPoint " + end + " }";
}

const robot_formats::JointDescription& joint_of(const robot_formats::RobotDescription& description) {
  return description.bodies.at(1).joints.at(0);
}

TEST(ProtoJoints, HaveAxisAndAnchorInTheirBody) {
  // the limb is turned by 90 degrees about z: its x axis is the parent's y axis
  const auto description = read(robot(
      "Pose { translation 5 0 0 children [ " +
      hinge("axis 0 3 0 anchor 0 0 1", "", limb("translation 0 2 1 rotation 0 0 1 1.5707963267948966")) + " ] }"));
  const auto& body = description.bodies.at(1);
  EXPECT_EQ(body.parent, 0);
  expect_near(body.place.position, {5, 2, 1});
  expect_near(joint_of(description).axis, {1, 0, 0});
  expect_near(joint_of(description).anchor, {-2, 0, 0});
  EXPECT_EQ(joint_of(description).name, "limb_joint");
  EXPECT_EQ(joint_of(description).kind, Kind::revolute);
}

TEST(ProtoJoints, HaveTheNumbersOfParametersAndMotors) {
  const auto description = read(robot(hinge(
      "minStop -1 maxStop 2 position 0.5 dampingConstant 0.1 staticFriction 0.2 springConstant 3",
      "RotationalMotor { name \"knee\" maxTorque 4 maxVelocity 5 minPosition -0.5 maxPosition 0.7 controlPID 10 0 0 } "
      "PositionSensor { name \"knee sensor\" } Brake { }")));
  const auto& joint = joint_of(description);
  EXPECT_EQ(joint.name, "knee");
  expect_near(joint.axis, {1, 0, 0});
  expect_near(joint.range.value(), {-1, 2, 0});
  expect_near(joint.target_range.value(), {-0.5, 0.7, 0});
  EXPECT_EQ(joint.reference, 0.5);
  EXPECT_EQ(joint.damping, 0.1);
  EXPECT_EQ(joint.friction, 0.2);
  EXPECT_EQ(joint.stiffness, 3);
  EXPECT_EQ(joint.spring_reference, 0);
  EXPECT_EQ(joint.effort_limit, 4);
  EXPECT_EQ(joint.rate_limit, 5);
  ASSERT_EQ(description.sensors.size(), 1u);
  EXPECT_EQ(description.sensors[0].kind, "jointpos");
  EXPECT_EQ(description.sensors[0].frame, "knee");
  EXPECT_TRUE(names_unused(description, "robot.proto:5: controlPID of motors is not used"));
  EXPECT_TRUE(names_unused(description, "brakes are not simulated"));
}

TEST(ProtoJoints, HaveTheRangeOfTheirMotorsWithoutStops) {
  const auto bounded = read(robot(hinge("", "RotationalMotor { minPosition -0.5 maxPosition 0.7 }")));
  expect_near(joint_of(bounded).range.value(), {-0.5, 0.7, 0});
  EXPECT_EQ(joint_of(bounded).effort_limit, 10);
  EXPECT_EQ(joint_of(bounded).rate_limit, 10);
  EXPECT_FALSE(joint_of(read(robot(hinge("", "RotationalMotor { }")))).range);
  EXPECT_EQ(joint_of(read(robot(hinge("")))).effort_limit, 0);
  EXPECT_EQ(joint_of(read(robot("DEF elbow " + hinge("")))).name, "elbow");
}

TEST(ProtoJoints, Slide) {
  const auto description =
      read(robot("SliderJoint { jointParameters JointParameters { axis 0 1 0 maxStop 0.1 } device "
                 "LinearMotor { maxForce 20 } endPoint " +
                 limb() + " }"));
  EXPECT_EQ(joint_of(description).kind, Kind::prismatic);
  expect_near(joint_of(description).axis, {0, 1, 0});
  expect_near(joint_of(description).range.value(), {0, 0.1, 0});
  EXPECT_EQ(joint_of(description).effort_limit, 20);
}

/// The place of the body of a Hinge2Joint by its definition against that by the joints that are read, which turn in their order about
/// axes of the body in the pose of the file.
TEST(ProtoJoints, OfTwoHingesTurnAsTheyAreDefined) {
  const double p1 = 0.4, p2 = -0.7, q1 = 1.1, q2 = 0.3;
  const Vec3d a1{0, 1, 0}, a2{0.6, 0, 0.8};
  // [rad] the limb's turn in the pose of the file, about (1 0 0) alone where both positions are 0
  const Mat3d zero = rotation_x(0.2), now = rotation(a1, p1) * rotation(a2, p2) * zero;
  const double angle = std::acos((now.x.x + now.y.y + now.z.z - 1) / 2);
  const Vec3d axis = (0.5 / std::sin(angle)) * Vec3d{now.y.z - now.z.y, now.z.x - now.x.z, now.x.y - now.y.x};
  const auto text = [](const Vec3d& v) {
    return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
  };
  const auto description =
      read(robot("Hinge2Joint { jointParameters HingeJointParameters { axis 0 1 0 position 0.4 } jointParameters2 "
                 "JointParameters { axis 0.6 0 0.8 position -0.7 } device RotationalMotor { name \"roll\" } device2 "
                 "RotationalMotor { name \"pitch\" } endPoint " +
                 limb("rotation " + text(axis) + " " + std::to_string(angle)) + " }"));
  const auto& joints = description.bodies.at(1).joints;
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].name, "roll");
  EXPECT_EQ(joints[1].name, "pitch");
  const Mat3d turned = description.bodies[1].place.orientation * rotation(joints[0].axis, q1 - joints[0].reference) *
                       rotation(joints[1].axis, q2 - joints[1].reference);
  const Mat3d expected = rotation(a1, q1) * rotation(a2, q2) * zero;
  expect_near(turned.x, expected.x, 1e-5);  // six digits
  expect_near(turned.y, expected.y, 1e-5);
}

TEST(ProtoJoints, AreRefusedWhereTheyMeanSomethingElse) {
  struct Case {
    std::string children, message;
  };
  const std::vector<Case> cases{
      {"BallJoint { endPoint " + limb() + " }", "robot.proto:5: BallJoint is not supported"},
      {hinge("minStop 2 maxStop 1"), "robot.proto:5: minStop 2 of HingeJointParameters is not below maxStop 1"},
      {hinge("axis 0 0 0"), "robot.proto:5: axis has no direction"},
      {hinge("dampingConstant -1"), "robot.proto:5: dampingConstant of HingeJointParameters is -1"},
      {hinge("", "LinearMotor { }"), "robot.proto:5: LinearMotor at a joint of the other kind"},
      {hinge("", "", "SolidReference { solidName \"a\" }"),
       "robot.proto:5: HingeJoint to a SolidReference, which closes a loop"},
      {"Leg { }", "robot.proto:5: there is no node Leg, and no file Leg.proto beside (--lenient reads on)"},
      {"Track { }", "robot.proto:5: Track is not supported (--lenient reads on)"},
      {"Transform { scale 2 2 2 children [ " + limb() + " ] }", "robot.proto:5: Solid in a Transform with a scale"},
  };
  for (const auto& [children, expected] : cases) {
    EXPECT_TRUE(contains(message(robot(children)), expected)) << message(robot(children));
  }
  EXPECT_TRUE(any_contains(read(robot("Leg { }"), {.lenient = true}).warnings, "robot.proto:5: there is no node Leg"));
}

TEST(ProtoJoints, OfTheSameNameAreToldApart) {
  const auto description =
      read(robot(hinge("", "RotationalMotor { name \"m\" }") + "\n" + hinge("", "RotationalMotor { name \"m\" }")));
  EXPECT_EQ(description.bodies.at(2).joints.at(0).name, "m_2");
  EXPECT_TRUE(any_contains(description.warnings, "robot.proto:6: a second joint 'm' is called 'm_2' here"));
  EXPECT_EQ(description.bodies[2].name, "limb_2");
}

TEST(ProtoSensors, AreThoseThatAreSimulated) {
  const auto description = read(
      robot("Gyro { name \"g\" }\nAccelerometer { lookupTable [ -1 0 0 1 1 0 ] }\nInertialUnit { }\nTouchSensor { name "
            "\"sole\" boundingObject Box { } }\nDistanceSensor { }\nLED { }\nEmitter { }\n"
            "Camera { name \"eye\" translation 1 0 0 width 640 height 480 fieldOfView 1.2 }"));
  std::string kinds;
  for (const auto& sensor : description.sensors) kinds += sensor.kind + " ";
  EXPECT_EQ(kinds, "gyro accelerometer framequat touch rangefinder camera ");
  const auto& camera = description.sensors.back();
  EXPECT_EQ(camera.frame, "eye");
  EXPECT_EQ(camera.numbers, (std::map<std::string, double>{{"width", 640}, {"height", 480}, {"fov", 1.2}}));
  expect_near(camera.place.orientation.x, {1, 0, 0});
  expect_near(description.bodies.back().place.position, {1, 0, 0});
  // the ray goes along x
  expect_near(description.sensors[4].place.orientation.z, {1, 0, 0});
  EXPECT_TRUE(names_unused(description, "robot.proto:10: LED is not simulated"));
  EXPECT_TRUE(names_unused(description, "robot.proto:6: lookup tables are not used"));
  const auto old = read(robot("Camera { }", "R2021b"));
  expect_near(old.sensors.at(0).place.orientation.x, {0, 0, -1});  // it looks there
  expect_near(old.sensors[0].place.orientation.z, {0, 1, 0});
  EXPECT_TRUE(
      contains(message(robot("Camera { width 1.5 }")), "robot.proto:5: width of Camera is 1.5; write whole pixels"));
}

TEST(ProtoTree, FixesSolidsWithoutJoints) {
  const auto description =
      read(robot("Solid { name \"cap\" translation 0 0 1 physics Physics { mass 2 } children [ " + limb() + " ] }"));
  ASSERT_EQ(description.bodies.size(), 3u);
  EXPECT_TRUE(description.bodies[1].joints.empty());
  EXPECT_EQ(description.bodies[1].solid.mass, 2);
  EXPECT_EQ(description.bodies[2].parent, 1);
  EXPECT_FALSE(description.fixed_base);
  EXPECT_TRUE(any_contains(description.notes, "robot.proto:5: Solids with mass and without inertiaMatrix"));
}

}  // namespace
}  // namespace murosimf::robot_formats::proto
