#include "murosimf/collision/contact_law.h"

#include <gtest/gtest.h>

#include "murosimf/collision/implicit_stick.h"
#include "murosimf/collision/paper_law.h"
#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;
using fixtures::difference;

constexpr double dt = 1e-3;

ContactParameters parameters() {
  ContactParameters p;
  p.stiffness = 1e4;
  p.damping = 50;
  p.tangent_stiffness = 8e3;
  p.tangent_damping = 25;
  p.friction = 0.5;
  p.theta = 1;
  return p;
}

/// One point on flat ground.
ContactSet one_point(double depth, const Vec3d& velocity = {}, const ContactParameters& p = parameters()) {
  ContactSet set;
  set.dt = dt;
  set.parameters = {p};
  set.points.resize(1);
  set.points[0].normal = {0, 0, 1};
  set.points[0].depth = depth;
  set.points[0].velocity = velocity;
  set.next_velocity.resize(1);
  return set;
}

/// A vector by its parts along the normal, along the sliding direction (only while slipping) and across both.
struct Parts {
  Vec3d normal, sliding, across;

  Parts(const ContactPoint& c, const Vec3d& v) {
    normal = dot(v, c.normal) * c.normal;
    if (c.state == ContactState::slip) sliding = dot(v, c.slip_direction) * c.slip_direction;
    across = v - normal - sliding;
  }
};

/// What the seam says (contact.h): the force on A if the velocity after the step is `next`.
Vec3d force_after(const ContactPoint& c, const Vec3d& next) {
  const Parts change(c, next - c.velocity);
  return c.force - c.normal_damping * change.normal - c.tangent_damping * change.across;
}

/// What the law says while it sticks, with the velocity after the step.
Vec3d sticking_force(const ContactPoint& c, const ContactParameters& p, const Vec3d& next) {
  const double v_n = dot(next, c.normal);
  const Vec3d v_t = next - v_n * c.normal;
  const double f_n = p.stiffness * (c.depth - p.theta * dt * v_n) - p.damping * v_n;
  return f_n * c.normal - p.tangent_stiffness * (c.stretch + dt * v_t) - p.tangent_damping * v_t;
}

/// A block of `mass` with one point on the ground z = 0, stepped as a motion algorithm does: prepare, trial steps until
/// the law accepts, commit. The linear problem of one trial is diagonal in the parts above.
struct Block {
  double mass = 1;
  Vec3d position, velocity, push;  // push: all other forces
  ContactSet set;
  Vec3d contact_force;
  int passes = 0;

  explicit Block(const ContactParameters& p) : set(one_point(0, {}, p)) {}

  [[nodiscard]] ContactPoint& point() { return set.points[0]; }

  void step(const ContactLaw& law) {
    ContactPoint& c = point();
    c.depth = -position.z;
    c.velocity = velocity;
    if (c.depth > 0) {
      law.prepare(set);
    } else {
      c.force = {};
      c.normal_damping = c.tangent_damping = 0;
    }
    for (passes = 1;; ++passes) {
      const Parts f(c, push + c.force);
      set.next_velocity[0] = velocity + (dt / (mass + dt * c.normal_damping)) * f.normal + (dt / mass) * f.sliding +
                             (dt / (mass + dt * c.tangent_damping)) * f.across;
      if (c.depth <= 0 || law.accept(set) || passes == max_passes) break;
    }
    contact_force = force_after(c, set.next_velocity[0]);
    if (c.depth > 0) law.commit(set);
    velocity = set.next_velocity[0];
    position += dt * velocity;
  }
};

Block resting_block(const Vec3d& sideways) {
  const ContactParameters p = parameters();
  Block block(p);
  block.push = Vec3d{0, 0, -10} + sideways;
  block.position.z = -10 / p.stiffness;  // the static sink
  return block;
}

