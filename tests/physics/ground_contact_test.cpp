// A box and a ball on the ground: sticking, sliding, rolling, bouncing.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_parameters.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

constexpr double degree = pi / 180;

/// Acceleration along the slope of a box that was let go, between 0.5 s and 1 s; its speed at 1 s in `speed`.
double slope_acceleration(double slope, double friction, double& speed) {
  Rig rig(friction, slope);
  Entity& box = rig.add("box", box_model(friction));
  rig.attach_dynamics(box);
  rig.run(0.5);
  const double before = Rig::velocity(box).x;
  rig.run(0.5);
  speed = std::abs(Rig::velocity(box).x);
  return (Rig::velocity(box).x - before) / 0.5;
}

// Law: Coulomb friction holds up to atan(mu) and slides beyond with g (sin a - mu cos a). Limits: 1e-6 m/s is
// standing, 0.005 m/s^2 is 0.05 % of gravity.
TEST(Incline, SticksJustBelowTheFrictionAngle) {
  double speed = 0;
  slope_acceleration(std::atan(0.5) - 0.2 * degree, 0.5, speed);
  EXPECT_LT(speed, 1e-6);
}
TEST(Incline, SlidesJustAboveTheFrictionAngle) {
  for (const double above : {0.2, 1.5, 5.5, 13.5}) {
    const double slope = std::atan(0.5) + above * degree;
    double speed = 0;
    const double acceleration = slope_acceleration(slope, 0.5, speed);
    EXPECT_NEAR(acceleration, g * (std::sin(slope) - 0.5 * std::cos(slope)), 0.005) << above << " degrees above";
  }
}

/// How far a box of 1 m/s slides on friction mu until it turns back (its springs relax by a few tenths of a
/// millimetre).
double sliding_distance(double mu, double rate_hz) {
  Rig rig(mu, 0, rate_hz);
  Entity& box = rig.add("box", box_model(mu));
  rig.attach_dynamics(box);
  rig.run(0.5);  // settle
  const double start = Rig::place(box).x;
  Rig::launch(box, {1, 0, 0});
  double farthest = start;
  for (int i = 0; i < static_cast<int>(rate_hz); ++i) {
    rig.simulation.step();
    farthest = std::max(farthest, Rig::place(box).x);
  }
  EXPECT_LT(norm(Rig::velocity(box)), 1e-6);
  return farthest - start;
}

// Law: a sliding box stops after v^2 / (2 mu g). Semi-implicit Euler loses v dt / 2 of it, 0.5 % at 1 ms; what is left
// must be under 0.5 %, and shorter steps must come nearer.
TEST(Sliding, StopsAfterTheRightDistance) {
  const double mu = 0.5;
  const double exact = 1 / (2 * mu * g);
  const double at_1_ms = sliding_distance(mu, 1000);
  const double at_half_ms = sliding_distance(mu, 2000);
  EXPECT_NEAR(at_1_ms, exact - 0.5e-3, 0.005 * exact);
  EXPECT_NEAR(at_half_ms, exact, 0.005 * exact);
  EXPECT_LT(std::abs(at_half_ms - exact), std::abs(at_1_ms - exact));
}

// Law: under the paper's viscous friction (eq. 5) everything creeps down a slope with tan(a)/s_mu; 2 %.
TEST(PaperLaw, CreepsDownTheSlope) {
  const double slope = 3 * degree;
  for (const double s_mu : {1.0, 3.0}) {
    Rig rig(0.8, slope);
    // a ball that cannot roll: one contact point, huge inertia, so that only sliding is left
    PlacedShape foot;
    foot.shape = Sphere{0.05};
    auto model = std::make_shared<const Model>("slider", Chain{}
                                                             .base("slider")
                                                             .with(properties::mass, 4.3)
                                                             .with(properties::inertia, diagonal(1e6))
                                                             .with(properties::shapes, Shapes{foot}));
    Entity& slider = rig.add("slider", model);
    rig.attach_dynamics(slider, {}, true,
                        std::make_shared<collision::PaperLaw>(collision::PaperLawOptions{.friction = s_mu}));
    rig.run(4.0);
    const double before = Rig::place(slider).x;
    rig.run(6.0);
    const double creep = (Rig::place(slider).x - before) / 6.0;
    EXPECT_NEAR(creep, std::tan(slope) / s_mu, 0.02 * std::tan(slope) / s_mu) << "s_mu " << s_mu;
  }
}

// Law: a solid ball that starts sliding ends rolling with 5/7 of its speed, whatever the friction; then it keeps it.
TEST(Ball, RollsWithFiveSeventhsOfItsSpeed) {
  Rig rig(0.3);
  Entity& ball = rig.add("ball", io::ball_model({.material = ""}));
  rig.materials.set("", "", {.friction = 0.3});
  rig.attach_dynamics(ball);
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
TEST(Ball, RollingResistanceBringsItToRest) {
  const double c = 0.03;
  Rig rig(0.8);
  rig.materials.set("", "", {.friction = 0.8, .rolling = c});
  Entity& ball = rig.add("ball", io::ball_model({.material = ""}));
  rig.attach_dynamics(ball);
  rig.run(0.5);
  const double radius = 0.05, v = 0.7;
  Rig::launch(ball, {v, 0, 0}, {0, v / radius, 0});
  rig.run(1.0);
  EXPECT_NEAR(Rig::velocity(ball).x, v - 5.0 / 7.0 * c * g, 0.01 * v);
  rig.run(9.0);
  EXPECT_LT(norm(Rig::velocity(ball)), 1e-3);
}

// Law: restitution of a damped spring that cannot pull (contact_parameters.h); 3 % at 1 ms.
TEST(Ball, BouncesWithTheRestitutionOfItsMaterials) {
  for (const double e : {0.4, 0.6, 0.8}) {
    Rig rig;
    rig.materials.set("", "", {.restitution = e});
    Entity& ball = rig.add("ball", io::ball_model({.material = ""}), {.position = {0, 0, 0.5}});
    rig.attach_dynamics(ball);
    double down = 0, up = 0;
    for (int i = 0; i < 1000 && up == 0; ++i) {
      rig.simulation.step();
      const double v = Rig::velocity(ball).z;
      if (v < 0) down = std::max(down, -v);
      if (v > 0 && Rig::place(ball).z > 0.05) up = v;
    }
    EXPECT_NEAR(up / down, e, 0.03) << "restitution " << e;
  }
}

// Law: at rest the ground carries exactly the weight.
TEST(Box, GroundCarriesItsWeight) {
  Rig rig;
  Entity& box = rig.add("box", box_model());
  rig.attach_dynamics(box);
  rig.run(2.0);
  EXPECT_NEAR(box.base().get(properties::external_force).f.z, 4.3 * g, 1e-3 * 4.3 * g);
  EXPECT_LT(norm(Rig::velocity(box)), 1e-9);
}

// The law stays stable with steps of up to 10 ms.
TEST(Box, StandsWithLongSteps) {
  for (const double rate : {500.0, 200.0, 100.0}) {
    Rig rig(0.8, 3 * degree, rate);
    Entity& box = rig.add("box", box_model());
    rig.attach_dynamics(box);
    rig.run(2.0);
    const double before = Rig::place(box).x;
    rig.run(3.0);
    EXPECT_NEAR(Rig::place(box).x, before, 1e-6) << rate << " Hz";
  }
}

}  // namespace
}  // namespace murosimf::test
