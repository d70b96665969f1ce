/// urdf_gazebo_test - friction, springs and sensors in gazebo blocks.
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot_formats::urdf {
namespace {

using namespace urdf_files;

std::string foot_and(const std::string& blocks) {
  return robot_xml(
      link("foot", solid() + collision_xml("<box size='1 1 1'/>") + collision_xml("<sphere radius='1'/>")) +
      joint("revolute", "base", "foot", any_limit, "ankle") + blocks);
}

TEST(UrdfGazebo, GivesItsFrictionToAllShapesOfTheLink) {
  EXPECT_EQ(read(foot_and("")).bodies.at(1).shapes.at(0).placed.surface.friction, 1.0);
  const auto description = read(foot_and("<gazebo reference='foot'><mu1>0.6</mu1><mu2>0.6</mu2></gazebo>"));
  for (const robot_formats::ShapeDescription& shape : description.bodies.at(1).shapes)
    EXPECT_EQ(shape.placed.surface.friction, 0.6);
  EXPECT_TRUE(description.warnings.empty());
  const auto old = read(foot_and("<gazebo reference='foot'><mu1 value='0.7'/></gazebo>"));
  EXPECT_EQ(old.bodies.at(1).shapes.at(1).placed.surface.friction, 0.7);
}

TEST(UrdfGazebo, WarnsAboutFrictionThatDiffersByDirection) {
  const auto description = read(foot_and("<gazebo reference='foot'><mu1>0.6</mu1><mu2>0.5</mu2></gazebo>"));
  EXPECT_TRUE(any_contains(description.warnings, "robot.urdf:4: friction of link 'foot' differs by direction"));
}

TEST(UrdfGazebo, ReadsSpringsOfJoints) {
  const auto description =
      read(foot_and("<gazebo reference='ankle'><springStiffness>12</springStiffness>"
                    "<springReference>0.25</springReference></gazebo>"));
  EXPECT_EQ(description.bodies.at(1).joints.at(0).stiffness, 12);
  EXPECT_EQ(description.bodies.at(1).joints.at(0).spring_reference, 0.25);
}

TEST(UrdfGazebo, ReadsACameraAndItsDistortion) {
  const auto description = read(foot_and(
      "<gazebo reference='foot'><sensor name='eye' type='camera'><update_rate>30</update_rate>"
      "<pose>1 2 3 0 0 1.5707963267948966</pose><camera><horizontal_fov>0.57</horizontal_fov><image><width>620</width>"
      "<height>480</height></image></camera><plugin><distortionK1>0.1</distortionK1><distortionT2>0.2</distortionT2>"
      "</plugin></sensor></gazebo>"));
  ASSERT_EQ(description.sensors.size(), 1u);
  const robot_formats::SensorDescription& sensor = description.sensors[0];
  EXPECT_EQ(sensor.kind, "camera");
  EXPECT_EQ(sensor.name, "eye");
  EXPECT_EQ(sensor.frame, "foot");
  EXPECT_EQ(sensor.rate, 30);
  expect_near(sensor.place.position, {1, 2, 3});
  expect_near(sensor.place.orientation.x, {0, 1, 0});
  const std::map<std::string, double> numbers{{"width", 620}, {"height", 480}, {"fov", 0.57}, {"k1", 0.1},
                                              {"k2", 0},      {"k3", 0},       {"p1", 0},     {"p2", 0.2}};
  EXPECT_EQ(sensor.numbers, numbers);
}

TEST(UrdfGazebo, ReadsSensorsOfLinksAndJoints) {
  const auto description =
      read(foot_and("<gazebo reference='foot'><sensor name='a' type='imu'/><sensor name='b' type='contact'/>"
                    "</gazebo><gazebo reference='ankle'><sensor name='c' type='force_torque'/></gazebo>"));
  ASSERT_EQ(description.sensors.size(), 3u);
  EXPECT_EQ(description.sensors[1].kind, "contact");
  EXPECT_TRUE(description.sensors[1].numbers.empty());
  EXPECT_EQ(description.sensors[2].frame, "ankle");
}

TEST(UrdfGazebo, NotesPluginsAndWarnsAboutBlocksForNothing) {
  const auto description =
      read(foot_and("<gazebo><plugin><robotNamespace>$(arg ns)</robotNamespace></plugin></gazebo>\n"
                    "<gazebo reference='fot'><mu1>0</mu1></gazebo>"));
  EXPECT_TRUE(names_unused(description, "robot.urdf:4: element 'plugin' in gazebo is not used"));
  EXPECT_TRUE(any_contains(description.warnings, "robot.urdf:5: gazebo block for 'fot'"));
}

TEST(UrdfGazebo, WarnsOnceThatEverythingHasWeight) {
  const auto description =
      read(foot_and("<gazebo reference='foot'><turnGravityOff>true</turnGravityOff></gazebo>"
                    "<gazebo reference='base'><gravity>0</gravity></gazebo>"));
  ASSERT_EQ(description.warnings.size(), 1u);
  EXPECT_TRUE(contains(description.warnings[0], "robot.urdf:4: gravity is switched off"));
}

TEST(UrdfGazebo, TellsWhatItDoesNotKnow) {
  const auto description = read(foot_and("<gazebo reference='foot'><gravity>true</gravity><wings>2</wings></gazebo>"));
  EXPECT_TRUE(names_unused(description, "element 'gravity'"));
  EXPECT_TRUE(any_contains(description.warnings, "unknown element 'wings'"));
}

}  // namespace
}  // namespace murosimf::robot_formats::urdf
