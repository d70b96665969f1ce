// The default law where points slide: force, derivative, direction, and what is remembered.
#include "murosimf/collision/contact_laws/implicit_stick_law.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

constexpr const char* level = "implicit_stick";

/// A point that slides with `velocity`, pressed with 10 N, and slid along x before.
LawCase sliding_point(const Vec3d& velocity) {
  LawCase set = one_point(1e-3, velocity);
  ContactPoint& c = set.points[0];
  c.state = ContactState::slip;
  c.slip_direction = {1, 0, 0};
  c.last_normal_force = 10;
  return set;
}

// Value and derivative, along and across. Tolerance: differences of 1e-6 m/s err by the third derivative, 5 N * 1e-12 /
// |v|^3.
TEST(ImplicitStickSliding, SlidingIsTheTangentOfCoulomb) {
  const ImplicitStick law;
  const Vec3d v{0.3, -0.4, 0};
  LawCase set = sliding_point(v);
  const ContactPoint& c = set.points[0];
  set.prepare(law);
  const auto coulomb = [](const Vec3d& u) { return (-5 / norm(u)) * u; };
  expect_law(level, "linearized sliding: error of the friction", "-mu f_n v / |v|",
             difference(tangential(c.force, c.normal), coulomb(v)), 1e-14, "N");
  law::Worst error;
  const double h = 1e-6;
  for (const Vec3d& d : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0.6, -0.8, 0}, Vec3d{0.8, 0.6, 0}}) {
    const Vec3d slope = (0.5 / h) * (coulomb(v + h * d) - coulomb(v - h * d));
    const Vec3d given = (0.5 / h) * (force_after(c, v + h * d) - force_after(c, v - h * d));
    error.see(difference(given, slope), "along", d.x, d.y);
  }
  expect_law(level, "linearized sliding: error of the friction's derivative", "central differences of -mu f_n v / |v|",
             error, 1e-8, "N s/m");
}

// Rule: slower than 5 mm/s the direction of sliding is not trusted: the last known one stays, the friction along it is
// mu f_n, and what goes across is damped as at 5 mm/s. Tolerance: rounding.
TEST(ImplicitStickSliding, SlowSlidingKeepsItsDirection) {
  const ImplicitStick law;
  LawCase set = sliding_point({0, 0.004, 0});
  ContactPoint& c = set.points[0];
  set.prepare(law);
  EXPECT_EQ(difference(c.slip_direction, {1, 0, 0}), 0);
  EXPECT_LT(difference(tangential(c.force, c.normal), {-5, -5 * 0.004 / 0.005, 0}), 1e-14);
  EXPECT_NEAR(c.tangent_damping, 5 / 0.005, 1e-12);
  c.velocity = {0, 0.006, 0};
  set.prepare(law);
  EXPECT_EQ(difference(c.slip_direction, {0, 1, 0}), 0);
  EXPECT_LT(difference(tangential(c.force, c.normal), {0, -5, 0}), 1e-14);
  EXPECT_NEAR(c.tangent_damping, 5 / 0.006, 1e-11);
}

// Rule: friction that would push along the motion means that the point has come to rest: slip becomes stick.
TEST(ImplicitStickSliding, SlipBecomesStickAtRest) {
  const ImplicitStick law;
  LawCase set = sliding_point({0.003, 0, 0});
  const ContactPoint& c = set.points[0];
  set.prepare(law);
  set.next_velocity[0] = {0.001, 0, 0};  // still forwards, friction backwards
  EXPECT_TRUE(set.accepted_by(law));
  set.next_velocity[0] = {-0.001, 0, 0};  // friction has turned it round
  EXPECT_FALSE(set.accepted_by(law));
  EXPECT_EQ(c.state, ContactState::stick);
}

// Rule: a sliding force follows the normal force: it is renewed if that moved by more than 5 %.
TEST(ImplicitStickSliding, SlidingFollowsTheNormalForce) {
  const ImplicitStick law;
  LawCase set = sliding_point({1, 0, 0});
  const ContactPoint& c = set.points[0];
  set.prepare(law);
  set.next_velocity[0] = {1, 0, -0.4 / 60};  // 10.4 N
  EXPECT_TRUE(set.accepted_by(law));
  set.next_velocity[0] = {1, 0, -5.0 / 60};  // 15 N
  EXPECT_FALSE(set.accepted_by(law));
  EXPECT_NEAR(norm(tangential(force_after(c, {1, 0, 0}), c.normal)), 7.5, 1e-12);
  EXPECT_TRUE(set.accepted_by(law));
}

