#include "murosimf/collision/contact_laws/implicit_stick_law.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

/// What the law says while it sticks, with the velocity after the step.
Vec3d sticking_force(const ContactPoint& c, const ContactParameters& p, const Vec3d& next) {
  const double v_n = dot(next, c.normal);
  const Vec3d v_t = next - v_n * c.normal;
  const double f_n = p.stiffness * (c.depth - p.theta * dt * v_n) - p.damping * v_n;
  return f_n * c.normal - p.tangent_stiffness * (c.stretch + dt * v_t) - p.tangent_damping * v_t;
}

constexpr const char* level = "implicit_stick";

// Prepare also projects the memory on the tangent plane. Tolerance: rounding of forces up to 1e3 N.
TEST(ImplicitStickTest, StickingIsLinearInTheVelocityAfterTheStep) {
  const ImplicitStick law;
  Dice dice("stick");
  law::Worst error;
  for (int i = 0; i < 100; ++i) {
    ContactParameters p = parameters();
    p.theta = dice.uniform(0, 1);
    LawCase set = one_point(dice.uniform(1e-4, 1e-2), dice.vector(1), p);
    ContactPoint& c = set.points[0];
    c.normal = dice.unit();
    c.stretch = dice.vector(1e-3);
    set.prepare(law);
    EXPECT_EQ(c.state, ContactState::stick);
    EXPECT_NEAR(dot(c.stretch, c.normal), 0, 1e-18);
    EXPECT_NEAR(c.normal_damping, p.damping + p.theta * dt * p.stiffness, 1e-12);
    EXPECT_NEAR(c.tangent_damping, p.tangent_damping + dt * p.tangent_stiffness, 1e-12);
    const Vec3d next = dice.vector(1);
    error.see(difference(force_after(c, next), sticking_force(c, p, next)), "set", i);
  }
  expect_law(level, "sticking point: error of the force for any velocity after the step",
             "spring and damper at that velocity", error, 1e-12, "N");
}

// Rule: inside the cone a sticking point is accepted as it is.
TEST(ImplicitStickTest, SticksInsideTheCone) {
  const ImplicitStick law;
  LawCase set = one_point(1e-3);
  set.prepare(law);
  set.next_velocity[0] = {0.1, 0, 0};  // tangential force 33 * 0.1 = 3.3 N of mu f_n = 5 N
  EXPECT_TRUE(set.accepted_by(law));
  EXPECT_EQ(set.points[0].state, ContactState::stick);
}

// Rule: outside the cone it slips, and the step must be repeated; the sliding force is mu f_n against the motion.
// Tolerance: rounding.
TEST(ImplicitStickTest, SlipsAtTheCone) {
  const ImplicitStick law;
  for (const auto& [speed, expected] : {std::pair{0.151, ContactState::stick}, std::pair{0.152, ContactState::slip}}) {
    LawCase set = one_point(1e-3);  // f_n = 10 N: the cone is reached at 5 N / 33 N s/m = 0.15152 m/s
    set.prepare(law);
    set.next_velocity[0] = {0.6 * speed, 0.8 * speed, 0};
    EXPECT_EQ(set.accepted_by(law), expected == ContactState::stick);
    EXPECT_EQ(set.points[0].state, expected);
  }
  LawCase set = one_point(1e-3, {0.6, 0.8, 0});
  set.prepare(law);
  set.next_velocity[0] = {0.6, 0.8, 0};
  EXPECT_FALSE(set.accepted_by(law));
  const Vec3d force = force_after(set.points[0], {0.6, 0.8, 0});
  expect_law(level, "sliding point: error of the force", "mu f_n against the motion", difference(force, {-3, -4, 10}),
             1e-14, "N");
  EXPECT_TRUE(set.accepted_by(law));  // the normal force did not move
  // pressed harder by the trial step, 10 N + 60 N s/m * 0.05 m/s, it slides on that force at once
  set = one_point(1e-3, {0.6, 0.8, 0});
  set.prepare(law);
  set.next_velocity[0] = {0.6, 0.8, -0.05};
  EXPECT_FALSE(set.accepted_by(law));
  expect_law(level, "sliding point pressed harder by the trial step: error of the force", "mu f_n against the motion",
             difference(force_after(set.points[0], {0.6, 0.8, -0.05}), {-3.9, -5.2, 13}), 1e-14, "N");
}

