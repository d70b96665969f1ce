// A robot that stands is pushed at its center of mass.
#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/physics/arm_swinger.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

/// Lean [deg] of the pelvis 3 s after a push [N s] forward.
double lean_after(double push, const std::string& level) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<ArmSwinger>("arm_swinger", robot, 100, 0.0);
  rig.attach_motion(robot, {.level = level});
  rig.run(1.0);
  if (level == "kinematic_walking") {
    robot.base().set(properties::linear_velocity, Vec3d{push / kid21()->tree().mass, 0, 0});
  } else {
    Rig::launch(robot, {push / kid21()->tree().mass, 0, 0});
  }
  rig.run(3.0);
  return std::acos(std::min(1.0, robot.base().get(properties::orientation).z.z)) / degree;
}

class Pushed : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, Pushed, testing::ValuesIn(dynamic_levels()), level_name);

// Regression, no law: the figures of the project's prototype.
TEST_P(Pushed, WithstandsAPushOfTwoNewtonSecondsAndFallsAtThree) {
  law::expect_below({.law = "standing robot pushed with 2 N s: lean of the pelvis after 3 s",
                     .level = GetParam(),
                     .source = "regression: the project's prototype stands"},
                    lean_after(2, GetParam()), 18, "deg");
  law::expect_above({.law = "standing robot pushed with 3 N s: lean of the pelvis after 3 s",
                     .level = GetParam(),
                     .source = "regression: the project's prototype falls"},
                    lean_after(3, GetParam()), 60, "deg");
}

TEST(KinematicWalking, CannotBePushed) {
  law::expect_below({.law = "standing robot pushed with 3 N s: lean of the pelvis after 3 s",
                     .level = "kinematic_walking",
                     .source = "it cannot fall"},
                    lean_after(3, "kinematic_walking"), 5, "deg");
}

}  // namespace
}  // namespace murosimf::test
