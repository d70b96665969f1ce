/// robot_toes_test - feet of several bodies are one sole each.
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/biped_urdf.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using robot_formats::urdf::urdf_files::write;

/// With toes of 6 cm at the ends of its feet, which reach from -7 to 16 cm; `up` [m]: how much higher they end.
RobotFile with_toes(double up) {
  std::string text = fixtures::biped_urdf({}), toes;
  for (const std::string side : {"l", "r"}) {
    toes += fmt::format(
        "<link name='{0}_toe'><inertial><mass value='0.1'/><inertia ixx='1e-4' iyy='1e-4' "
        "izz='1e-4'/></inertial><collision>"
        "<origin xyz='0.03 0 0'/><geometry><box size='0.06 0.08 0.03'/></geometry></collision></link><joint "
        "name='{0}_toe_joint' "
        "type='revolute'><parent link='{0}_foot'/><child link='{0}_toe'/><origin xyz='0.16 0 {1}'/><axis xyz='0 1 "
        "0'/><limit "
        "lower='-0.5' upper='0.5' effort='5' velocity='3'/></joint>",
        side, -0.06 + up);
  }
  text.insert(text.find("</robot>"), toes);
  return read_robot(write("toes.urdf", text));
}

TEST(RobotToes, BelongToTheSoleOfTheirFoot) {
  const RobotFile robot = with_toes(0);
  const auto soles = robot.model->having(properties::sole);
  ASSERT_EQ(soles.size(), 2u);
  for (const int sole : soles) {
    EXPECT_NEAR(robot.model->find(properties::sole, sole)->half_length, (0.23 + 0.06) / 2, 1e-12);
    EXPECT_NEAR(robot.model->find(properties::sole, sole)->half_width, 0.05, 1e-12);
  }
  EXPECT_NEAR(robot.model->placement(soles[0]).offset.x, (-0.07 + 0.22) / 2, 1e-12);
}

TEST(RobotToes, DoNotCountWhereTheyAreOffTheGround) {
  const RobotFile robot = with_toes(0.02);
  const auto soles = robot.model->having(properties::sole);
  ASSERT_EQ(soles.size(), 2u);
  EXPECT_NEAR(robot.model->find(properties::sole, soles[0])->half_length, 0.115, 1e-12);
}

}  // namespace
}  // namespace murosimf::robot
