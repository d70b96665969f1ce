#include "murosimf/collision/contact_laws/body_explicit_laws.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

constexpr const char* level = "body contact, paper";

/// Two unequal balls, B moves and turns too. s_c = 1e4 N/m, s_b = 0.4, s_mu = 5 s/m, s_nu = 0.01 m s.
struct TwoBalls {
  TwoBalls() {
    Movers::launch(movers.add("a", ball(0.05, 0.3)), {0.3, -0.5, -0.4}, {1, 2, -3});
    Movers::launch(movers.add("b", ball(0.12, 2.0), {0, 0, -0.17}), {0, 0.1, 0.2}, {-1, 0.5, 2});
    ContactParameters pair = parameters();
    pair.rebound = 0.4;
    pair.viscous_friction = 5;
    pair.spin_friction = 0.01;
    movers.set.parameters = {pair};
  }
  /// One more point, of the first body of either, with the velocities that these have there.
  PairContact& touch(const Vec3d& point, double depth) {
    PairContact c = joint_of(0, 1);
    c.point = point;
    c.normal = {0, 0, 1};
    c.depth = depth;
    c.feature = movers.set.points.size();
    c.velocity = a().velocity_at(0, point - a().r[0]) - b().velocity_at(0, point - b().r[0]);
    return movers.set.points.emplace_back(c);
  }
  void push(const PaperLawOptions& options) {
    BodyPaperLaw law(options);
    movers.start_step();
    law.push(movers.all, movers.set, dt, movers.serial);
  }
  MovingEntity& a() { return movers.all[0]; }
  MovingEntity& b() { return movers.all[1]; }
  Movers movers;
};

const PaperLawOptions literal{.bounded = false};

// By the letter, approaching and separating; what B feels is the opposite. Tolerance: rounding of 20 N.
TEST(BodyPaperLaw, Equations4And5) {
  const Vec3d w{2, 1.5, -5};
  for (const double upwards : {-0.6, 0.6}) {
    TwoBalls balls;
    Movers::launch(balls.a(), {0.3, -0.5, 0.2 + upwards}, {1, 2, -3});
    PairContact& c = balls.touch({0, 0, -0.05}, 2e-3);
    const Vec3d v = c.velocity;
    ASSERT_EQ(v.z < 0, upwards < 0);
    balls.push(literal);
    const double f_n = upwards < 0 ? 20 : 8;
    const std::string when = upwards < 0 ? "approaching" : "separating";
    expect_law(level, when + " bodies: error of the force", "eq. (4), (5): (s_b) s_c depth n - s_mu |f_n| v_t",
               difference(c.force, Vec3d{-5 * f_n * v.x, -5 * f_n * v.y, f_n}), 1e-13, "N");
    expect_law(level, when + " bodies: error of the moment", "eq. (5): -s_nu |f_n| w",
               difference(c.moment, (-0.01 * f_n) * w), 1e-13, "N m");
    const Wrenchd at_a = balls.a().interaction_force[0], at_b = balls.b().interaction_force[0];
    EXPECT_LT(difference(at_a.f, c.force), 1e-13);
    EXPECT_LT(difference(at_a.n, cross(Vec3d{0, 0, -0.05}, c.force) + c.moment), 1e-13);
    EXPECT_LT(difference(at_b.f, -c.force), 1e-13);
    EXPECT_LT(difference(at_b.n, cross(Vec3d{0, 0, 0.12}, -c.force) - c.moment), 1e-13);
  }
}

// Bounded: c / (1 + dt c S) with S = sum of 1/m + r^2/J, where J = 0.4 m r^2, of both: 3.5 / m; about an axis 1/J.
TEST(BodyPaperLaw, BoundedDampersAreThoseOfTheClosedForm) {
  TwoBalls balls;
  PairContact& c = balls.touch({0, 0, -0.05}, 2e-3);
  const Vec3d v = c.velocity;
  balls.push({.friction = 200, .spin_friction = 3});
  const double rub = 200 * 20 / (1 + dt * 200 * 20 * (3.5 / 0.3 + 3.5 / 2.0));
  const double turns = 1 / (0.4 * 0.3 * 0.0025) + 1 / (0.4 * 2.0 * 0.0144);
  const double spin = 3 * 20 / (1 + dt * 3 * 20 * turns);
  expect_law(level, "bounded friction of two balls: relative error", "c / (1 + dt c S), S = 7/2 (1/m_a + 1/m_b)",
             difference(c.force, {-rub * v.x, -rub * v.y, 20}) / norm(c.force), 1e-14, "");
  expect_law(level, "bounded moment of two balls: relative error", "c / (1 + dt c S), S = 1/J_a + 1/J_b",
             difference(c.moment, -spin * Vec3d{2, 1.5, -5}) / norm(c.moment), 1e-14, "");
}

