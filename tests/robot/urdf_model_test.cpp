/// urdf_model_test - a URDF file becomes a model, and plays in a scene.
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

/// A base, a limb at the joint `swing`, and a tip of 3 kg that is fixed to the limb 2 m above the joint.
std::string pendulum() {
  return robot_xml(link("limb", solid() + collision_xml("<sphere radius='0.1'/>")) + link("tip", solid(3)) +
                   joint("revolute", "base", "limb", any_limit + "<dynamics damping='0.5' friction='0.25'/>", "swing") +
                   joint("fixed", "limb", "tip", "<origin xyz='0 0 2'/>", "glue"));
}

TEST(UrdfModel, WeldsFixedLinksAndKeepsThemAsFrames) {
  const RobotFile robot = read_robot(write("robot.urdf", pendulum()));
  const Model& model = *robot.model;
  EXPECT_EQ(model.name(), "r");
  EXPECT_DOUBLE_EQ(model.tree().mass, 5);
  const int limb = model.object_index("limb");
  EXPECT_EQ(limb, model.object_index("swing"));
  EXPECT_DOUBLE_EQ(*model.find(properties::mass, limb), 4);
  expect_near(*model.find(properties::center_of_mass, limb), {0, 0, 1.5});
  // two solids of 1 kg m^2, moved by 1.5 m with 1 kg and by 0.5 m with 3 kg
  EXPECT_DOUBLE_EQ(model.find(properties::inertia, limb)->xx, 2 + 1.5 * 1.5 + 3 * 0.5 * 0.5);
  expect_near(model.placement(model.object_index("tip")).offset, {0, 0, 2});
}

TEST(UrdfModel, KeepsTheConstantsOfJoints) {
  const RobotFile robot = read_robot(write("robot.urdf", pendulum()));
  const int joint = robot.model->object_index("swing");
  expect_near(*robot.model->find(properties::joint_range, joint), {-1, 1, 0});
  EXPECT_EQ(*robot.model->find(properties::joint_damping, joint), 0.5);
  EXPECT_EQ(*robot.model->find(properties::joint_friction, joint), 0.25);
  EXPECT_EQ(*robot.model->find(properties::joint_rate_limit, joint), 3);
}

TEST(UrdfModel, PlaysInAScene) {
  write("robot.urdf", pendulum());
  const auto file = write("scene.toml",
                          "[[teams]]\nname = \"a\"\n[[robots]]\nname = \"one\"\nteam = \"a\"\n"
                          "model = \"robot.urdf\"\nlevel = \"articulated_dynamics\"\ncontroller = \"none\"\n");
  scene::Scene scene(file.string());
  scene.simulation().initialize();
  EXPECT_EQ(scene.simulation().world().entity("one").model().name(), "r");
}

/// Warnings of a scene with one robot at articulated_dynamics.
std::vector<std::string> warnings_of(const std::string& urdf) {
  write("robot.urdf", urdf);
  const auto file = write("scene.toml",
                          "[field]\ngoals = false\n[[robots]]\nname = \"one\"\nmodel = \"robot.urdf\"\n"
                          "level = \"articulated_dynamics\"\ncontroller = \"none\"\nfixed_base = true\n"
                          "position = [0, 0, 3]\n");
  return make_report(scene::Scene(file.string())).warnings;
}

std::string gripper(const std::string& first, const std::string& second, const std::string& third) {
  const std::string limit = "<limit lower='-1' upper='1' velocity='3' effort='";
  return robot_xml(link("a", solid()) + link("b", solid()) + link("c", solid()) +
                   joint("revolute", "base", "a", limit + first, "ja") +
                   joint("revolute", "base", "b", limit + second, "jb") +
                   joint("revolute", "base", "c", limit + third, "jc"));
}

TEST(UrdfModel, JointsThatFollowOthersDoNotHangFree) {
  const std::string follow_a = "'/><mimic joint='ja' multiplier='-1'/>", follow_b = "'/><mimic joint='jb'/>";
  EXPECT_FALSE(any_contains(warnings_of(gripper("5'/>", "5" + follow_a, "5" + follow_b)), "hang free"));
  EXPECT_FALSE(any_contains(warnings_of(gripper("5'/>", "0" + follow_a, "0" + follow_b)), "hang free"));
  EXPECT_TRUE(any_contains(warnings_of(gripper("0'/>", "0" + follow_a, "0" + follow_b)),
                           "1 of its 3 joints have no servo and hang free"));
  EXPECT_TRUE(any_contains(warnings_of(gripper("5'/>", "0'/>", "0" + follow_a)),
                           "1 of its 3 joints have no servo and hang free"));
}

TEST(UrdfModel, NamesTheFileWhereAMovingLinkHasNoMass) {
  const auto description =
      read_robot(write("robot.urdf", robot_xml(link("limb") + joint("revolute", "base", "limb", any_limit))));
  EXPECT_TRUE(any_contains(description.notes, "robot.urdf:2: link 'limb' moves without mass"));
}

}  // namespace
}  // namespace murosimf::robot
