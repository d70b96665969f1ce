/// repair_solids_test - limbs that could not be simulated are repaired, with a line that gives the new numbers.
#include "murosimf/robot/repair_solids.h"

#include <cmath>

#include "murosimf/robot/robot_reader.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

/// As the reader has it, fixed joints welded.
RobotFile read_whole(const std::string& text) { return read_robot(write("robot.urdf", text)); }

std::string inertial(const std::string& mass, const std::string& tensor, const std::string& origin = "") {
  return "<inertial><origin xyz='" + (origin.empty() ? "0 0 0" : origin) + "'/><mass value='" + mass + "'/><inertia " +
         tensor + "/></inertial>";
}

const std::string zero = "ixx='0' iyy='0' izz='0'";

/// The body of a limb, in line 2, behind a hinge.
RobotFile with_limb(const std::string& inside, const std::string& type = "continuous") {
  return read_whole(
      robot_xml(link("limb", inside) + joint(type, "base", "limb", type == "prismatic" ? any_limit : "")));
}

TEST(SolidRepair, MakesASphereOfWaterOfAPoint) {
  const auto robot = with_limb(inertial("0.5", zero));
  const robot_formats::MassProperties& solid = robot.description.bodies.at(1).solid;
  const double radius = std::cbrt(0.5 / 1000 / (4.0 / 3 * std::acos(-1)));
  EXPECT_EQ(solid.mass, 0.5);
  EXPECT_NEAR(solid.inertia.xx, 2.0 / 5 * 0.5 * radius * radius, 1e-12);
  EXPECT_EQ(solid.inertia.yy, solid.inertia.xx);
  EXPECT_EQ(solid.inertia.xy, 0);
  EXPECT_TRUE(any_contains(robot.notes, "robot.urdf:2: link 'limb' moves without inertia: 0.00048 kg m^2"));
}

TEST(SolidRepair, MakesASphereOfWhatIsZeroButForRounding) {
  EXPECT_GT(with_limb(inertial("0.5", "ixx='0' iyy='0' izz='0' ixz='1e-20'")).description.bodies.at(1).solid.inertia.xx,
            1e-4);
}

TEST(SolidRepair, LeavesPointsThatAreWeldedToOthers) {
  const auto robot =
      read_whole(robot_xml(link("limb", solid()) + link("tip", inertial("0.5", zero)) +
                           joint("continuous", "base", "limb", "", "j1") + joint("fixed", "limb", "tip", "", "j2")));
  EXPECT_EQ(robot.description.bodies.at(1).solid.inertia.xx, 1);  // about the origin, where the point is
}

TEST(SolidRepair, MovesWhatHasNoMass) {
  for (const std::string type : {"continuous", "prismatic"}) {
    const auto robot = with_limb("", type);
    EXPECT_EQ(robot.description.bodies.at(1).solid.mass, 1e-6);
    EXPECT_EQ(robot.description.bodies[1].solid.inertia.zz, 1e-6);
    EXPECT_TRUE(any_contains(robot.notes, "robot.urdf:2: link 'limb' moves without mass")) << type;
  }
}

TEST(SolidRepair, LeavesLinksWithoutMassThatCarryOthers) {
  const auto robot =
      read_whole(robot_xml(link("cross") + link("limb", solid()) + joint("continuous", "base", "cross", "", "j1") +
                           joint("continuous", "cross", "limb", "<axis xyz='0 1 0'/>", "j2")));
  EXPECT_EQ(robot.description.bodies.at(1).solid.mass, 0);
  EXPECT_FALSE(any_contains(robot.notes, "moves without"));
}

TEST(SolidRepair, WeighsInertiaWithoutMass) {
  const auto robot = with_limb(inertial("0", "ixx='1' iyy='1' izz='1'"));
  EXPECT_EQ(robot.description.bodies.at(1).solid.mass, 1e-6);
  EXPECT_EQ(robot.description.bodies[1].solid.inertia.xx, 1);
  EXPECT_TRUE(any_contains(robot.notes, "robot.urdf:2: link 'limb' moves without mass: 1e-06 kg is taken"));
}

TEST(SolidRepair, RaisesANegativeMomentToTheLeastThatASolidHas) {
  // a quarter about x: z of the tensor is along -y of the link
  const auto robot = with_limb(
      "<inertial><origin rpy='1.5707963267948966 0 0'/><mass value='1'/>"
      "<inertia ixx='2' iyy='3' izz='-1'/></inertial>");
  const SymMat3d& inertia = robot.description.bodies.at(1).solid.inertia;
  expect_near({inertia.xx, inertia.yy, inertia.zz}, {2, 1, 3});
  expect_near({inertia.xy, inertia.xz, inertia.yz}, {});
  EXPECT_TRUE(any_contains(robot.warnings, "robot.urdf:2: inertia of link 'limb' is not positive definite"));
}

TEST(SolidRepair, MakesASphereOfWhatHasNoPositiveMoment) {
  for (const std::string tensor :
       {"ixx='-1' iyy='-2' izz='-2'", "ixx='0' iyy='0' izz='-1'", "ixx='0' iyy='0' izz='-1e-9'"}) {
    const auto robot = with_limb(inertial("0.5", tensor));
    EXPECT_NEAR(robot.description.bodies.at(1).solid.inertia.xx, 4.849e-4, 1e-7) << "0.5 kg of water, as a ball";
    EXPECT_TRUE(any_contains(robot.warnings, "robot.urdf:2: no principal moment of link 'limb' is positive")) << tensor;
    EXPECT_FALSE(any_contains(robot.notes, "moves without inertia"));
  }
}

TEST(SolidRepair, ForgetsWhatStandsForNoMass) {
  const auto robot = read_whole(robot_xml(link("cross", inertial("1e-13", "ixx='1e-13' iyy='1e-13' izz='1e-13'")) +
                                          link("limb", solid()) + joint("continuous", "base", "cross", "", "j1") +
                                          joint("continuous", "cross", "limb", "<axis xyz='0 1 0'/>", "j2")));
  EXPECT_EQ(robot.description.bodies.at(1).solid.mass, 0);
  EXPECT_EQ(robot.description.bodies[1].solid.inertia.xx, 0);
  EXPECT_FALSE(any_contains(robot.notes, "moves without"));
}

TEST(SolidRepair, GivesARodThickness) {
  const auto robot = with_limb(inertial("1", "ixx='2' iyy='2' izz='0'"));
  EXPECT_NEAR(robot.description.bodies.at(1).solid.inertia.zz, 2e-3, 1e-12);
  EXPECT_NEAR(robot.description.bodies[1].solid.inertia.xx, 2, 1e-12);
  EXPECT_FALSE(any_contains(robot.warnings, "positive definite"));
  EXPECT_TRUE(any_contains(robot.notes, "is not positive definite"));
}

TEST(SolidRepair, CountsWhatIsWeldedToABody) {
  // a rod along x welded to one along z: each is singular, both together are a cross
  const auto robot = read_whole(robot_xml(
      link("a", inertial("1", "ixx='1' iyy='1' izz='0'")) + link("b", inertial("1", "ixx='0' iyy='1' izz='1'")) +
      joint("continuous", "base", "a", "", "j1") + joint("fixed", "a", "b", "", "j2")));
  const SymMat3d& inertia = robot.description.bodies.at(1).solid.inertia;
  expect_near({inertia.xx, inertia.yy, inertia.zz}, {1, 2, 1});
}

}  // namespace
}  // namespace murosimf::robot
