/// mesh_up_axis_test - COLLADA meshes with y up are turned if only then left and right are mirror images.
#include "murosimf/robot/mesh_up_axis.h"

#include <fmt/format.h>

#include "murosimf/robot/robot_reader.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

/// A tetrahedron about a point, as a COLLADA file; the middle of its box and its center are that point.
std::string dae(const Vec3d& c, const std::string& up) {
  std::string points;
  for (const Vec3d& v : {Vec3d{0.05, 0, 0.03}, Vec3d{-0.05, 0, 0.03}, Vec3d{0, 0.05, -0.03}, Vec3d{0, -0.05, -0.03}}) {
    points += fmt::format("{} {} {} ", c.x + v.x, c.y + v.y, c.z + v.z);
  }
  return "<COLLADA version='1.4.1'><asset>" + up +
         "</asset><library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='12'>" + points +
         "</float_array><technique_common><accessor source='#a' count='4' stride='3'/></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='4'><input "
         "semantic='VERTEX' "
         "source='#v' offset='0'/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id='s'><node><instance_geometry url='#g'/></node></visual_scene>"
         "</library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

/// Two feet with the same mesh, each in its joint.
robot_formats::RobotDescription with_feet(const Vec3d& middle, const std::string& up = "<up_axis>Y_UP</up_axis>",
                                          const std::string& scale = "1 1 1") {
  write("foot.dae", dae(middle, up));
  const std::string mesh = "<geometry><mesh filename='foot.dae' scale='" + scale + "'/></geometry>";
  const std::string inside = solid() + "<collision>" + mesh + "</collision><visual>" + mesh + "</visual>";
  const auto file =
      write("robot.urdf",
            robot_xml(link("l_foot", inside) + link("r_foot", inside) +
                      joint("revolute", "base", "l_foot", any_limit + "<origin xyz='0 0.1 -0.5'/>", "l") +
                      joint("revolute", "base", "r_foot", any_limit + "<origin xyz='0 -0.1 -0.5'/>", "r")));
  return read_robot(file, {.guess = false}).description;
}

Vec3d middle_of(const robot_formats::RobotDescription& robot) {
  return robot.bodies.at(1).shapes.at(0).placed.position;
}

// as written both feet are 5 cm to the left of their joints; turned they are 5 cm above
TEST(MeshUpAxis, CountsWhereLeftAndRightAreMirrorImagesOnlyThen) {
  const auto robot = with_feet({0.02, 0.05, 0});
  expect_near(middle_of(robot), {0.02, 0, 0.05}, 1e-6);
  expect_near(robot.bodies.at(1).shapes.at(0).placed.orientation * Vec3d{0, 1, 0}, {0, 0, 1});
  expect_near(robot.bodies.at(2).visuals.at(0).place.orientation * Vec3d{0, 1, 0}, {0, 0, 1});
  EXPECT_TRUE(any_contains(robot.notes, "1 COLLADA meshes with y up are turned"));
}

// four arms as the feet, and a pair of hands that is never symmetric, as a file may have one
TEST(MeshUpAxis, CountsAlsoWhereAFewPartsAreNoMirrorImages) {
  write("foot.dae", dae({0.02, 0.05, 0}, "<up_axis>Y_UP</up_axis>"));
  write("hand.dae", dae({0, 0, 0}, "<up_axis>Y_UP</up_axis>"));
  std::string parts;
  const auto add = [&](const std::string& name, const std::string& mesh, double y) {
    parts += link(name, solid() + "<collision><geometry><mesh filename='" + mesh + "'/></geometry></collision>") +
             joint("revolute", "base", name, any_limit + fmt::format("<origin xyz='0 {} 0'/>", y), "j_" + name);
  };
  for (const char* part : {"foot", "knee", "hip", "arm"}) {
    add(std::string("l_") + part, "foot.dae", 0.1);
    add(std::string("r_") + part, "foot.dae", -0.1);
  }
  add("l_hand", "hand.dae", 0.2);
  add("r_hand", "hand.dae", -0.15);
  const auto robot = read_robot(write("robot.urdf", robot_xml(parts)), {.guess = false}).description;
  expect_near(middle_of(robot), {0.02, 0, 0.05}, 1e-6);
}

TEST(MeshUpAxis, OfFilesThatSayNothingIsY) {
  expect_near(middle_of(with_feet({0.02, 0.05, 0}, "")), {0.02, 0, 0.05}, 1e-6);
}

TEST(MeshUpAxis, DoesNotCountWhereNumbersAreMirrorImagesAsTheyAre) {
  const auto robot = with_feet({0.02, 0, 0.05});
  expect_near(middle_of(robot), {0.02, 0, 0.05}, 1e-6);
  expect_near(robot.bodies.at(2).visuals.at(0).place.orientation * Vec3d{0, 1, 0}, {0, 1, 0});
  EXPECT_FALSE(any_contains(robot.notes, "COLLADA"));
}

TEST(MeshUpAxis, DoesNotCountWhereTurningMakesNoMirrorImages) {
  expect_near(middle_of(with_feet({0.02, 0.05, 0.04})), {0.02, 0.05, 0.04}, 1e-6);
}

TEST(MeshUpAxis, OfZIsLeftAlone) {
  expect_near(middle_of(with_feet({0.02, 0.05, 0}, "<up_axis>Z_UP</up_axis>")), {0.02, 0.05, 0}, 1e-6);
}

TEST(MeshUpAxis, IsLeftAloneWhereScalesDifferByDirection) {
  expect_near(middle_of(with_feet({0.02, 0.05, 0}, "<up_axis>Y_UP</up_axis>", "1 1 2")), {0.02, 0.05, 0}, 1e-6);
}

}  // namespace
}  // namespace murosimf::robot