/// One row about a contact law alone, without bodies of the simulation.
void expect_law(const std::string& level, const std::string& law, const std::string& source, const law::Measured& error,
                double limit, const std::string& unit) {
  law::expect_below({.law = law, .level = level, .source = source}, error, limit, unit);
}
constexpr const char* stick_law = "implicit_stick";
constexpr const char* paper_law = "paper";

// ---- the default law ----

// Prepare also projects the memory on the tangent plane. Tolerance: rounding of forces up to 1e3 N.
TEST(ImplicitStickTest, StickingIsLinearInTheVelocityAfterTheStep) {
  const ImplicitStick law;
  Dice dice("stick");
  law::Worst error;
  for (int i = 0; i < 100; ++i) {
    ContactParameters p = parameters();
    p.theta = dice.uniform(0, 1);
    ContactSet set = one_point(dice.uniform(1e-4, 1e-2), dice.vector(1), p);
    ContactPoint& c = set.points[0];
    c.normal = dice.unit();
    c.stretch = dice.vector(1e-3);
    law.prepare(set);
    EXPECT_EQ(c.state, ContactState::stick);
    EXPECT_NEAR(dot(c.stretch, c.normal), 0, 1e-18);
    EXPECT_NEAR(c.normal_damping, p.damping + p.theta * dt * p.stiffness, 1e-12);
    EXPECT_NEAR(c.tangent_damping, p.tangent_damping + dt * p.tangent_stiffness, 1e-12);
    const Vec3d next = dice.vector(1);
    error.see(difference(force_after(c, next), sticking_force(c, p, next)), "set", i);
  }
  expect_law(stick_law, "sticking point: error of the force for any velocity after the step",
             "spring and damper at that velocity", error, 1e-12, "N");
}

// Rule: inside the cone a sticking point is accepted as it is.
TEST(ImplicitStickTest, SticksInsideTheCone) {
  const ImplicitStick law;
  ContactSet set = one_point(1e-3);
  law.prepare(set);
  set.next_velocity[0] = {0.1, 0, 0};  // tangential force 33 * 0.1 = 3.3 N of mu f_n = 5 N
  EXPECT_TRUE(law.accept(set));
  EXPECT_EQ(set.points[0].state, ContactState::stick);
}

// Rule: outside the cone it slips, and the step must be repeated; the sliding force is mu f_n against the motion.
// Tolerance: rounding.
TEST(ImplicitStickTest, SlipsAtTheCone) {
  const ImplicitStick law;
  for (const auto& [speed, expected] : {std::pair{0.151, ContactState::stick}, std::pair{0.152, ContactState::slip}}) {
    ContactSet set = one_point(1e-3);  // f_n = 10 N: the cone is reached at 5 N / 33 N s/m = 0.15152 m/s
    law.prepare(set);
    set.next_velocity[0] = {0.6 * speed, 0.8 * speed, 0};
    EXPECT_EQ(law.accept(set), expected == ContactState::stick);
    EXPECT_EQ(set.points[0].state, expected);
  }
  ContactSet set = one_point(1e-3, {0.6, 0.8, 0});
  law.prepare(set);
  set.next_velocity[0] = {0.6, 0.8, 0};
  EXPECT_FALSE(law.accept(set));
  const Vec3d force = force_after(set.points[0], {0.6, 0.8, 0});
  expect_law(stick_law, "sliding point: error of the force", "mu f_n against the motion",
             difference(force, {-3, -4, 10}), 1e-14, "N");
  EXPECT_TRUE(law.accept(set));  // the normal force did not move
  // pressed harder by the trial step, 10 N + 60 N s/m * 0.05 m/s, it slides on that force at once
  set = one_point(1e-3, {0.6, 0.8, 0});
  law.prepare(set);
  set.next_velocity[0] = {0.6, 0.8, -0.05};
  EXPECT_FALSE(law.accept(set));
  expect_law(stick_law, "sliding point pressed harder by the trial step: error of the force",
             "mu f_n against the motion", difference(force_after(set.points[0], {0.6, 0.8, -0.05}), {-3.9, -5.2, 13}),
             1e-14, "N");
}

