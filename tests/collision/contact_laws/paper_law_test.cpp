#include "murosimf/collision/contact_laws/paper_law.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

constexpr const char* level = "paper";

// In numbers: s_c = 1e4 N/m, depth 2 mm, s_b = 0.4, s_mu = 5 s/m, s_nu = 0.01 m s. Tolerance: rounding.
TEST(PaperLawTest, Equations4And5) {
  const PaperLaw law({.rebound = 0.4, .friction = 5, .spin_friction = 0.01});
  LawCase set = one_point(2e-3, {0.1, -0.2, -0.3});
  ContactPoint& c = set.points[0];
  c.angular_velocity = {1, 2, 3};
  set.prepare(law);
  expect_law(level, "approaching point: error of the force", "eq. (4), (5): s_c depth n - s_mu |f_n| v_t",
             difference(c.force, {-5 * 20 * 0.1, 5 * 20 * 0.2, 20}), 1e-14, "N");
  expect_law(level, "approaching point: error of the moment", "eq. (5): -s_nu |f_n| w",
             difference(c.moment, {-0.2, -0.4, -0.6}), 1e-15, "N m");

  c.velocity.z = 0.3;
  set.prepare(law);
  expect_law(level, "separating point: error of the force", "eq. (4), (5): s_b s_c depth n - s_mu |f_n| v_t",
             difference(c.force, {-5 * 8 * 0.1, 5 * 8 * 0.2, 8}), 1e-14, "N");
  expect_law(level, "separating point: error of the moment", "eq. (5): -s_nu |f_n| w",
             difference(c.moment, {-0.08, -0.16, -0.24}), 1e-15, "N m");
}

// Rule: the numbers are those of the pair of materials, and those of an option that is given.
TEST(PaperLawTest, NumbersAreThoseOfThePairUnlessGiven) {
  ContactParameters pair = parameters();
  pair.rebound = 0.2;
  pair.viscous_friction = 3;
  pair.spin_friction = 0.05;
  LawCase set = one_point(2e-3, {0.1, 0, 0.3}, pair);
  ContactPoint& c = set.points[0];
  c.angular_velocity = {0, 0, 2};
  set.prepare(PaperLaw());
  EXPECT_LT(difference(c.force, {-3 * 4 * 0.1, 0, 4}), 1e-14);
  EXPECT_LT(difference(c.moment, {0, 0, -0.05 * 4 * 2}), 1e-14);
  set.prepare(PaperLaw({.rebound = 0.5, .friction = 0, .spin_friction = 0.1}));
  EXPECT_LT(difference(c.force, {0, 0, 10}), 1e-14);
  EXPECT_LT(difference(c.moment, {0, 0, -0.1 * 10 * 2}), 1e-14);
}

// Rule: by the letter the law is explicit: no damping is handed to motion, and every trial is accepted as it is.
TEST(PaperLawTest, IsExplicitByTheLetter) {
  const PaperLaw law({.bounded = false});
  LawCase set = one_point(1e-3, {1, 0, 0});
  set.points[0].normal_damping = set.points[0].tangent_damping = set.points[0].angular_damping = 7;
  set.prepare(law);
  EXPECT_EQ(set.points[0].normal_damping, 0);
  EXPECT_EQ(set.points[0].tangent_damping, 0);
  EXPECT_EQ(set.points[0].angular_damping, 0);
  set.next_velocity[0] = {100, 0, 100};
  const Vec3d before = set.points[0].force;
  EXPECT_TRUE(set.accepted_by(law));
  set.commit(law);
  EXPECT_EQ(difference(set.points[0].force, before), 0);
}

/// Speed along x after one step of a block of `mass` [kg] at 1 m/s that is pressed down with 50 N, with s_mu = 20 s/m.
double speed_after_a_step(double mass, bool bounded) {
  Block block(parameters());
  block.mass = mass;
  block.position.z = -50 / parameters().stiffness;
  block.push.z = -50;
  block.velocity = {1, 0, -1e-12};  // it approaches
  block.step(PaperLaw({.friction = 20, .bounded = bounded}));
  return block.velocity.x;
}

