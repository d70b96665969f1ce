#include "murosimf/collision/contact_laws/depenetration.h"

#include <gtest/gtest.h>

#include "murosimf/collision/contact_laws/contact_law_parts.h"

namespace murosimf::collision {
namespace {

constexpr double step = 1e-3;

ContactPoint point(double depth, double v_n) {
  ContactPoint c;
  c.normal = {0, 0.6, 0.8};
  c.depth = depth;
  c.velocity = v_n * c.normal + Vec3d{0.3, 0, 0};
  return c;
}

// Rule: depth > 1.5 |v_n| dt + 2 mm, whatever moves along the surface.
TEST(SoftStart, WhatItsApproachExplainsIsNotDeep) {
  const auto lift = [](ContactPoint c) {
    begin_depenetration(c, step);
    return c.lift;
  };
  EXPECT_EQ(lift(point(1.9e-3, 0)), 0);
  EXPECT_EQ(lift(point(2.1e-3, 0)), 0.5);
  EXPECT_EQ(lift(point(16.9e-3, -10)), 0);
  EXPECT_EQ(lift(point(17.1e-3, -10)), 0.5);
  EXPECT_EQ(lift(point(2.1e-3, 10)), 0.5) << "it leaves";
}

// Rule: no force at the speed of the lift; ordinary damping if that is larger, or if nothing is lifted.
TEST(SoftStart, DampingEndsTheForceAtItsSpeed) {
  const ContactParameters p{.stiffness = 2e4, .damping = 30, .theta = 1};
  ContactPoint c = point(0.1, 0);
  EXPECT_EQ(implicit_damping(c, p, step), 30 + 20);
  c.lift = 0.5;
  EXPECT_NEAR(p.stiffness * c.depth - implicit_damping(c, p, step) * 0.5, 0, 1e-12);
  c.depth = 1e-4;
  EXPECT_EQ(implicit_damping(c, p, step), 30 + 20);
}

// Rule: it ends where the spring is slower by itself: k depth = lift b_n.
TEST(SoftStart, EndsWhereTheSpringIsSlow) {
  const ContactParameters p{.stiffness = 2e4, .damping = 30, .theta = 1};
  ContactPoint c = point(1.3e-3, 0);
  c.lift = 0.5;
  end_depenetration(c, p, step);
  EXPECT_EQ(c.lift, 0.5);
  c.depth = 1.2e-3;
  end_depenetration(c, p, step);
  EXPECT_EQ(c.lift, 0);
}

// Rule: a tenth of the mass at the point is brought to the speed within a step, and nothing pulls.
TEST(SoftStart, ExplicitLawsDoNotOvershoot) {
  const ContactParameters p{.mass = 3};
  ContactPoint c = point(0.1, 0);
  EXPECT_GT(explicit_limit(c, p, step, 0.2), 1e300) << "not lifted";
  c.lift = 0.5;
  EXPECT_NEAR(explicit_limit(c, p, step, 0.2) * step / 0.3, 0.3, 1e-15);
  EXPECT_EQ(explicit_limit(c, p, step, 0.6), 0);
}

// It is part of the memory, and of the state only while it is set.
TEST(SoftStart, IsMemory) {
  ContactPoint old = point(0.1, 0), next = old;
  const auto hash = [](const ContactPoint& c) {
    Hasher hasher;
    append_hash(hasher, c);
    return hasher.value();
  };
  EXPECT_EQ(hash(old), hash(next));
  old.lift = 0.5;
  EXPECT_NE(hash(old), hash(next));
  recall(old, next);
  EXPECT_EQ(next.lift, 0.5);
  EXPECT_EQ(hash(old), hash(next));
}

}  // namespace
}  // namespace murosimf::collision
