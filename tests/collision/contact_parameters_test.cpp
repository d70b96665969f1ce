#include "murosimf/collision/contact_parameters.h"
#include "murosimf/motion/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::collision {
namespace {

/// Speed kept by a mass that meets a damped spring which cannot pull: m = k = 1, d = 2 z, by Runge-Kutta; the last
/// step is cut where the force vanishes (regula falsi on the force, which is smooth).
double bounce(double z) {
  struct State {
    double x, v;  // compression and its rate
  };
  const auto rate = [z](const State& s) { return State{s.v, -s.x - 2 * z * s.v}; };
  const auto step = [&](const State& s, double h) {
    const auto moved = [&](const State& k, double t) { return State{s.x + t * k.x, s.v + t * k.v}; };
    const State a = rate(s), b = rate(moved(a, h / 2)), c = rate(moved(b, h / 2)), d = rate(moved(c, h));
    return State{s.x + h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), s.v + h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v)};
  };
  const auto force = [z](const State& s) { return s.x + 2 * z * s.v; };
  const double h = 1e-3;
  State s{0, 1};
  while (force(step(s, h)) > 0) s = step(s, h);
  double low = 0, high = h;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (force(step(s, middle)) > 0 ? low : high) = middle;
  }
  return -step(s, low).v;
}

// Tolerance: Runge-Kutta with h = 1e-3 over pi seconds errs by h^4 = 1e-12; bisection by 1e-18.
TEST(ContactParametersTest, RestitutionAgainstIntegration) {
  law::Worst error;
  for (const double z : {0.0, 0.01, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.7072, 0.8, 0.9, 0.95})
    error.see(std::abs(restitution(z) - bounce(z)), "damping ratio", z);
  law::expect_below({.law = "restitution of a damping ratio: error",
                     .level = "contact parameters",
                     .source = "damped spring that cannot pull, by Runge-Kutta"},
                    error, 1e-11, "");
}

// The restitution falls steadily. Tolerance: 60 halvings of 0.95, over the slope of the restitution, which is -1.6 at
// most and -0.3 at least.
TEST(ContactParametersTest, DampingRatioInvertsRestitution) {
  double last = 1.1;
  law::Worst error;
  for (int i = 0; i <= 950; ++i) {
    const double z = i * 1e-3;
    const double e = restitution(z);
    ASSERT_LT(e, last) << z;
    last = e;
    error.see(std::abs(damping_ratio(e) - z), "damping ratio", z);
  }
  law::expect_below({.law = "damping ratio of a restitution: error, 0 to 0.95",
                     .level = "contact parameters",
                     .source = "inverse of the restitution"},
                    error, 1e-14, "");
}

void expect_weight(const std::string& thing, const std::string& points, double force, double weight, double tolerance) {
  law::expect_near({.law = thing + ": force of its springs at 0.4 mm",
                    .level = "contact parameters",
                    .source = "its weight on " + points},
                   force, weight, tolerance, "N");
}

// Rule: a perfect bounce has no damping; what the largest ratio does not reach gets the largest ratio, 0.95.
TEST(ContactParametersTest, EndsOfTheRange) {
  EXPECT_EQ(restitution(0), 1);
  EXPECT_NEAR(damping_ratio(1), 0, 1e-15);
  EXPECT_NEAR(damping_ratio(0), 0.95, 1e-15);
  EXPECT_NEAR(damping_ratio(0.14), 0.95, 1e-15);
  EXPECT_LT(damping_ratio(0.16), 0.95);
}

// A robot stands on four points per sole; damping is half of critical for the mass that half of the points carry.
// Tolerance: rounding.
TEST(ContactParametersTest, Robot) {
  const Model robot = fixtures::two_legged();
  const ContactParameters p = contact_parameters(robot, {.friction = 0.7, .rolling = 0.02}, {.implicit_law = false});
  expect_weight("robot of 3 kg", "8 points", 8 * p.stiffness * 0.4e-3, 3 * 9.81, 1e-12);
  EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * 3 / 4)), 0.5, 1e-15);
  EXPECT_EQ(p.tangent_stiffness, p.stiffness);
  EXPECT_EQ(p.tangent_damping, 0.5 * p.damping);
  EXPECT_EQ(p.friction, 0.7);
  EXPECT_EQ(p.rolling, 0.02);
  EXPECT_EQ(p.theta, 1);
}

