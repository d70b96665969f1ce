#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

const KelvinVoigt law;
constexpr const char* level = "kelvin_voigt";

// At the beginning of the step. In numbers: 10 N + 50 N s/m * 0.1 m/s, and
// 8e3 N/m * 0.1 mm + 25 N s/m * 0.02 m/s. Tolerance: rounding.
TEST(KelvinVoigtTest, SpringAndDamper) {
  LawCase set = one_point(1e-3, {0.02, 0, -0.1});
  ContactPoint& c = set.points[0];
  c.stretch = {0, 1e-4, 0};
  set.prepare(law);
  EXPECT_EQ(c.state, ContactState::stick);
  expect_law(level, "sticking point: error of the force", "k depth - d v_n and -kt s - ct v_t",
             difference(c.force, {-0.5, -0.8, 15}), 1e-14, "N");
}

// Rule: the law is explicit: no damping is handed to motion, and every trial is accepted as it is.
TEST(KelvinVoigtTest, IsExplicit) {
  LawCase set = rolling_point({1, 0, 0});
  ContactPoint& c = set.points[0];
  c.normal_damping = c.tangent_damping = c.angular_damping = 7;
  set.prepare(law);
  EXPECT_EQ(c.normal_damping, 0);
  EXPECT_EQ(c.tangent_damping, 0);
  EXPECT_EQ(c.angular_damping, 0);
  expect_law(level, "rolling resistance: error of the moment", "rolling * radius * f_n against the rotation",
             difference(c.moment, {0, -0.03 * 0.05 * 10, 0}), 1e-17, "N m");
  const Vec3d force = c.force;
  set.next_velocity[0] = {100, 0, 100};
  EXPECT_TRUE(set.accepted_by(law));
  set.commit(law);
  EXPECT_EQ(difference(c.force, force), 0) << "what acted does not depend on what came of it";
}

// Rule: a point never pulls; where it would, it opens and forgets.
TEST(KelvinVoigtTest, OpensWhereItWouldPull) {
  LawCase set = rolling_point({0.1, 0, 0.21});
  ContactPoint& c = set.points[0];
  c.stretch = {1e-4, 0, 0};
  set.prepare(law);
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.force), 0);
  EXPECT_EQ(norm(c.moment), 0);
  set.next_velocity[0] = {0.3, -0.2, 0.21};
  set.commit(law);
  EXPECT_EQ(norm(c.stretch), 0) << "wherever it goes meanwhile";
}

// For any normal, velocity and memory. Tolerance: rounding of forces up to 1e2 N.
TEST(KelvinVoigtTest, FrictionStaysInTheCone) {
  Dice dice("kelvin voigt");
  law::Worst pressing, beyond, aside;
  int slipped = 0;
  for (int i = 0; i < 200; ++i) {
    LawCase set = one_point(2e-3, dice.vector(0.3));
    ContactPoint& c = set.points[0];
    c.normal = dice.unit();
    c.stretch = dice.vector(1e-3);
    set.prepare(law);
    if (c.state == ContactState::open) continue;
    const ContactParameters p = parameters();
    const double f_n = dot(c.force, c.normal);
    const Vec3d f_t = tangential(c.force, c.normal);
    pressing.see(std::abs(f_n - (p.stiffness * c.depth - p.damping * dot(c.velocity, c.normal))), "set", i);
    beyond.see(norm(f_t) - p.friction * f_n, "set", i);
    const Vec3d spring = -p.tangent_stiffness * c.stretch - p.tangent_damping * tangential(c.velocity, c.normal);
    aside.see(norm(cross(f_t, spring)), "set", i);
    EXPECT_GE(dot(f_t, spring), 0);
    slipped += c.state == ContactState::slip;
  }
  expect_law(level, "any point: error of the force along the normal", "k depth - d v_n", pressing, 1e-12, "N");
  expect_law(level, "any point: how far friction is out of its cone", "at most mu f_n", beyond, 1e-12, "N");
  expect_law(level, "any point: friction times spring's force, as vectors", "parallel", aside, 1e-10, "N^2");
  EXPECT_GT(slipped, 20);
  EXPECT_LT(slipped, 180);
}