/// [J] of both, if these forces act for one step.
double energy_after(TwoBalls& balls, double seconds) {
  double sum = 0;
  for (MovingEntity* ball : {&balls.a(), &balls.b()}) {
    const double mass = ball->model().tree().mass, inertia = ball->model().tree().links[0].inertia.xx;
    const Wrenchd f = ball->interaction_force[0];
    const Vec3d v = ball->v[0] + (seconds / mass) * f.f, w = ball->w[0] + (seconds / inertia) * f.n;
    sum += 0.5 * mass * dot(v, v) + 0.5 * inertia * dot(w, w);
  }
  return sum;
}

/// Energy [J] that friction alone gives in a step: its own, without the spring's.
double given_by_friction(const PaperLawOptions& options, Dice& dice) {
  TwoBalls balls;
  Movers::launch(balls.a(), dice.vector(1), dice.vector(10));
  for (int i = 0; i < 5; ++i) balls.touch({dice.uniform(-0.04, 0.04), dice.uniform(-0.04, 0.04), -0.05}, 5e-3);
  balls.push(options);
  for (const PairContact& c : balls.movers.set.points) {
    balls.a().push(0, c.point, -dot(c.force, c.normal) * c.normal, dt);
    balls.b().push(0, c.point, dot(c.force, c.normal) * c.normal, dt);
  }
  return energy_after(balls, dt) - energy_after(balls, 0);
}

// However hard five points rub at the same time: s_mu of 1000 s/m and s_nu of 10 m s at 50 N each.
TEST(BodyPaperLaw, BoundedFrictionNeverAddsEnergy) {
  Dice dice("rubbing");
  law::Worst given;
  double by_the_letter = 0;
  const PaperLawOptions hard{.friction = 1000, .spin_friction = 10, .one_point_per_body = false};
  PaperLawOptions hard_literal = hard;
  hard_literal.bounded = false;
  for (int i = 0; i < 200; ++i) {
    given.see(given_by_friction(hard, dice), "case", i);
    by_the_letter = std::max(by_the_letter, given_by_friction(hard_literal, dice));
  }
  expect_law(level, "five points that rub hard, 200 cases: most energy that friction gives in a step",
             "bounded: none (effective_mass.h)", given, 1e-12, "J");
  EXPECT_GT(by_the_letter, 100) << "by the letter it explodes";
}

// Rule: one point for two bodies, the deepest; the multipoint law keeps all.
TEST(BodyPaperLaw, OnePointOrAll) {
  for (const bool one : {true, false}) {
    TwoBalls balls;
    for (const double depth : {1e-3, 3e-3, 2e-3}) balls.touch({0, 0, -0.05}, depth);
    PaperLawOptions options = literal;
    options.one_point_per_body = one;
    balls.push(options);
    const auto& left = balls.movers.set.points;
    ASSERT_EQ(left.size(), one ? 1U : 3U);
    EXPECT_EQ(left[0].feature, one ? 1U : 0U);
    Vec3d sum;
    for (const PairContact& c : left) sum += c.force;
    EXPECT_LT(difference(balls.a().interaction_force[0].f, sum), 1e-13);
  }
}

// What cannot be pushed feels nothing; its ledger takes what it should have felt, moments too.
TEST(BodyPaperLaw, LedgerTakesTheMoment) {
  TwoBalls balls;
  Movers::stand_fast(balls.b());
  PairContact& c = balls.touch({0, 0, -0.05}, 2e-3);
  balls.push({});
  EXPECT_TRUE(is_zero(balls.b().interaction_force[0]));
  EXPECT_LT(difference(balls.b().ledger[0].f, -dt * c.force), 1e-15);
  EXPECT_LT(difference(balls.b().ledger[0].n, -dt * (cross(c.point, c.force) + c.moment)), 1e-15);
  EXPECT_GT(norm(c.moment), 0.01);
}

}  // namespace
}  // namespace murosimf::collision