/// A point that slides with `velocity`, pressed with 10 N, and slid along x before.
ContactSet sliding_point(const Vec3d& velocity) {
  ContactSet set = one_point(1e-3, velocity);
  ContactPoint& c = set.points[0];
  c.state = ContactState::slip;
  c.slip_direction = {1, 0, 0};
  c.last_normal_force = 10;
  return set;
}

// Value and derivative, along and across. Tolerance: differences of 1e-6 m/s err by the third derivative, 5 N * 1e-12 /
// |v|^3.
TEST(ImplicitStickTest, SlidingIsTheTangentOfCoulomb) {
  const ImplicitStick law;
  const Vec3d v{0.3, -0.4, 0};
  ContactSet set = sliding_point(v);
  const ContactPoint& c = set.points[0];
  law.prepare(set);
  const auto coulomb = [](const Vec3d& u) { return (-5 / norm(u)) * u; };
  expect_law(stick_law, "linearized sliding: error of the friction", "-mu f_n v / |v|",
             difference(tangential(c.force, c.normal), coulomb(v)), 1e-14, "N");
  law::Worst error;
  const double h = 1e-6;
  for (const Vec3d& d : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0.6, -0.8, 0}, Vec3d{0.8, 0.6, 0}}) {
    const Vec3d slope = (0.5 / h) * (coulomb(v + h * d) - coulomb(v - h * d));
    const Vec3d given = (0.5 / h) * (force_after(c, v + h * d) - force_after(c, v - h * d));
    error.see(difference(given, slope), "along", d.x, d.y);
  }
  expect_law(stick_law, "linearized sliding: error of the friction's derivative",
             "central differences of -mu f_n v / |v|", error, 1e-8, "N s/m");
}

// Rule: slower than 5 mm/s the direction of sliding is not trusted: the last known one stays, the friction along it is
// mu f_n, and what goes across is damped as at 5 mm/s. Tolerance: rounding.
TEST(ImplicitStickTest, SlowSlidingKeepsItsDirection) {
  const ImplicitStick law;
  ContactSet set = sliding_point({0, 0.004, 0});
  ContactPoint& c = set.points[0];
  law.prepare(set);
  EXPECT_EQ(difference(c.slip_direction, {1, 0, 0}), 0);
  EXPECT_LT(difference(tangential(c.force, c.normal), {-5, -5 * 0.004 / 0.005, 0}), 1e-14);
  EXPECT_NEAR(c.tangent_damping, 5 / 0.005, 1e-12);
  c.velocity = {0, 0.006, 0};
  law.prepare(set);
  EXPECT_EQ(difference(c.slip_direction, {0, 1, 0}), 0);
  EXPECT_LT(difference(tangential(c.force, c.normal), {0, -5, 0}), 1e-14);
  EXPECT_NEAR(c.tangent_damping, 5 / 0.006, 1e-11);
}

// Rule: a point never pulls: it opens where its force would be negative, feels nothing then, and is accepted.
TEST(ImplicitStickTest, OpensWhereItWouldPull) {
  const ImplicitStick law;
  ContactSet set = one_point(1e-3);
  law.prepare(set);
  set.next_velocity[0] = {0, 0, 0.16};  // 10 N - 60 N s/m * 0.16 m/s = 0.4 N: just pushing
  EXPECT_TRUE(law.accept(set));
  set.next_velocity[0] = {0, 0, 0.17};  // -0.2 N
  EXPECT_FALSE(law.accept(set));
  const ContactPoint& c = set.points[0];
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.force), 0);
  EXPECT_EQ(c.normal_damping, 0);
  EXPECT_EQ(c.tangent_damping, 0);
  EXPECT_TRUE(law.accept(set));
  // and closes again, to stick, if the next trial comes back
  set.next_velocity[0] = {0, 0, 0.1};
  EXPECT_FALSE(law.accept(set));
  EXPECT_EQ(c.state, ContactState::stick);
  EXPECT_GT(dot(c.force, c.normal), 0);
  EXPECT_TRUE(law.accept(set));
}