// With x = dt s_mu f_n / m: 1 / (1 + x) bounded, 1 - x by the letter, which turns back beyond 1 and grows beyond 2.
TEST(PaperLawTest, BoundedFrictionTakesTheVelocityAfterTheStep) {
  law::Worst error, literal;
  for (const double mass : {4.0, 0.5, 0.1}) {
    const double x = 1e-3 * 20 * 50 / mass;
    error.see(std::abs(speed_after_a_step(mass, true) - 1 / (1 + x)), "mass", mass);
    literal.see(std::abs(speed_after_a_step(mass, false) - (1 - x)), "mass", mass);
  }
  expect_law("paper", "block on viscous friction: error of its speed after a step",
             "bounded: v / (1 + dt s_mu f_n / m)", error, 1e-12, "m/s");
  expect_law("paper", "block on viscous friction, by the letter: error of its speed after a step",
             "explicit: v (1 - dt s_mu f_n / m)", literal, 1e-12, "m/s");
  EXPECT_LT(speed_after_a_step(0.1, false), -1) << "by the letter it would be faster than before";
}

// What acted in the step is reported: the friction of the velocity at its end.
TEST(PaperLawTest, CommitsTheFrictionThatActed) {
  const PaperLaw law({.friction = 20});
  LawCase set = one_point(5e-3, {1, 0, -0.1});
  set.prepare(law);
  set.next_velocity[0] = {0.25, 0.1, 3};
  set.commit(law);
  EXPECT_LT(difference(set.points[0].force, {-20 * 50 * 0.25, -20 * 50 * 0.1, 50}), 1e-11);
}

// The normal may point anywhere. Tolerance: rounding of forces up to 200 N.
TEST(PaperLawTest, FrictionIsTangential) {
  const PaperLaw law({.rebound = 0.4, .friction = 5, .spin_friction = 0.01});
  Dice dice("paper law");
  law::Worst error;
  for (int i = 0; i < 50; ++i) {
    LawCase set = one_point(2e-3, dice.vector(1));
    ContactPoint& c = set.points[0];
    c.normal = dice.unit();
    set.prepare(law);
    const double f_n = dot(c.velocity, c.normal) < 0 ? 20 : 8;
    error.see(std::abs(dot(c.force, c.normal) - f_n), "normal", i);
    EXPECT_LE(dot(tangential(c.force, c.normal), c.velocity), 0);
  }
  expect_law(level, "any normal: error of the force along it", "friction has no part along the normal", error, 1e-13,
             "N");
}

/// Seven points of three bodies; point i has feature i.
LawCase seven_points() {
  LawCase set = one_point(0);
  set.points.resize(7, set.points[0]);
  const int objects[] = {4, 4, 9, 4, 9, 2, 2};
  const double depths[] = {1, 3, 5, 2, 4, 6, 7};
  for (std::size_t i = 0; i < 7; ++i) {
    set.points[i].object = objects[i];
    set.points[i].depth = 1e-3 * depths[i];
    set.points[i].feature = static_cast<std::uint32_t>(i);
  }
  return set;
}

// Rule: one point per body, the deepest.
TEST(PaperLawTest, KeepsTheDeepestPointOfEveryBody) {
  const PaperLaw law;
  LawCase set = seven_points();
  set.prepare(law);
  ASSERT_EQ(set.points.size(), 3u);
  const std::pair<int, std::uint32_t> expected[] = {{4, 1}, {9, 2}, {2, 6}};  // object, feature
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(set.points[i].object, expected[i].first);
    EXPECT_EQ(set.points[i].feature, expected[i].second);
    EXPECT_GT(norm(set.points[i].force), 0);
  }
}

// Rule: with all points, each feels what it would feel alone.
TEST(PaperLawTest, KeepsAllPointsIfAsked) {
  const PaperLaw law({.one_point_per_body = false});
  LawCase set = seven_points();
  set.prepare(law);
  ASSERT_EQ(set.points.size(), 7u);
  for (const ContactPoint& c : set.points) {
    LawCase alone = one_point(c.depth);
    alone.prepare(law);
    EXPECT_GT(norm(c.force), 0);
    EXPECT_EQ(difference(c.force, alone.points[0].force), 0);
  }
}

}  // namespace
}  // namespace murosimf::collision
