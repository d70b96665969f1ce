#include "murosimf/collision/contact_law_parts.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

// Law: k depth - d v_n, and nothing where that would pull. In numbers: 10 N at rest, 50 N s/m.
TEST(ContactForce, SpringPushesOnly) {
  const ContactParameters p = parameters();
  EXPECT_DOUBLE_EQ(spring_force(p, 1e-3, 0), 10);
  EXPECT_DOUBLE_EQ(spring_force(p, 1e-3, -0.2), 20);
  EXPECT_NEAR(spring_force(p, 1e-3, 0.19), 0.5, 1e-14);
  EXPECT_EQ(spring_force(p, 1e-3, 0.21), 0);
}

TEST(ContactForce, BodiesSlideAgainstTheFrictionThatHoldsThem) {
  const Vec3d force{3, -4, 0};
  EXPECT_LT(difference(sliding_direction(force, norm(force)), {-0.6, 0.8, 0}), 1e-15);
  EXPECT_EQ(norm(sliding_direction({}, 0)), 0);
}

// Law: mu (1 - g cos a) at the angle a from the friction_direction: mu (1 - g) along it, mu across, mu (1 + g) against it.
TEST(ContactForce, FrictionDependsOnTheDirectionByTheGrain) {
  ContactParameters p = parameters();
  const Vec3d friction_direction{0.6, 0.8, 0}, across{-0.8, 0.6, 0};
  EXPECT_DOUBLE_EQ(friction_limit(p, 10, friction_direction), 5) << "no friction_direction";
  p.friction_direction = 0.25 * friction_direction;
  EXPECT_DOUBLE_EQ(friction_limit(p, 10, friction_direction), 5 * 0.75);
  EXPECT_DOUBLE_EQ(friction_limit(p, 10, across), 5);
  EXPECT_DOUBLE_EQ(friction_limit(p, 10, -friction_direction), 5 * 1.25);
  EXPECT_NEAR(friction_limit(p, 10, std::sqrt(0.5) * (friction_direction + across)), 5 * (1 - 0.25 * std::sqrt(0.5)),
              1e-14);
}

// Law: the moment of rolling resistance is rolling r f_n against the rotation, and falls linearly to zero below
// 0.5 rad/s; corners do not roll.
TEST(ContactForce, RollingResistance) {
  ContactParameters p = parameters();
  p.rolling = 0.03;
  ContactPoint c;
  c.radius = 0.05;
  for (const double turn : {0.5, 10.0}) {
    c.angular_velocity = {0, turn, 0};
    EXPECT_NEAR(turn * rolling_damping(c, p, 10), 0.03 * 0.05 * 10, 1e-17);
  }
  c.angular_velocity = {0.25, 0, 0};
  EXPECT_NEAR(0.25 * rolling_damping(c, p, 10), 0.5 * 0.03 * 0.05 * 10, 1e-17);
  c.radius = 0;
  EXPECT_EQ(rolling_damping(c, p, 10), 0);
}

}  // namespace
}  // namespace murosimf::collision
