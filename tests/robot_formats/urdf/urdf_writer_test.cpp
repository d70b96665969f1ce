/// urdf_writer_test - the written URDF is read as the same robot, by its text and by the reader.
#include "murosimf/robot_formats/urdf/urdf_writer.h"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/math/random.h"
#include "murosimf/robot_formats/urdf/urdf_place_writer.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"
#include "tests/fixtures.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using urdf_files::test_folder;
using urdf_files::write;

double difference(const Mat3d& a, const Mat3d& b) { return fixtures::difference(a, b); }

robot_formats::BodyDescription body_of(const std::string& name, int parent, double mass) {
  robot_formats::BodyDescription body;
  body.name = name;
  body.where = "robot:1";
  body.parent = parent;
  body.solid = {mass, {0.01, 0.02, 0.03}, {0.01, 0.012, 0.014, 0.001, -0.002, 0.0005}};
  return body;
}

robot_formats::JointDescription joint_of(const std::string& name, const Vec3d& axis) {
  robot_formats::JointDescription joint;
  joint.name = name;
  joint.axis = axis;
  return joint;
}

robot_formats::RobotDescription read_again(const UrdfText& urdf) {
  for (const auto& [name, text] : urdf.meshes) write(name, text);
  return read_urdf(write("written.urdf", urdf.text), {});
}

/// Place of each body in that of the base, all joints at zero.
std::map<std::string, Transformd> places(const robot_formats::RobotDescription& robot) {
  std::vector<Transformd> all;
  std::map<std::string, Transformd> by_name;
  for (const robot_formats::BodyDescription& body : robot.bodies) {
    all.push_back(body.parent < 0 ? Transformd{} : all[body.parent] * body.place);
    by_name[body.name] = all.back();
  }
  return by_name;
}

// With a base that is the world, or has mass and whatever name.
TEST(UrdfWriter, WhatIsBoltedIsReadAsBolted) {
  for (const char* name : {"world", "table"}) {
    for (const double mass : {0.0, 2.0}) {
      robot_formats::RobotDescription robot;
      robot.fixed_base = true;
      robot.bodies = {body_of(name, -1, mass), body_of("arm", 0, 1)};
      robot.bodies[1].place.position = {0.1, 0.2, 0.3};
      robot.bodies[1].joints = {joint_of("shoulder", {0, 1, 0})};
      const auto again = read_again(to_urdf(robot));
      EXPECT_TRUE(again.fixed_base) << name;
      double total = 0;
      for (const robot_formats::BodyDescription& body : again.bodies) total += body.solid.mass;
      EXPECT_NEAR(total, mass + 1, 1e-12) << name;
      EXPECT_LT(norm(places(again).at("arm").position - Vec3d{0.1, 0.2, 0.3}), 1e-12);
    }
  }
}

// The joint stands at 0.4 in the pose of the file and at zero in URDF: by hand, the arm is turned by -0.4 about the anchor.
TEST(UrdfWriter, AJointAwayFromTheOriginKeepsItsPlace) {
  robot_formats::RobotDescription robot;
  robot.name = "r";
  robot.bodies = {body_of("base", -1, 1), body_of("arm", 0, 0.5)};
  robot.bodies[1].place = {{0.1, 0.2, 0.3}, {}};
  robot_formats::JointDescription joint = joint_of("j", {0, 0, 2});
  joint.anchor = {0.05, 0, 0};
  joint.reference = 0.4;
  joint.range = Vec3d{-1, 2, 0};
  robot.bodies[1].joints = {joint};
  const auto again = read_again(to_urdf(robot));
  ASSERT_EQ(again.bodies.size(), 2u);
  const robot_formats::BodyDescription& arm = again.bodies[1];
  EXPECT_LT(fixtures::difference(arm.place.position, Vec3d{0.15, 0.2, 0.3}), 1e-15);
  EXPECT_LT(difference(arm.place.orientation, rotation(Vec3d{0, 0, 1}, -0.4)), 1e-15);
  EXPECT_LT(fixtures::difference(arm.solid.center, Vec3d{0.01 - 0.05, 0.02, 0.03}), 1e-15);
  EXPECT_EQ(arm.solid.mass, 0.5);
  EXPECT_EQ(arm.solid.inertia.xz, robot.bodies[1].solid.inertia.xz);
  EXPECT_EQ(arm.joints[0].range->x, -1);
  EXPECT_EQ(arm.joints[0].range->y, 2);
}

TEST(UrdfWriter, ABodyOfTwoJointsGetsALinkBetweenThem) {
  robot_formats::RobotDescription robot;
  robot.bodies = {body_of("base", -1, 1), body_of("hip", 0, 0.5)};
  robot_formats::JointDescription first = joint_of("roll", {1, 0, 0}), second = joint_of("pitch", {0, 1, 0});
  first.anchor = {0, 0, 0.1};
  second.anchor = {0, 0.2, 0};
  robot.bodies[1].joints = {first, second};
  const auto again = read_again(to_urdf(robot));
  ASSERT_EQ(again.bodies.size(), 3u);
  EXPECT_EQ(again.bodies[1].solid.mass, 0);
  EXPECT_EQ(again.bodies[2].name, "hip");
  EXPECT_LT(fixtures::difference(places(again).at("hip").position, Vec3d{0, 0.2, 0}), 1e-15);
}