/// A box of so many kg.
Model crate_of(double kg) {
  using namespace properties;
  return {"crate", Chain{}.base().with(mass, kg).with(shapes, {fixtures::placed(Box{{0.1, 0.1, 0.1}})})};
}

// A step is half a radian of the oscillation of the mass at a point, if the weight alone would make that softer.
// Tolerance: rounding.
TEST(ContactParametersTest, ImplicitLawsAreAsStiffAsTheStepResolves) {
  const Model robot = fixtures::two_legged();
  for (const double dt : {0.5e-3, 1e-3, 2e-3}) {
    const ContactParameters p = contact_parameters(robot, {}, {.dt = dt});
    EXPECT_NEAR(dt * std::sqrt(p.stiffness / (3.0 / 4)), 0.5, 1e-14) << dt;
    EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * 3 / 4)), 0.5, 1e-15);
  }
  expect_weight("robot of 3 kg, steps of 10 ms", "8 points",
                8 * contact_parameters(robot, {}, {.dt = 0.01}).stiffness * 0.4e-3, 3 * 9.81, 1e-12);
}

// Between bodies a step is a radian of the reduced mass; the points carry the heavier one. Tolerance: rounding.
TEST(ContactParametersTest, TwoBodies) {
  const Model light = crate_of(2), heavy = crate_of(6);
  const double reduced = 2.0 * 6 / (2 + 6);
  const ContactParameters p = contact_parameters(light, heavy, {}, {});
  EXPECT_NEAR(1e-3 * std::sqrt(p.stiffness / (reduced / 2)), 1, 1e-14);
  EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * reduced / 2)), 0.5, 1e-15);
  EXPECT_EQ(contact_parameters(heavy, light, {}, {}).stiffness, p.stiffness);
  const Model block = crate_of(4000);
  expect_weight("crate of 2 kg under 4000 kg", "4 points",
                4 * contact_parameters(light, block, {}, {}).stiffness * 0.4e-3, 4000 * 9.81, 1e-8);
  expect_weight("crate of 2 kg and one of 6 kg, explicit law", "4 points",
                4 * contact_parameters(heavy, light, {}, {.implicit_law = false}).stiffness * 0.4e-3, 2 * 9.81, 1e-12);
}

// A spring that an explicit step does not bear is made softer, with the same damping ratio; others stay.
TEST(ContactParametersTest, ForAnExplicitStep) {
  const Model crate = crate_of(2);
  const ContactParameters p = contact_parameters(crate, {}, {}), softer = for_explicit_step(p, 1e-3);
  EXPECT_NEAR(1e-6 * softer.stiffness / p.mass, 0.02, 1e-16);
  EXPECT_NEAR(softer.damping / std::sqrt(softer.stiffness), p.damping / std::sqrt(p.stiffness), 1e-12);
  EXPECT_NEAR(softer.tangent_stiffness, softer.stiffness, 1e-9);
  EXPECT_NEAR(softer.tangent_damping, softer.damping / 2, 1e-12);
  EXPECT_EQ(for_explicit_step(p, 1e-5).stiffness, p.stiffness);
  const ContactParameters ball = contact_parameters(fixtures::ball_model(0.05, 0.1), {}, {});
  EXPECT_EQ(for_explicit_step(ball, 1e-3).stiffness, ball.stiffness) << "it bounces";
}

// Four points carry it; with the gravity of the Moon.
TEST(ContactParametersTest, ThingWithoutSoles) {
  const Model crate = crate_of(2);
  const ContactParameters p = contact_parameters(crate, {}, {1.62, 1e-3, false});
  expect_weight("crate of 2 kg on the Moon", "4 points", 4 * p.stiffness * 0.4e-3, 2 * 1.62, 1e-13);
  EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * 2 / 2)), 0.5, 1e-15);
}

/// Speed that a mass keeps which meets these constants with 1 m/s, on the average over where in a step it touches.
double bounce_in_steps(const ContactParameters& p, double mass, double dt, bool implicit_law) {
  constexpr int phases = 100;
  double sum = 0;
  for (int i = 0; i < phases; ++i) {
    double depth = -dt * (i + 0.5) / phases, v = 1;
    while (v > 0 || depth > 0) {
      const double spring = p.stiffness * depth;
      const double free = implicit_law ? (v - dt * spring / mass) / (1 + dt * p.damping / mass)
                                       : v - dt * (spring + p.damping * v) / mass;
      if (depth > 0 && spring + p.damping * (implicit_law ? free : v) > 0) v = free;
      depth += dt * v;
    }
    sum -= v;
  }
  return sum / phases;
}

