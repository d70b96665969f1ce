// A ball on the ground: sliding, rolling, bouncing.
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

class Ball : public testing::TestWithParam<LevelAndLaw> {};
INSTANTIATE_TEST_SUITE_P(Contact, Ball, at_every_level({"implicit_stick", "kelvin_voigt"}), test_name);

// Law: a solid ball that starts sliding ends rolling with 5/7 of its speed, whatever the friction; then it keeps it.
TEST_P(Ball, RollsWithFiveSeventhsOfItsSpeed) {
  Rig rig(0.3);
  Entity& ball = rig.add("ball", io::ball_model({.material = ""}));
  rig.materials.set("", "", {.friction = 0.3});
  rig.attach_dynamics(ball, dynamics(GetParam()));
  rig.run(0.5);
  Rig::launch(ball, {1, 0, 0});
  rig.run(1.0);
  const double rolling = Rig::velocity(ball).x;
  EXPECT_NEAR(rolling, 5.0 / 7.0, 1e-4);
  EXPECT_NEAR(ball.base().get(properties::angular_velocity).y, rolling / 0.05, 1e-3);
  rig.run(1.0);
  EXPECT_NEAR(Rig::velocity(ball).x, rolling, 1e-6);
}

// Law: rolling resistance c brakes a rolling solid ball with a = 5/7 c g; it comes to rest, and stays there.
TEST_P(Ball, RollingResistanceBringsItToRest) {
  const double c = 0.03;
  Rig rig(0.8);
  rig.materials.set("", "", {.friction = 0.8, .rolling = c});
  Entity& ball = rig.add("ball", io::ball_model({.material = ""}));
  rig.attach_dynamics(ball, dynamics(GetParam()));
  rig.run(0.5);
  const double radius = 0.05, v = 0.7;
  Rig::launch(ball, {v, 0, 0}, {0, v / radius, 0});
  rig.run(1.0);
  EXPECT_NEAR(Rig::velocity(ball).x, v - 5.0 / 7.0 * c * g, 0.01 * v);
  rig.run(9.0);
  EXPECT_LT(norm(Rig::velocity(ball)), 1e-3);
}

/// Speed kept by a ball that meets the ground with 3 m/s, without gravity, starting `height` [m] above it.
double bounce(const LevelAndLaw& names, double restitution, double height) {
  Rig rig;
  rig.simulation.world().gravity = {};
  rig.materials.set("", "", {.restitution = restitution});
  Entity& ball = rig.add("ball", io::ball_model({.material = ""}), {.position = {0, 0, height}});
  rig.attach_dynamics(ball, dynamics(names));
  rig.simulation.initialize();
  Rig::launch(ball, {0, 0, -3});
  rig.run(0.1);
  return Rig::velocity(ball).z / 3;
}

// Law: restitution of a damped spring that cannot pull (contact_parameters.h); 3 % at 1 ms on the average over where in
// a step the ball touches. A single bounce scatters by up to 8 %: steps are 1/20 of a bounce.
TEST_P(Ball, BouncesWithTheRestitutionOfItsMaterials) {
  for (const double e : {0.4, 0.6, 0.8}) {
    double sum = 0;
    constexpr int phases = 10;
    for (int i = 0; i < phases; ++i) sum += bounce(GetParam(), e, 3e-3 * (1 + i / double{phases}));
    EXPECT_NEAR(sum / phases, e, 0.03 * e);
  }
}

}  // namespace
}  // namespace murosimf::test