// Along the normal the law stays that of a sticking point: k (depth - theta dt v_n+) - d v_n+, 10 N - 60 N s/m v_n+.
TEST(ImplicitStickSliding, SlidingIsLinearAlongTheNormal) {
  const ImplicitStick law;
  LawCase set = sliding_point({0.3, -0.4, 0.02});
  set.prepare(law);
  for (const double next : {-0.1, 0.05}) {
    EXPECT_NEAR(force_after(set.points[0], {0.3, -0.4, next}).z, 10 - 60 * next, 1e-13) << next;
  }
}

// Rule: where it is too slow to tell the direction, it slides the way that the spring lets go: here from rest along -y.
TEST(ImplicitStickSliding, BeginsToSlideAlongTheForceThatDidNotHold) {
  const ImplicitStick law;
  LawCase set = one_point(1e-3);
  const ContactPoint& c = set.points[0];
  set.prepare(law);
  set.next_velocity[0] = {0, -0.3, 0};  // 33 N s/m * 0.3 m/s = 9.9 N, of which the cone has 5 N
  ASSERT_FALSE(set.accepted_by(law));
  ASSERT_EQ(c.state, ContactState::slip);
  EXPECT_LT(difference(c.slip_direction, {0, -1, 0}), 1e-15);
  EXPECT_LT(difference(c.force, {0, 5, 10}), 1e-14);
}

// Rule: the normal force of the pass before counts, whatever it was; if there was none, there is no friction in this pass: what the
// spring and the damper make of the velocity before it would throw a light foot back.
TEST(ImplicitStickSliding, SlidesOnTheNormalForceOfThePassBefore) {
  const ImplicitStick law;
  for (const auto& [before, friction] : {std::pair{0.0, 0.0}, {1.0, 0.5}, {4.0, 2.0}}) {
    LawCase set = sliding_point({0, 0.2, 0});
    set.points[0].last_normal_force = before;
    set.prepare(law);
    EXPECT_LT(difference(tangential(set.points[0].force, Vec3d{0, 0, 1}), {0, -friction, 0}), 1e-14) << before;
  }
}

// Without the second term a block just below the cone would creep for ever. Tolerance: rounding.
TEST(ImplicitStickSliding, CommitSlipReturnsToTheCone) {
  const ImplicitStick law;
  const ContactParameters p = parameters();
  LawCase set = one_point(1e-3, {0.3, -0.1, 0});
  ContactPoint& c = set.points[0];
  c.stretch = {5e-3, 0, 0};
  set.prepare(law);
  const Vec3d next{0.29, -0.09, 0};
  set.next_velocity[0] = next;
  ASSERT_FALSE(set.accepted_by(law));
  ASSERT_TRUE(set.accepted_by(law));
  const Vec3d friction = tangential(force_after(c, next), c.normal);
  set.commit(law);
  EXPECT_EQ(c.state, ContactState::slip);
  expect_law(level, "memory of a sliding point: error of its force if it stuck",
             "return mapping: -kt s - ct v_t is the sliding force",
             difference(-p.tangent_stiffness * c.stretch - p.tangent_damping * next, friction), 1e-13, "N");
}

// While sticking and while sliding. In numbers: mu f_n = 5 N,
// friction_direction 0.2 along x, 33 N s/m of sticking: it slips at 4 N / 33 N s/m = 0.121 m/s along and 6 / 33 = 0.182 m/s against.
TEST(ImplicitStickSliding, ConeDependsOnTheGrain) {
  const ImplicitStick law;
  ContactParameters p = parameters();
  p.friction_direction = {0.2, 0, 0};
  const auto state_at = [&](const Vec3d& next) {
    LawCase set = one_point(1e-3, {}, p);
    set.prepare(law);
    set.next_velocity[0] = next;
    (void)set.accepted_by(law);
    return set.points[0].state;
  };
  EXPECT_EQ(state_at({0.120, 0, 0}), ContactState::stick);
  EXPECT_EQ(state_at({0.122, 0, 0}), ContactState::slip);
  EXPECT_EQ(state_at({0, 0.151, 0}), ContactState::stick);
  EXPECT_EQ(state_at({0, 0.152, 0}), ContactState::slip);
  EXPECT_EQ(state_at({-0.181, 0, 0}), ContactState::stick);
  EXPECT_EQ(state_at({-0.183, 0, 0}), ContactState::slip);
  law::Worst error;
  for (const auto& [v, expected] : friction_direction_cases) {
    LawCase set = sliding_point(v);
    set.terms.parameters[0].friction_direction = p.friction_direction;
    set.prepare(law);
    error.see(difference(tangential(set.points[0].force, Vec3d{0, 0, 1}), expected), "along", v.x, v.y);
  }
  expect_law(level, "sliding on friction_direction 0.2 along, across and against it: error of the friction",
             "mu (1 - friction_direction . d) f_n against the motion", error, 1e-14, "N");
}

}  // namespace
}  // namespace murosimf::collision