// Rule: a point never pulls: it opens where its force would be negative, feels nothing then, and is accepted.
TEST(ImplicitStickTest, OpensWhereItWouldPull) {
  const ImplicitStick law;
  LawCase set = one_point(1e-3);
  set.prepare(law);
  set.next_velocity[0] = {0, 0, 0.16};  // 10 N - 60 N s/m * 0.16 m/s = 0.4 N: just pushing
  EXPECT_TRUE(set.accepted_by(law));
  set.next_velocity[0] = {0, 0, 0.17};  // -0.2 N
  EXPECT_FALSE(set.accepted_by(law));
  const ContactPoint& c = set.points[0];
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.force), 0);
  EXPECT_EQ(c.normal_damping, 0);
  EXPECT_EQ(c.tangent_damping, 0);
  EXPECT_TRUE(set.accepted_by(law));
  // and closes again, to stick, if the next trial comes back
  set.next_velocity[0] = {0, 0, 0.1};
  EXPECT_FALSE(set.accepted_by(law));
  EXPECT_EQ(c.state, ContactState::stick);
  EXPECT_GT(dot(c.force, c.normal), 0);
  EXPECT_TRUE(set.accepted_by(law));
}

// Rule: an open point feels no rolling resistance either: there is no normal force that could cause it.
TEST(ImplicitStickTest, OpenPointDoesNotRoll) {
  const ImplicitStick law;
  LawCase set = rolling_point();
  ContactPoint& c = set.points[0];
  set.prepare(law);
  EXPECT_LT(c.moment.y, 0);
  set.next_velocity[0] = {0, 0, 1};
  EXPECT_FALSE(set.accepted_by(law));
  ASSERT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.moment), 0);
  EXPECT_EQ(c.angular_damping, 0);
}

// Fov forgets. Tolerance: rounding.
TEST(ImplicitStickTest, CommitStickAndOpen) {
  const ImplicitStick law;
  LawCase set = one_point(1e-3);
  ContactPoint& c = set.points[0];
  c.stretch = {1e-4, 0, 0};
  set.prepare(law);
  set.next_velocity[0] = {0.01, -0.02, 0.1};
  ASSERT_TRUE(set.accepted_by(law));
  set.commit(law);
  expect_law(level, "memory of a sticking point: error of the stretch after one step", "grows by dt v_t",
             difference(c.stretch, {1.1e-4, -0.2e-4, 0}), 1e-18, "m");
  EXPECT_NEAR(c.last_normal_force, 10 - 60 * 0.1, 1e-14);

  set.prepare(law);
  set.next_velocity[0] = {0, 0, 1};
  ASSERT_FALSE(set.accepted_by(law));
  set.commit(law);
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.stretch), 0);
  EXPECT_EQ(c.last_normal_force, 0);
  set.prepare(law);  // in the next step it starts anew
  EXPECT_EQ(c.state, ContactState::stick);
}

// The spring holds it F / kt away; after it has settled its place does not change at all. Tolerance: for the place, the
// transient's rest after 2 s (decay rate ct / 2m = 12.5 /s); for the creep 1e-13 m in one second.
TEST(ImplicitStickTest, NoCreepBelowTheCone) {
  const ImplicitStick law;
  Block block = resting_block({4.5, 0, 0});
  for (int i = 0; i < 4000; ++i) block.step(law);
  const Vec3d place = block.position;
  for (int i = 0; i < 1000; ++i) block.step(law);
  expect_law(level, "block pushed with 0.9 mu m g: creep in 1 s", "Coulomb: it sticks",
             difference(block.position, place), 1e-13, "m");
  EXPECT_LT(norm(block.velocity), 1e-12);
  EXPECT_EQ(block.point().state, ContactState::stick);
  expect_law(level, "block pushed with 0.9 mu m g: error of the contact force", "it balances push and weight",
             difference(block.contact_force, {-4.5, 0, 10}), 1e-9, "N");
}