// Rule: an open point feels no rolling resistance either: there is no normal force that could cause it.
TEST(ImplicitStickTest, OpenPointDoesNotRoll) {
  const ImplicitStick law;
  ContactParameters p = parameters();
  p.rolling = 0.03;
  ContactSet set = one_point(1e-3, {}, p);
  ContactPoint& c = set.points[0];
  c.radius = 0.05;
  c.angular_velocity = {0, 10, 0};
  law.prepare(set);
  EXPECT_LT(c.moment.y, 0);
  set.next_velocity[0] = {0, 0, 1};
  EXPECT_FALSE(law.accept(set));
  ASSERT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.moment), 0);
  EXPECT_EQ(c.angular_damping, 0);
}

// Rule: friction that would push along the motion means that the point has come to rest: slip becomes stick.
TEST(ImplicitStickTest, SlipBecomesStickAtRest) {
  const ImplicitStick law;
  ContactSet set = sliding_point({0.003, 0, 0});
  const ContactPoint& c = set.points[0];
  law.prepare(set);
  set.next_velocity[0] = {0.001, 0, 0};  // still forwards, friction backwards
  EXPECT_TRUE(law.accept(set));
  set.next_velocity[0] = {-0.001, 0, 0};  // friction has turned it round
  EXPECT_FALSE(law.accept(set));
  EXPECT_EQ(c.state, ContactState::stick);
}

// Rule: a sliding force follows the normal force: it is renewed if that moved by more than 5 %.
TEST(ImplicitStickTest, SlidingFollowsTheNormalForce) {
  const ImplicitStick law;
  ContactSet set = sliding_point({1, 0, 0});
  const ContactPoint& c = set.points[0];
  law.prepare(set);
  set.next_velocity[0] = {1, 0, -0.4 / 60};  // 10.4 N
  EXPECT_TRUE(law.accept(set));
  set.next_velocity[0] = {1, 0, -5.0 / 60};  // 15 N
  EXPECT_FALSE(law.accept(set));
  EXPECT_NEAR(norm(tangential(force_after(c, {1, 0, 0}), c.normal)), 7.5, 1e-12);
  EXPECT_TRUE(law.accept(set));
}

// Opening forgets. Tolerance: rounding.
TEST(ImplicitStickTest, CommitStickAndOpen) {
  const ImplicitStick law;
  ContactSet set = one_point(1e-3);
  ContactPoint& c = set.points[0];
  c.stretch = {1e-4, 0, 0};
  law.prepare(set);
  set.next_velocity[0] = {0.01, -0.02, 0.1};
  ASSERT_TRUE(law.accept(set));
  law.commit(set);
  expect_law(stick_law, "memory of a sticking point: error of the stretch after one step", "grows by dt v_t",
             difference(c.stretch, {1.1e-4, -0.2e-4, 0}), 1e-18, "m");
  EXPECT_NEAR(c.last_normal_force, 10 - 60 * 0.1, 1e-14);

  law.prepare(set);
  set.next_velocity[0] = {0, 0, 1};
  ASSERT_FALSE(law.accept(set));
  law.commit(set);
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.stretch), 0);
  EXPECT_EQ(c.last_normal_force, 0);
  law.prepare(set);  // in the next step it starts anew
  EXPECT_EQ(c.state, ContactState::stick);
}

// Without the second term a block just below the cone would creep for ever. Tolerance: rounding.
TEST(ImplicitStickTest, CommitSlipReturnsToTheCone) {
  const ImplicitStick law;
  const ContactParameters p = parameters();
  ContactSet set = one_point(1e-3, {0.3, -0.1, 0});
  ContactPoint& c = set.points[0];
  c.stretch = {5e-3, 0, 0};
  law.prepare(set);
  const Vec3d next{0.29, -0.09, 0};
  set.next_velocity[0] = next;
  ASSERT_FALSE(law.accept(set));
  ASSERT_TRUE(law.accept(set));
  const Vec3d friction = tangential(force_after(c, next), c.normal);
  law.commit(set);
  EXPECT_EQ(c.state, ContactState::slip);
  expect_law(stick_law, "memory of a sliding point: error of its force if it stuck",
             "return mapping: -kt s - ct v_t is the sliding force",
             difference(-p.tangent_stiffness * c.stretch - p.tangent_damping * next, friction), 1e-13, "N");
}

