/// urdf_words_test - words of other programs in a URDF file: those without a meaning here are reported, others have an effect.
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;

const std::string sphere = collision_xml("<sphere radius='1'/>");

double friction_of(const std::string& inside) {
  return read(with_link(solid() + sphere + sphere + inside)).bodies.at(0).shapes.at(1).placed.surface.friction;
}

TEST(UrdfWords, AreNamedOnceWhereTheyAreUnknown) {
  const auto description = read(robot_xml(link("limb", solid() + "<self_filter/>\n<self_filter/>") +
                                          joint("revolute", "base", "limb", any_limit + "<dynamics D='1' K='7000'/>") +
                                          "<gait speed='1'/>"));
  EXPECT_TRUE(names_unused(description, "robot.urdf:2: unknown element 'self_filter' in link is not used"));
  EXPECT_TRUE(names_unused(description, "robot.urdf:4: unknown attribute 'K' of dynamics is not used"));
  EXPECT_TRUE(names_unused(description, "robot.urdf:5: unknown element 'gait' in robot is not used"));
  EXPECT_EQ(description.unused.size(), 4u);
  EXPECT_EQ(std::ranges::count(description.unused, "link/self_filter", &robot_formats::Unused::word), 1);
  EXPECT_TRUE(description.warnings.empty());
  EXPECT_EQ(description.bodies.at(1).joints.at(0).damping, 0);
}

TEST(UrdfWords, AreReadAsNoOriginOfALink) {
  const auto description = read(with_link("<origin xyz='1 2 3'/>" + solid()));
  EXPECT_TRUE(names_unused(description, "element 'origin' is not used"));
  expect_near(description.bodies.at(0).solid.center, {});
}

TEST(UrdfContact, OfBulletIsTheFrictionOfAllShapes) {
  EXPECT_EQ(friction_of(""), 1.0);
  EXPECT_EQ(friction_of("<contact><lateral_friction value='0.3'/></contact>"), 0.3);
  EXPECT_EQ(friction_of("<contact><restitution value='0.3'/></contact>"), 1.0);
}

TEST(UrdfContact, NamesWhatDoesNotAct) {
  const auto description = read(with_link(solid() + sphere + "<contact><stiffness value='3e4'/></contact>"));
  EXPECT_TRUE(names_unused(description, "element 'stiffness' is not used"));
  EXPECT_TRUE(description.warnings.empty());
}

robot_formats::RobotDescription with_collision(const std::string& inside) {
  return read("<robot name='r'>" + link("base", solid() + sphere) + "<gazebo reference='base'><collision>" + inside +
              "</collision></gazebo></robot>");
}

TEST(UrdfGazeboCollision, GivesTheFrictionOfItsSurface) {
  const auto description =
      with_collision("<surface><friction><ode><mu>0.4</mu><mu2>0.4</mu2></ode></friction></surface>");
  EXPECT_EQ(description.bodies.at(0).shapes.at(0).placed.surface.friction, 0.4);
  EXPECT_TRUE(description.warnings.empty());
}

TEST(UrdfGazeboCollision, NamesWhatDoesNotAct) {
  const auto description =
      with_collision("<max_contacts>4</max_contacts><surface><bounce><threshold>1</threshold></bounce></surface>");
  EXPECT_TRUE(names_unused(description, "element 'max_contacts' of a collision in gazebo is not used"));
  EXPECT_TRUE(names_unused(description, "element 'bounce' of a collision in gazebo is not used"));
  EXPECT_EQ(description.bodies.at(0).shapes.at(0).placed.surface.friction, 1.0);
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
