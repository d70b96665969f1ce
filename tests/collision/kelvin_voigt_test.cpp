#include "murosimf/collision/kelvin_voigt.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

const KelvinVoigt law;

// Law: k depth - d v_n and -kt s - ct v_t at the beginning of the step. In numbers: 10 N + 50 N s/m * 0.1 m/s, and
// 8e3 N/m * 0.1 mm + 25 N s/m * 0.02 m/s. Tolerance: rounding.
TEST(KelvinVoigtTest, SpringAndDamper) {
  ContactSet set = one_point(1e-3, {0.02, 0, -0.1});
  ContactPoint& c = set.points[0];
  c.stretch = {0, 1e-4, 0};
  law.prepare(set);
  EXPECT_EQ(c.state, ContactState::stick);
  EXPECT_LT(difference(c.force, {-0.5, -0.8, 15}), 1e-14);
}

// Rule: the law is explicit: no damping is handed to motion, and every trial is accepted as it is.
TEST(KelvinVoigtTest, IsExplicit) {
  ContactParameters p = parameters();
  p.rolling = 0.03;
  ContactSet set = one_point(1e-3, {1, 0, 0}, p);
  ContactPoint& c = set.points[0];
  c.radius = 0.05;
  c.angular_velocity = {0, 10, 0};
  c.normal_damping = c.tangent_damping = c.angular_damping = 7;
  law.prepare(set);
  EXPECT_EQ(c.normal_damping, 0);
  EXPECT_EQ(c.tangent_damping, 0);
  EXPECT_EQ(c.angular_damping, 0);
  EXPECT_LT(difference(c.moment, {0, -0.03 * 0.05 * 10, 0}), 1e-17);
  const Vec3d force = c.force;
  set.next_velocity[0] = {100, 0, 100};
  EXPECT_TRUE(law.accept(set));
  law.commit(set);
  EXPECT_EQ(difference(c.force, force), 0) << "what acted does not depend on what came of it";
}

// Rule: a point never pulls; where it would, it opens and forgets.
TEST(KelvinVoigtTest, OpensWhereItWouldPull) {
  ContactParameters p = parameters();
  p.rolling = 0.03;
  ContactSet set = one_point(1e-3, {0.1, 0, 0.21}, p);
  ContactPoint& c = set.points[0];
  c.radius = 0.05;
  c.angular_velocity = {0, 10, 0};
  c.stretch = {1e-4, 0, 0};
  law.prepare(set);
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(norm(c.force), 0);
  EXPECT_EQ(norm(c.moment), 0);
  law.commit(set);
  EXPECT_EQ(norm(c.stretch), 0);
}

// Law: friction is tangential and inside the cone for any normal, velocity and memory, and on the cone it is parallel
// to what the spring and damper would give. Tolerance: rounding of forces up to 1e2 N.
TEST(KelvinVoigtTest, FrictionStaysInTheCone) {
  Dice dice("kelvin voigt");
  int slipped = 0;
  for (int i = 0; i < 200; ++i) {
    ContactSet set = one_point(2e-3, dice.vector(0.3));
    ContactPoint& c = set.points[0];
    c.normal = dice.unit();
    c.stretch = dice.vector(1e-3);
    law.prepare(set);
    if (c.state == ContactState::open) continue;
    const ContactParameters p = parameters();
    const double f_n = dot(c.force, c.normal);
    const Vec3d f_t = tangential(c.force, c.normal);
    EXPECT_NEAR(f_n, p.stiffness * c.depth - p.damping * dot(c.velocity, c.normal), 1e-12);
    EXPECT_LE(norm(f_t), p.friction * f_n + 1e-12);
    const Vec3d spring = -p.tangent_stiffness * c.stretch - p.tangent_damping * tangential(c.velocity, c.normal);
    EXPECT_LT(norm(cross(f_t, spring)), 1e-10);
    EXPECT_GE(dot(f_t, spring), 0);
    slipped += c.state == ContactState::slip;
  }
  EXPECT_GT(slipped, 20);
  EXPECT_LT(slipped, 180);
}

// Law: the cone is wider against the grain than along it.
TEST(KelvinVoigtTest, ConeDependsOnTheGrain) {
  ContactParameters p = parameters();
  p.grain = {0.2, 0, 0};
  for (const auto& [v, expected] :
       {std::pair{Vec3d{1, 0, 0}, Vec3d{-4, 0, 0}}, std::pair{Vec3d{0, 1, 0}, Vec3d{0, -5, 0}},
        std::pair{Vec3d{-1, 0, 0}, Vec3d{6, 0, 0}}}) {
    ContactSet set = one_point(1e-3, v, p);
    law.prepare(set);
    EXPECT_LT(difference(tangential(set.points[0].force, Vec3d{0, 0, 1}), expected), 1e-14);
  }
}

// Law: memory. Sticking adds dt v_t+.
TEST(KelvinVoigtTest, CommitStick) {
  ContactSet set = one_point(1e-3);
  ContactPoint& c = set.points[0];
  c.stretch = {1e-4, 0, 0};
  law.prepare(set);
  set.next_velocity[0] = {0.01, -0.02, 0.1};
  law.commit(set);
  EXPECT_LT(difference(c.stretch, {1.1e-4, -0.2e-4, 0}), 1e-18);
}

// Law: return mapping. After slipping, the spring stands where it would have given exactly the sliding force, and moves
// on from there: a steady slide stays on the cone in every step. Tolerance: rounding.
TEST(KelvinVoigtTest, CommitSlipReturnsToTheCone) {
  const ContactParameters p = parameters();
  const Vec3d v{0.3, -0.1, 0};
  ContactSet set = one_point(1e-3, v);
  ContactPoint& c = set.points[0];
  c.stretch = {5e-3, 0, 0};
  law.prepare(set);
  ASSERT_EQ(c.state, ContactState::slip);
  const Vec3d friction = tangential(c.force, c.normal);
  set.next_velocity[0] = v;
  law.commit(set);
  const Vec3d before = c.stretch - dt * v;
  EXPECT_LT(difference(-p.tangent_stiffness * before - p.tangent_damping * v, friction), 1e-13);
  law.prepare(set);
  EXPECT_EQ(c.state, ContactState::slip);
}

// Law: a block pushed with 0.9 of mu m g stays where its spring holds it and does not creep. Tolerance: for the place
// the transient's rest after 4 s (decay rate ct / 2m = 12.5 /s); for the creep 1e-13 m in one second.
TEST(KelvinVoigtTest, NoCreepBelowTheCone) {
  Block block = resting_block({4.5, 0, 0});
  for (int i = 0; i < 4000; ++i) block.step(law);
  const Vec3d place = block.position;
  for (int i = 0; i < 1000; ++i) block.step(law);
  EXPECT_LT(difference(block.position, place), 1e-13);
  EXPECT_EQ(block.point().state, ContactState::stick);
  EXPECT_LT(difference(block.contact_force, {-4.5, 0, 10}), 1e-9);
}

// Law: pushed with 1.4 of mu m g it slides with a = F/m - mu g, on the cone in every step.
TEST(KelvinVoigtTest, SlidesAboveTheCone) {
  Block block = resting_block({7, 0, 0});
  for (int i = 0; i < 500; ++i) block.step(law);
  const double before = block.velocity.x;
  for (int i = 0; i < 500; ++i) {
    block.step(law);
    ASSERT_EQ(block.point().state, ContactState::slip);
  }
  EXPECT_NEAR((block.velocity.x - before) / 0.5, 2.0, 1e-8);
}

}  // namespace
}  // namespace murosimf::collision