// The spring holds it F / kt away; after it has settled its place does not change at all. Tolerance: for the place, the
// transient's rest after 2 s (decay rate ct / 2m = 12.5 /s); for the creep 1e-13 m in one second.
TEST(ImplicitStickTest, NoCreepBelowTheCone) {
  const ImplicitStick law;
  Block block = resting_block({4.5, 0, 0});
  for (int i = 0; i < 4000; ++i) block.step(law);
  const Vec3d place = block.position;
  for (int i = 0; i < 1000; ++i) block.step(law);
  expect_law(stick_law, "block pushed with 0.9 mu m g: creep in 1 s", "Coulomb: it sticks",
             difference(block.position, place), 1e-13, "m");
  EXPECT_LT(norm(block.velocity), 1e-12);
  EXPECT_EQ(block.point().state, ContactState::stick);
  expect_law(stick_law, "block pushed with 0.9 mu m g: error of the contact force", "it balances push and weight",
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
  expect_law(stick_law, "block pushed with 1.4 mu m g: error of the friction", "mu m g: it is on the cone", error, 1e-8,
             "N");
  law::expect_near({.law = "block pushed with 1.4 mu m g: acceleration", .level = stick_law, .source = "F / m - mu g"},
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
  law::expect_near({.law = "block slides to rest: way", .level = stick_law, .source = "v^2 / (2 mu g)"},
                   block.position.x, 1 / (2 * 0.5 * 10), 1.6e-3, "m");
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
  expect_law(stick_law, "block lands while it slides: relative error of the friction", "mu times the pressing force",
             error, 0.05, "");
  EXPECT_EQ(block.point().state, ContactState::slip);
}

// It falls linearly to zero below 0.5 rad/s, and is linear in the rate after the step (angular_damping). Tolerance:
// rounding.
TEST(ImplicitStickTest, RollingResistance) {
  const ImplicitStick law;
  ContactParameters p = parameters();
  p.rolling = 0.03;
  ContactSet set = one_point(1e-3, {}, p);
  ContactPoint& c = set.points[0];
  c.radius = 0.05;
  const double full = 0.03 * 0.05 * 10;
  c.angular_velocity = {0, 10, 0};
  law.prepare(set);
  expect_law(stick_law, "rolling resistance: error of the moment", "rolling * radius * k * depth against the rotation",
             difference(c.moment, {0, -full, 0}), 1e-17, "N m");
  EXPECT_NEAR(c.angular_damping, full / 10, 1e-17);
  c.angular_velocity = {0.25, 0, 0};
  law.prepare(set);
  expect_law(stick_law, "rolling resistance at 0.25 rad/s: error of the moment", "half: linear below 0.5 rad/s",
             difference(c.moment, {-full / 2, 0, 0}), 1e-17, "N m");
  c.angular_velocity = {};
  law.prepare(set);
  EXPECT_EQ(norm(c.moment), 0);
  // corners do not roll
  c.radius = 0;
  c.angular_velocity = {0, 10, 0};
  law.prepare(set);
  EXPECT_EQ(norm(c.moment), 0);
  EXPECT_EQ(c.angular_damping, 0);
}

// Rule: every point has its own constants and its own state.
TEST(ImplicitStickTest, PointsAreIndependent) {
  const ImplicitStick law;
  ContactSet set = one_point(1e-3);
  set.points.resize(3, set.points[0]);
  set.next_velocity.resize(3);
  set.parameters.push_back(parameters());
  set.parameters[1].friction = 0.01;
  set.points[1].surface = 1;
  law.prepare(set);
  set.next_velocity = {{0.1, 0, 0}, {0.1, 0, 0}, {0, 0, 1}};
  EXPECT_FALSE(law.accept(set));
  EXPECT_EQ(set.points[0].state, ContactState::stick);
  EXPECT_EQ(set.points[1].state, ContactState::slip);
  EXPECT_EQ(set.points[2].state, ContactState::open);
}

// ---- the paper's law ----

// In numbers: s_c = 1e4 N/m, depth 2 mm, s_b = 0.4, s_mu = 5 s/m, s_nu = 0.01 m s. Tolerance: rounding.
TEST(PaperLawTest, Equations4And5) {
  const PaperLaw law({.rebound = 0.4, .friction = 5, .spin_friction = 0.01});
  ContactSet set = one_point(2e-3, {0.1, -0.2, -0.3});
  ContactPoint& c = set.points[0];
  c.angular_velocity = {1, 2, 3};
  law.prepare(set);
  expect_law(paper_law, "approaching point: error of the force", "eq. (4), (5): s_c depth n - s_mu |f_n| v_t",
             difference(c.force, {-5 * 20 * 0.1, 5 * 20 * 0.2, 20}), 1e-14, "N");
  expect_law(paper_law, "approaching point: error of the moment", "eq. (5): -s_nu |f_n| w",
             difference(c.moment, {-0.2, -0.4, -0.6}), 1e-15, "N m");

  c.velocity.z = 0.3;
  law.prepare(set);
  expect_law(paper_law, "separating point: error of the force", "eq. (4), (5): s_b s_c depth n - s_mu |f_n| v_t",
             difference(c.force, {-5 * 8 * 0.1, 5 * 8 * 0.2, 8}), 1e-14, "N");
  expect_law(paper_law, "separating point: error of the moment", "eq. (5): -s_nu |f_n| w",
             difference(c.moment, {-0.08, -0.16, -0.24}), 1e-15, "N m");
}

// Rule: the law is explicit: no damping is handed to motion, and every trial is accepted as it is.
TEST(PaperLawTest, IsExplicit) {
  const PaperLaw law;
  ContactSet set = one_point(1e-3, {1, 0, 0});
  set.points[0].normal_damping = set.points[0].tangent_damping = set.points[0].angular_damping = 7;
  law.prepare(set);
  EXPECT_EQ(set.points[0].normal_damping, 0);
  EXPECT_EQ(set.points[0].tangent_damping, 0);
  EXPECT_EQ(set.points[0].angular_damping, 0);
  set.next_velocity[0] = {100, 0, 100};
  const Vec3d before = set.points[0].force;
  EXPECT_TRUE(law.accept(set));
  law.commit(set);
  EXPECT_EQ(difference(set.points[0].force, before), 0);
}

// The normal may point anywhere. Tolerance: rounding of forces up to 200 N.
TEST(PaperLawTest, FrictionIsTangential) {
  const PaperLaw law({.rebound = 0.4, .friction = 5, .spin_friction = 0.01});
  Dice dice("paper law");
  law::Worst error;
  for (int i = 0; i < 50; ++i) {
    ContactSet set = one_point(2e-3, dice.vector(1));
    ContactPoint& c = set.points[0];
    c.normal = dice.unit();
    law.prepare(set);
    const double f_n = dot(c.velocity, c.normal) < 0 ? 20 : 8;
    error.see(std::abs(dot(c.force, c.normal) - f_n), "normal", i);
    EXPECT_LE(dot(tangential(c.force, c.normal), c.velocity), 0);
  }
  expect_law(paper_law, "any normal: error of the force along it", "friction has no part along the normal", error,
             1e-13, "N");
}

// Rule: one point per body, the deepest.
TEST(PaperLawTest, KeepsTheDeepestPointOfEveryBody) {
  const PaperLaw law;
  ContactSet set = one_point(0);
  set.points.resize(7, set.points[0]);
  const int objects[] = {4, 4, 9, 4, 9, 2, 2};
  const double depths[] = {1, 3, 5, 2, 4, 6, 7};
  for (std::size_t i = 0; i < 7; ++i) {
    set.points[i].object = objects[i];
    set.points[i].depth = 1e-3 * depths[i];
    set.points[i].feature = static_cast<std::uint32_t>(i);
  }
  law.prepare(set);
  ASSERT_EQ(set.points.size(), 3u);
  const std::pair<int, std::uint32_t> expected[] = {{4, 1}, {9, 2}, {2, 6}};  // object, feature
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(set.points[i].object, expected[i].first);
    EXPECT_EQ(set.points[i].feature, expected[i].second);
    EXPECT_GT(norm(set.points[i].force), 0);
  }
}

// ---- from points to bodies ----

// external_force - external_damping * (change of the body's motion) is the sum of what every point says for the change
// of its own velocity, at the body's origin, plus the force without contacts. Tolerance: rounding of 1e3 N.
TEST(ContactLoads, SumOfPoints) {
  Dice dice("loads");
  law::Worst force_error, moment_error;
  const ImplicitStick law;
  for (int i = 0; i < 50; ++i) {
    ContactParameters p = parameters();
    p.rolling = 0.1;
    ContactSet set = one_point(0, {}, p);
    set.points.resize(3, set.points[0]);
    std::vector<Vec3d> r{dice.vector(1), dice.vector(1)};
    std::vector<Forced> force(2), rest{{dice.vector(1), dice.vector(1)}, {dice.vector(1), dice.vector(1)}};
    std::vector<Sym6d> damping(2);
    for (ContactPoint& c : set.points) {
      c.object = 1;
      c.normal = dice.unit();
      c.depth = 1e-3;
      c.radius = 0.2;
      c.point = r[1] + dice.vector(0.3);
      c.velocity = dice.vector(1);
      c.angular_velocity = dice.vector(1);
    }
    set.points[2].state = ContactState::slip;
    set.rest_force = rest;
    set.loaded = {1};
    law.prepare(set);
    force[0] = rest[0];
    // twice: loads are written, not added up
    write_loads(set, r, force, damping);
    write_loads(set, r, force, damping);

    const Motiond change{dice.vector(1), dice.vector(1)};
    const Forced given = force[1] - damping[1] * change;
    Vec3d f = rest[1].f, n = rest[1].n;
    for (const ContactPoint& c : set.points) {
      const Vec3d arm = c.point - r[1];
      const Vec3d at_point = force_after(c, c.velocity + change.v + cross(change.w, arm));
      f += at_point;
      n += cross(arm, at_point) + c.moment - c.angular_damping * change.w;
    }
    force_error.see(difference(given.f, f), "set", i);
    moment_error.see(difference(given.n, n), "set", i);
    EXPECT_EQ(difference(force[0].f, rest[0].f), 0);  // objects without contacts keep what they have
    EXPECT_EQ(difference(damping[0].M, SymMat3d{}), 0);
  }
  const std::string source = "sum of what its points say for the change of their velocities";
  expect_law(stick_law, "load of a body for any change of its motion: error of the force", source, force_error, 1e-12,
             "N");
  expect_law(stick_law, "load of a body for any change of its motion: error of the moment", source, moment_error, 1e-12,
             "N m");
}

// Rule: the law's memory is part of the state: feature, state and stretch of every point enter the hash.
TEST(ContactLoads, MemoryEntersTheStateHash) {
  const auto hash = [](const ContactSet& set) {
    Hasher hasher;
    append_hash(hasher, set);
    return hasher.value();
  };
  const ContactSet set = one_point(1e-3);
  ContactSet other = set;
  EXPECT_EQ(hash(set), hash(other));
  other.points[0].stretch.y = 5e-324;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points[0].state = ContactState::slip;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points[0].feature = 1;
  EXPECT_NE(hash(set), hash(other));
  other = set;
  other.points.push_back(set.points[0]);
  EXPECT_NE(hash(set), hash(other));
}

}  // namespace
}  // namespace murosimf::collision