// Tolerance: the first step sticks until the spring is stretched (0.6 mm), then the implicit step is exact in the
// force.
TEST(ImplicitStickTest, SlidesAboveTheCone) {
  const ImplicitStick law;
  Block block = resting_block({7, 0, 0});
  for (int i = 0; i < 500; ++i) block.step(law);
  const double before = block.velocity.x;
  law::Worst error;
  for (int i = 0; i < 500; ++i) {
    block.step(law);
    error.see(std::abs(norm(tangential(block.contact_force, Vec3d{0, 0, 1})) - 5), "step", i);
  }
  EXPECT_EQ(block.point().state, ContactState::slip);
  expect_law(level, "block pushed with 1.4 mu m g: error of the friction", "mu m g: it is on the cone", error, 1e-8,
             "N");
  law::expect_near({.law = "block pushed with 1.4 mu m g: acceleration", .level = level, .source = "F / m - mu g"},
                   (block.velocity.x - before) / 0.5, 2.0, 1e-8, "m/s^2");
}

// Then it rests: no creep, no bouncing back beyond the spring's stretch. Tolerance: one step's way (1 mm) plus the
// stretch (0.6 mm).
TEST(ImplicitStickTest, StoppingDistance) {
  const ImplicitStick law;
  Block block = resting_block({});
  block.velocity = {1, 0, 0};
  for (int i = 0; i < 3000; ++i) {
    block.step(law);
    ASSERT_LE(block.passes, max_passes);
  }
  law::expect_near({.law = "block slides to rest: way", .level = level, .source = "v^2 / (2 mu g)"}, block.position.x,
                   1 / (2 * 0.5 * 10), 1.6e-3, "m");
  EXPECT_LT(norm(block.velocity), 1e-6);
  EXPECT_EQ(block.point().state, ContactState::stick);
}

// Also in the very first step: a rejected sticking trial must not lend its normal force. Tolerance: the 5 % at which it
// is renewed.
TEST(ImplicitStickTest, FrictionAtFirstTouch) {
  const ImplicitStick law;
  Block block = resting_block({});
  block.position.z = -1e-6;
  block.velocity = {1, 0, -0.2};
  law::Worst error;
  for (int i = 0; i < 20; ++i) {
    block.step(law);
    const double f_n = block.contact_force.z;
    if (block.point().state != ContactState::slip || f_n < 0.1) continue;
    error.see(std::abs(norm(tangential(block.contact_force, Vec3d{0, 0, 1})) / (0.5 * f_n) - 1), "step", i);
  }
  expect_law(level, "block lands while it slides: relative error of the friction", "mu times the pressing force", error,
             0.05, "");
  EXPECT_EQ(block.point().state, ContactState::slip);
}

// Of the spring's force k * depth, and linear in the rate after the step.
TEST(ImplicitStickTest, RollingResistance) {
  const ImplicitStick law;
  LawCase set = rolling_point();
  ContactPoint& c = set.points[0];
  set.prepare(law);
  expect_law(level, "rolling resistance: error of the moment", "rolling * radius * k * depth against the rotation",
             difference(c.moment, {0, -0.03 * 0.05 * 10, 0}), 1e-17, "N m");
  EXPECT_NEAR(c.angular_damping, 0.03 * 0.05 * 10 / 10, 1e-17);
}

// Rule: every point has its own constants and its own state.
TEST(ImplicitStickTest, PointsAreIndependent) {
  const ImplicitStick law;
  LawCase set = one_point(1e-3);
  set.points.resize(3, set.points[0]);
  set.next_velocity.resize(3);
  set.terms.parameters.push_back(parameters());
  set.terms.parameters[1].friction = 0.01;
  set.points[1].surface = 1;
  set.prepare(law);
  set.next_velocity = {{0.1, 0, 0}, {0.1, 0, 0}, {0, 0, 1}};
  EXPECT_FALSE(set.accepted_by(law));
  EXPECT_EQ(set.points[0].state, ContactState::stick);
  EXPECT_EQ(set.points[1].state, ContactState::slip);
  EXPECT_EQ(set.points[2].state, ContactState::open);
}

}  // namespace
}  // namespace murosimf::collision
