/// proto_model_test - a PROTO file becomes the model that a URDF file with the same robot becomes, and plays in a scene.
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"
#include "tests/robot/same_model.h"
#include "tests/robot_formats/proto/proto_files.h"

namespace murosimf::robot {
namespace {

using robot_formats::proto::proto_files::expect_near;
using robot_formats::proto::proto_files::write;

const std::string urdf = R"(<robot name='Mine'>
  <link name='mine'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'/></inertial></link>
  <link name='limb'>
    <inertial><origin xyz='0 0 -0.1'/><mass value='2'/><inertia ixx='0.1' ixy='0.01' iyy='0.1' izz='0.1'/></inertial>
    <collision><origin xyz='0 0 -0.2'/><geometry><box size='0.1 0.2 0.3'/></geometry></collision>
  </link>
  <link name='tip'><inertial><mass value='3'/><inertia ixx='1' iyy='1' izz='1'/></inertial></link>
  <joint name='swing' type='revolute'><parent link='mine'/><child link='limb'/><origin xyz='0 0.1 0' rpy='0.5 0 0'/>
    <axis xyz='0 1 0'/><limit lower='-1' upper='2' effort='3' velocity='4'/><dynamics damping='0.5' friction='0.25'/></joint>
  <joint name='glue' type='fixed'><parent link='limb'/><child link='tip'/><origin xyz='0 0 2'/></joint>
</robot>)";

// The axis of the joint is written in the frame of the parent: that of the URDF file turned by 0.5 rad about x.
const std::string children = R"(HingeJoint {
  jointParameters HingeJointParameters {
    axis 0 0.8775825618903728 0.479425538604203 anchor 0 0.1 0 minStop -1 maxStop 2 dampingConstant 0.5 staticFriction 0.25
  }
  device RotationalMotor { name "swing" maxTorque 3 maxVelocity 4 minPosition -1 maxPosition 2 }
  endPoint Solid {
    translation 0 0.1 0 rotation 1 0 0 0.5 name "limb"
    boundingObject Pose { translation 0 0 -0.2 children [ Box { size 0.1 0.2 0.3 } ] }
    physics Physics { density -1 mass 2 centerOfMass [ 0 0 -0.1 ] inertiaMatrix [ 0.1 0.1 0.1, 0.01 0 0 ] }
    children [ Solid { translation 0 0 2 name "tip" physics Physics { mass 3 inertiaMatrix [ 1 1 1, 0 0 0 ] } } ]
  }
})";

std::string text() {
  std::string all = robot_formats::proto::proto_files::robot(children);
  return all.replace(all.find("name IS name"), 12, "name IS name selfCollision TRUE");
}

TEST(ProtoModel, IsThatOfTheSameRobotInUrdf) {
  const RobotFile found = read_robot(write("robot.proto", text())), expected = read_robot(write("robot.urdf", urdf));
  for (const char* name : {"mine", "limb", "swing", "tip"}) {
    const int i = found.model->object_index(name), k = expected.model->object_index(name);
    same_model::expect_same_constants(*found.model, i, *expected.model, k, name);
    expect_near(same_model::bent(*found.model).r[i], same_model::bent(*expected.model).r[k]);
  }
  EXPECT_DOUBLE_EQ(found.model->tree().mass, 6);
}

TEST(ProtoModel, PlaysInAScene) {
  write("robot.proto", text());
  const auto file = write("scene.toml",
                          "[[robots]]\nname = \"one\"\nmodel = \"robot.proto\"\nlevel = \"articulated_dynamics\"\n"
                          "controller = \"none\"\n");
  scene::Scene scene(file.string());
  scene.simulation().initialize();
  for (int i = 0; i < 10; ++i) scene.simulation().step();
  EXPECT_EQ(scene.simulation().world().entity("one").model().name(), "Mine");
}

}  // namespace
}  // namespace murosimf::robot