// Tolerance: rounding.
TEST(KelvinVoigtTest, ConeDependsOnTheGrain) {
  ContactParameters p = parameters();
  p.friction_direction = {0.2, 0, 0};
  law::Worst error;
  for (const auto& [v, expected] : friction_direction_cases) {
    LawCase set = one_point(1e-3, v, p);
    set.prepare(law);
    error.see(difference(tangential(set.points[0].force, Vec3d{0, 0, 1}), expected), "along", v.x, v.y);
  }
  expect_law(level, "sliding on friction_direction 0.2 along, across and against it: error of the friction",
             "mu (1 - friction_direction . d) f_n against the motion", error, 1e-14, "N");
}

// Tolerance: rounding.
TEST(KelvinVoigtTest, CommitStick) {
  LawCase set = one_point(1e-3);
  ContactPoint& c = set.points[0];
  c.stretch = {1e-4, 0, 0};
  set.prepare(law);
  set.next_velocity[0] = {0.01, -0.02, 0.1};
  set.commit(law);
  expect_law(level, "memory of a sticking point: error of the stretch after one step", "grows by dt v_t",
             difference(c.stretch, {1.1e-4, -0.2e-4, 0}), 1e-18, "m");
}

// The spring then moves on from there: a steady slide stays on the cone in every step. Tolerance: rounding.
TEST(KelvinVoigtTest, CommitSlipReturnsToTheCone) {
  const ContactParameters p = parameters();
  const Vec3d v{0.3, -0.1, 0};
  LawCase set = one_point(1e-3, v);
  ContactPoint& c = set.points[0];
  c.stretch = {5e-3, 0, 0};
  set.prepare(law);
  ASSERT_EQ(c.state, ContactState::slip);
  const Vec3d friction = tangential(c.force, c.normal);
  set.next_velocity[0] = v;
  set.commit(law);
  const Vec3d before = c.stretch - dt * v;
  expect_law(level, "memory of a sliding point: error of its force if it stuck",
             "return mapping: -kt s - ct v_t is the sliding force",
             difference(-p.tangent_stiffness * before - p.tangent_damping * v, friction), 1e-13, "N");
  set.prepare(law);
  EXPECT_EQ(c.state, ContactState::slip);
}

// It stays where its spring holds it. Tolerance: for the place the transient's rest after 4 s (decay rate ct / 2m =
// 12.5 /s); for the creep 1e-13 m in one second.
TEST(KelvinVoigtTest, NoCreepBelowTheCone) {
  Block block = resting_block({4.5, 0, 0});
  for (int i = 0; i < 4000; ++i) block.step(law);
  const Vec3d place = block.position;
  for (int i = 0; i < 1000; ++i) block.step(law);
  expect_law(level, "block pushed with 0.9 mu m g: creep in 1 s", "Coulomb: it sticks",
             difference(block.position, place), 1e-13, "m");
  EXPECT_EQ(block.point().state, ContactState::stick);
  expect_law(level, "block pushed with 0.9 mu m g: error of the contact force", "it balances push and weight",
             difference(block.contact_force, {-4.5, 0, 10}), 1e-9, "N");
}

// It is on the cone in every step.
TEST(KelvinVoigtTest, SlidesAboveTheCone) {
  Block block = resting_block({7, 0, 0});
  for (int i = 0; i < 500; ++i) block.step(law);
  const double before = block.velocity.x;
  for (int i = 0; i < 500; ++i) {
    block.step(law);
    ASSERT_EQ(block.point().state, ContactState::slip);
  }
  law::expect_near({.law = "block pushed with 1.4 mu m g: acceleration", .level = level, .source = "F / m - mu g"},
                   (block.velocity.x - before) / 0.5, 2.0, 1e-8, "m/s^2");
}

}  // namespace
}  // namespace murosimf::collision
