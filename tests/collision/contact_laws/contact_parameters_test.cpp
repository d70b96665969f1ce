#include <algorithm>

#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/dynamics/motion_properties.h"

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
  law::expect_near({.law = thing + ": force of its springs at their static deflection",
                    .level = "contact parameters",
                    .source = "its weight on " + points},
                   force, weight, tolerance, "N");
}

constexpr double g = 9.80665;  // [m/s^2]

/// Speed that a mass keeps which meets these constants with 1 m/s under an explicit law, on the average over where in a step it touches.
double bounce_in_steps(const ContactParameters& p, double mass, double dt) {
  constexpr int phases = 100;
  double sum = 0;
  for (int i = 0; i < phases; ++i) {
    double depth = -dt * (i + 0.5) / phases, v = 1;
    while (v > 0 || depth > 0) {
      const double force = p.stiffness * depth + p.damping * v;
      if (depth > 0 && force > 0) v -= dt * force / mass;
      depth += dt * v;
    }
    sum -= v;
  }
  return sum / phases;
}

// Rule: a perfect bounce has no damping; what the largest ratio does not reach gets the largest ratio, 0.95.
TEST(ContactParametersTest, EndsOfTheRange) {
  EXPECT_EQ(restitution(0), 1);
  EXPECT_NEAR(damping_ratio(1), 0, 1e-15);
  EXPECT_NEAR(damping_ratio(0), 0.95, 1e-15);
  EXPECT_NEAR(damping_ratio(0.14), 0.95, 1e-15);
  EXPECT_LT(damping_ratio(0.16), 0.95);
}

// A robot stands on four points per sole; damping is half of critical for the mass that half of the points carry under explicit
// laws, and critical under implicit ones. Tolerance: rounding.
TEST(ContactParametersTest, Robot) {
  const Model robot = fixtures::two_legged();
  const PairSurface pair{.friction = 0.7, .rolling = 0.02, .torsional = 0.003};
  for (const bool implicit_law : {false, true}) {
    const ContactParameters p = contact_parameters(robot, pair, {.implicit_law = implicit_law});
    expect_weight(implicit_law ? "robot of 3 kg" : "robot of 3 kg, explicit law", "8 points",
                  8 * p.stiffness * (implicit_law ? 0.1e-3 : 0.4e-3), 3 * g, 1e-12);
    EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * 3 / 4)), implicit_law ? 1 : 0.5, 1e-15);
    EXPECT_EQ(p.tangent_stiffness, p.stiffness);
    EXPECT_EQ(p.tangent_damping, 0.5 * p.damping);
    EXPECT_EQ(p.friction, 0.7);
    EXPECT_EQ(p.rolling, 0.02);
    EXPECT_EQ(p.torsional, 0.003);
    EXPECT_EQ(p.theta, 1);
    EXPECT_LT(p.restitution, 0) << "only what is round bounces";
  }
}

/// A box of so many kg.
Model crate_of(double kg) {
  using namespace properties;
  return {"crate", Chain{}.base().with(mass, kg).with(shapes, {fixtures::placed(Box{{0.1, 0.1, 0.1}})})};
}

bool are_alike(const ContactParameters& a, const ContactParameters& b) {
  return a.stiffness == b.stiffness && a.damping == b.damping && a.tangent_stiffness == b.tangent_stiffness &&
         a.tangent_damping == b.tangent_damping && a.restitution == b.restitution && a.theta == b.theta;
}

// Rule: constants are those of materials and masses, the same for every step. Only a bounce under an explicit law must be resolved.
TEST(ContactParametersTest, TheStepChangesNothing) {
  const Model robot = fixtures::two_legged(), crate = crate_of(2), ball = fixtures::ball_model(0.05, 0.1);
  for (const double dt : {0.1e-3, 2e-3, 10e-3}) {
    for (const bool implicit_law : {false, true}) {
      const ContactConditions usual{1e-3, implicit_law}, other{dt, implicit_law};
      for (const Model* model : {&robot, &crate})
        EXPECT_TRUE(are_alike(contact_parameters(*model, {}, usual), contact_parameters(*model, {}, other))) << dt;
      EXPECT_TRUE(are_alike(contact_parameters(robot, crate, {}, usual), contact_parameters(robot, crate, {}, other)));
    }
    EXPECT_TRUE(are_alike(contact_parameters(ball, {}, {}), contact_parameters(ball, {}, {dt, true})));
  }
}

// Between bodies the points carry the heavier one, explicitly the lighter one; damping is that of the reduced mass. Tolerance: rounding.
TEST(ContactParametersTest, TwoBodies) {
  const Model light = crate_of(5), heavy = crate_of(15);
  const double reduced = 5.0 * 15 / (5 + 15);
  const ContactParameters p = contact_parameters(light, heavy, {}, {});
  expect_weight("crate of 5 kg under 15 kg", "4 points", 4 * p.stiffness * 0.1e-3, 15 * g, 1e-12);
  EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * reduced / 2)), 1, 1e-15);
  EXPECT_EQ(contact_parameters(heavy, light, {}, {}).stiffness, p.stiffness);
  expect_weight("crate of 5 kg and one of 15 kg, explicit law", "4 points",
                4 * contact_parameters(heavy, light, {}, {.implicit_law = false}).stiffness * 0.4e-3, 5 * g, 1e-12);
}

