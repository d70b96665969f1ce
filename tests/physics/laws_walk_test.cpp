// A robot walks under every contact law and at every dynamic level.
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

class Walker : public testing::TestWithParam<LevelAndLaw> {};
INSTANTIATE_TEST_SUITE_P(Contact, Walker,
                         at_every_level({"implicit_stick", "kelvin_voigt", "paper", "paper_multipoint"}), test_name);

// 18 s at 0.2 m/s: no fall, and within 15 % of the commanded way (ramp at the start, attenuation by the joints, and the
// slip that viscous friction has).
TEST_P(Walker, GetsWhereItIsTold) {
  Rig rig;
  Entity& robot = rig.add("robot", kid21());
  rig.simulation.attach<control::WalkEngine>("walk_engine", robot, control::WalkEngine::rate_hz, Vec3d{0.2, 0, 0});
  rig.attach_dynamics(robot, dynamics(GetParam()));
  rig.simulation.initialize();
  const double start = Rig::place(robot).x;
  rig.run(18.0);
  EXPECT_GT(robot.base().get(properties::orientation).z.z, std::cos(10 * degree));
  EXPECT_NEAR(Rig::place(robot).x - start, 0.2 * 18, 0.15 * 0.2 * 18);
}

}  // namespace
}  // namespace murosimf::test