TEST(UrdfWriter, ShapesFramesAndSurfacesComeBack) {
  robot_formats::RobotDescription robot;
  robot.bodies = {body_of("base", -1, 1)};
  const auto add = [&](const Shape& shape, const Vec3d& at) {
    robot_formats::ShapeDescription s;
    s.placed.shape = shape;
    s.placed.position = at;
    s.placed.orientation = rotation(Vec3d{0, 1, 0}, 0.3);
    s.placed.surface.friction = 0.6;
    s.placed.color = {0.1, 0.2, 0.3, 0.4};
    robot.bodies[0].shapes.push_back(s);
  };
  add(Box{{0.1, 0.2, 0.3}}, {1, 0, 0});
  add(Sphere{0.1}, {2, 0, 0});
  add(Cylinder{0.1, 0.2}, {3, 0, 0});
  add(Capsule{0.1, 0.2}, {4, 0, 0});
  robot.bodies[0].frames.push_back({"eye", "robot:2", "site", {{0, 0, 1}, {}}, {}});
  const auto again = read_again(to_urdf(robot));
  const auto& shapes = again.bodies[0].shapes;
  ASSERT_EQ(shapes.size(), 12u) << "each to be seen, too; a capsule is a cylinder and two spheres";
  EXPECT_EQ(std::get<Box>(shapes[0].placed.shape).half_size.y, 0.2);
  EXPECT_EQ(std::get<Cylinder>(shapes[3].placed.shape).half_length, 0.2);
  const Vec3d end = Vec3d{4, 0, 0} + rotation(Vec3d{0, 1, 0}, 0.3) * Vec3d{0, 0, 0.2};
  EXPECT_EQ(std::get<Sphere>(shapes[4].placed.shape).radius, 0.1);
  EXPECT_LT(fixtures::difference(shapes[4].placed.position, end), 1e-15);
  EXPECT_EQ(std::get<Cylinder>(shapes[2].placed.shape).radius, 0.1);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_TRUE(shapes[i].placed.collides);
    EXPECT_FALSE(shapes[6 + i].placed.collides);
    EXPECT_EQ(shapes[i].placed.surface.friction, 0.6);
    EXPECT_EQ(shapes[6 + i].placed.color, (Color{0.1, 0.2, 0.3, 0.4}));
    EXPECT_LT(difference(shapes[i].placed.orientation, rotation(Vec3d{0, 1, 0}, 0.3)), 1e-15);
  }
  EXPECT_EQ(places(again).at("eye").position.z, 1);
}

// An ellipsoid has no element of its own: as a mesh of 32 by 16 faces its hull lacks 2 % of the volume.
TEST(UrdfWriter, WhatUrdfHasNoShapeForIsAMesh) {
  robot_formats::RobotDescription robot;
  robot.bodies = {body_of("base", -1, 1)};
  robot_formats::ShapeDescription ellipsoid;
  ellipsoid.name = "egg";
  ellipsoid.placed.shape = Ellipsoid{{0.1, 0.2, 0.3}};
  robot.bodies[0].shapes = {ellipsoid};
  const UrdfText urdf = to_urdf(robot, {test_folder(), "parts"});
  ASSERT_TRUE(urdf.meshes.contains("parts/egg.obj"));
  const auto again = read_again(urdf);
  const auto& hull = *std::get<Convex>(again.bodies[0].shapes[0].placed.shape).hull;
  EXPECT_NEAR(geometry::solid_mass(hull).volume / (4.0 / 3 * pi * 0.1 * 0.2 * 0.3), 0.98, 0.01);
}

TEST(UrdfWriter, SaysWhatUrdfCannot) {
  robot_formats::RobotDescription robot;
  robot.bodies = {body_of("base", -1, 1), body_of("tray", 0, 1)};
  robot_formats::JointDescription joint = joint_of("slide", {1, 0, 0});
  joint.kind = Kind::prismatic;
  joint.armature = 0.1;
  joint.effort_range = Vec3d{-2, 5, 0};
  robot.bodies[1].joints = {joint};
  robot.exclusions = {{"base", "tray", "robot:3"}};
  robot.loops = {{"pin", "robot:4", "here", "there", false}};
  const UrdfText urdf = to_urdf(robot);
  const std::string all = fmt::format("{}", fmt::join(urdf.left_out, "\n"));
  EXPECT_TRUE(fixtures::says(all, {"'slide' slides without an end", "armature of 1 joints", "from -2 to 5",
                                   "1 pairs of bodies", "1 loops of bodies"}));
  EXPECT_EQ(read_again(urdf).bodies[1].joints[0].effort_limit, 5);
}

TEST(UrdfWriter, SensorsComeBackAtTheirPlaces) {
  robot_formats::RobotDescription robot;
  robot.bodies = {body_of("base", -1, 1)};
  robot_formats::SensorDescription imu{"imu", "imu_1", "base", "robot:4", {{0.1, 0, 0}, rotation(Vec3d{0, 0, 1}, 0.5)},
                                       200};
  robot_formats::SensorDescription camera{"camera", "eye", "base", "robot:5", {{0, 0, 0.2}, {}}, 25};
  camera.numbers = {{"width", 640}, {"height", 480}, {"fx", 500}, {"fy", 501}, {"cx", 319.5}, {"cy", 239.5}};
  robot.sensors = {imu, camera};
  const auto again = read_again(to_urdf(robot));
  ASSERT_EQ(again.sensors.size(), 2u);
  EXPECT_EQ(again.sensors[0].name, "imu_1");
  EXPECT_EQ(again.sensors[0].rate, 200);
  EXPECT_LT(difference(again.sensors[0].place.orientation, imu.place.orientation), 1e-15);
  EXPECT_EQ(again.sensors[1].numbers, camera.numbers);
  EXPECT_EQ(again.sensors[1].place.position.z, 0.2);
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
