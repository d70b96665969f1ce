/// urdf_model_test - a URDF file becomes a model, and plays in a scene.
#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"
#include "tests/formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace formats::urdf::urdf_files;

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

TEST(UrdfModel, NamesTheFileWhereAMovingLinkHasNoMass) {
  const auto description =
      read_robot(write("robot.urdf", robot_xml(link("limb") + joint("revolute", "base", "limb", any_limit))));
  EXPECT_TRUE(any_contains(description.warnings, "robot.urdf:2: body 'limb' moves but has no mass"));
}

}  // namespace
}  // namespace murosimf::robot