// Tolerance: 2 %, of the ends of the bounce, which fall into steps.
TEST(ContactParametersTest, BallBouncesInLongSteps) {
  const Model ball = fixtures::ball_model(0.05, 0.1);
  for (const double e : {0.5, 0.8, 0.95}) {
    law::Worst error;
    for (const bool implicit_law : {true, false}) {
      for (const double dt : {0.5e-3, 1e-3, 2e-3, 5e-3, 10e-3}) {
        const ContactParameters p = contact_parameters(ball, {.restitution = e}, {9.81, dt, implicit_law});
        EXPECT_EQ(p.theta, 0);
        error.see(std::abs(bounce_in_steps(p, 0.1, dt, implicit_law) / e - 1), "step [s]", dt);
      }
    }
    law::expect_below({.law = fmt::format("ball: relative error of restitution {}, steps of 0.5 to 10 ms", e),
                       .level = "contact parameters",
                       .source = "the restitution of the pair of materials"},
                      error, 0.02, "");
  }
}

// With short steps the constants are those of the spring: the weight at 0.4 mm, and a restitution of 0.6. Tolerance:
// k dt^2 / m = 2e-8, and its root.
TEST(ContactParametersTest, Ball) {
  const Model ball = fixtures::ball_model(0.05, 0.1);
  const ContactParameters p = contact_parameters(ball, {.restitution = 0.6}, {.dt = 1e-6});
  expect_weight("ball of 0.1 kg", "1 point", p.stiffness * 0.4e-3, 0.1 * 9.81, 1e-3);
  law::expect_near({.law = "ball: restitution of its damping",
                    .level = "contact parameters",
                    .source = "the restitution of the pair of materials"},
                   restitution(p.damping / (2 * std::sqrt(p.stiffness * 0.1))), 0.6, 1e-3, "");
}

// Rule: without gravity the weight on Earth gives the stiffness; a stiffness of the pair overrides both.
TEST(ContactParametersTest, WhereTheStiffnessComesFrom) {
  const Model robot = fixtures::two_legged();
  EXPECT_EQ(contact_parameters(robot, {}, {0}).stiffness, contact_parameters(robot, {}, {}).stiffness);
  const ContactParameters p = contact_parameters(robot, {.stiffness = 5000}, {});
  EXPECT_EQ(p.stiffness, 5000);
  EXPECT_EQ(contact_parameters(robot, {.stiffness = 0.5}, {}).stiffness, 0.5) << "however soft";
  EXPECT_NEAR(p.damping, std::sqrt(5000 * 3 / 4.0), 1e-11);
}

// Rule: a bounce is explicit in the depth (theta 0) as long as steps resolve it, dt^2 k / m < 0.36; robots and balls
// that somebody made too stiff are implicit (theta 1).
TEST(ContactParametersTest, Theta) {
  const Model ball = fixtures::ball_model(0.05, 0.1);
  const double k = 4000;  // dt^2 k / m = 0.04 (1 ms), 0.3596 (2.998 ms), 0.3605 (3.002 ms)
  EXPECT_EQ(contact_parameters(ball, {.stiffness = k}, {}).theta, 0);
  EXPECT_EQ(contact_parameters(ball, {.stiffness = k}, {.dt = 2.998e-3}).theta, 0);
  EXPECT_EQ(contact_parameters(ball, {.stiffness = k}, {.dt = 3.002e-3}).theta, 1);
  EXPECT_EQ(contact_parameters(fixtures::two_legged(), {.stiffness = 10}, {}).theta, 1);
}

// Rule: only a single sphere is round; a ball with a box on it is not.
TEST(ContactParametersTest, WhatIsRound) {
  using namespace properties;
  const PairSurface pair{.restitution = 0.9, .stiffness = 1000};
  const Model pill("pill", Chain{}.base().with(mass, 0.1).with(shapes, {fixtures::placed(Capsule{0.05, 0.1})}));
  const PlacedShape sphere = fixtures::placed(Sphere{0.05});
  const Model pair_of_balls("pair", Chain{}.base().with(mass, 0.1).with(shapes, {sphere, sphere}));
  EXPECT_EQ(contact_parameters(pill, pair, {}).theta, 1);
  EXPECT_EQ(contact_parameters(pair_of_balls, pair, {}).theta, 1);
  EXPECT_EQ(contact_parameters(fixtures::ball_model(0.05, 0.1), pair, {}).theta, 0);
}

}  // namespace
}  // namespace murosimf::collision