// 0.5 kPa on the mean face of 0.2 x 0.2 x 0.2 m, if that is more than its weight.
TEST(ContactParametersTest, ALightThingIsNoSofterThanWhatMayStandOnIt) {
  const auto force = [](const ContactParameters& p) { return 4 * p.stiffness * 0.1e-3; };
  expect_weight("crate of 100 g and 20 cm", "4 points, 0.5 kPa", force(contact_parameters(crate_of(0.1), {}, {})), 20,
                1e-12);
  expect_weight("crate of 5 kg and 20 cm", "4 points", force(contact_parameters(crate_of(5), {}, {})), 5 * g, 1e-12);
  expect_weight("crates of 100 and 50 g", "4 points, 0.5 kPa",
                force(contact_parameters(crate_of(0.1), crate_of(0.05), {}, {})), 20, 1e-12);
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
  const Model ball = fixtures::ball_model(0.05, 0.1);
  for (const bool implicit_law : {false, true}) {
    const ContactParameters own = for_explicit_step(contact_parameters(ball, {}, {1e-3, implicit_law}), 1e-3);
    EXPECT_EQ(own.theta, 0);
    EXPECT_NEAR(bounce_in_steps(own, 0.1, 1e-3), 0.5, 0.01) << "it bounces on a spring";
  }
}

// Four points carry it.
TEST(ContactParametersTest, ThingWithoutSoles) {
  const ContactParameters p = contact_parameters(crate_of(2), {}, {1e-3, false});
  expect_weight("crate of 2 kg, explicit law", "4 points", 4 * p.stiffness * 0.4e-3, 2 * g, 1e-13);
  EXPECT_NEAR(p.damping / (2 * std::sqrt(p.stiffness * 2 / 2)), 0.5, 1e-15);
}

// Tolerance: 2 %, of the ends of the bounce, which fall into steps.
TEST(ContactParametersTest, BallBouncesOnASpringInLongSteps) {
  const Model ball = fixtures::ball_model(0.05, 0.1);
  for (const double e : {0.5, 0.8, 0.95}) {
    law::Worst error;
    for (const double dt : {0.5e-3, 1e-3, 2e-3, 5e-3, 10e-3}) {
      const ContactParameters p = contact_parameters(ball, {.restitution = e}, {dt, false});
      error.see(std::abs(bounce_in_steps(p, 0.1, dt) / e - 1), "step [s]", dt);
    }
    law::expect_below({.law = fmt::format("ball, explicit law: relative error of restitution {}, steps of 0.5 to 10 ms",
                                          e),
                       .level = "contact parameters",
                       .source = "the restitution of the pair of materials"},
                      error, 0.02, "");
  }
}

// With short steps the constants of an explicit law are those of the spring: the weight at 0.4 mm, and a restitution of 0.6.
// Tolerance: k dt^2 / m = 2e-8, and its root.
TEST(ContactParametersTest, Ball) {
  const Model ball = fixtures::ball_model(0.05, 0.1);
  const ContactParameters p = contact_parameters(ball, {.restitution = 0.6}, {1e-6, false});
  expect_weight("ball of 0.1 kg, explicit law", "1 point", p.stiffness * 0.4e-3, 0.1 * g, 1e-3);
  law::expect_near({.law = "ball, explicit law: restitution of its damping",
                    .level = "contact parameters",
                    .source = "the restitution of the pair of materials"},
                   restitution(p.damping / (2 * std::sqrt(p.stiffness * 0.1))), 0.6, 1e-3, "");
  const ContactParameters implicit = contact_parameters(ball, {.restitution = 0.6}, {});
  expect_weight("ball of 0.1 kg", "1 point", implicit.stiffness * 0.1e-3, 0.1 * g, 1e-13);
  EXPECT_EQ(implicit.restitution, 0.6);
}

// Rule: the static deflection of the pair, under explicit laws at least 0.4 mm; a stiffness of the pair overrides it.
TEST(ContactParametersTest, WhereTheStiffnessComesFrom) {
  const Model robot = fixtures::two_legged();
  const double usual = contact_parameters(robot, {}, {}).stiffness;
  EXPECT_NEAR(contact_parameters(robot, {.static_deflection = 0.2e-3}, {}).stiffness, usual / 2, 1e-9);
  for (const double deflection : {0.1e-3, 0.4e-3, 0.8e-3}) {
    const PairSurface pair{.static_deflection = deflection};
    EXPECT_NEAR(contact_parameters(robot, pair, {.implicit_law = false}).stiffness,
                usual * 0.1e-3 / std::max(deflection, 0.4e-3), 1e-9);
  }
  const ContactParameters p = contact_parameters(robot, {.stiffness = 5000}, {});
  EXPECT_EQ(p.stiffness, 5000);
  EXPECT_EQ(contact_parameters(robot, {.stiffness = 0.5}, {}).stiffness, 0.5) << "however soft";
  EXPECT_NEAR(p.damping, 2 * std::sqrt(5000 * 3 / 4.0), 1e-11);
}

// Rule: only a single sphere is round; a ball with a box on it is not.
TEST(ContactParametersTest, WhatIsRound) {
  using namespace properties;
  const PairSurface pair{.restitution = 0.9};
  const Model pill("pill", Chain{}.base().with(mass, 0.1).with(shapes, {fixtures::placed(Capsule{0.05, 0.1})}));
  const PlacedShape sphere = fixtures::placed(Sphere{0.05});
  const Model pair_of_balls("pair", Chain{}.base().with(mass, 0.1).with(shapes, {sphere, sphere}));
  EXPECT_LT(contact_parameters(pill, pair, {}).restitution, 0);
  EXPECT_LT(contact_parameters(pair_of_balls, pair, {}).restitution, 0);
  EXPECT_EQ(contact_parameters(fixtures::ball_model(0.05, 0.1), pair, {}).restitution, 0.9);
}

}  // namespace
}  // namespace murosimf::collision
