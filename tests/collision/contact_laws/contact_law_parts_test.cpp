#include "murosimf/collision/contact_laws/contact_law_parts.h"

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

/// [N m] On a ball of 5 cm that is pressed with 10 N on level ground: rolling resistance 0.03, torsional 2 mm.
Vec3d resistance(const Vec3d& angular_velocity, double radius = 0.05, const Vec3d& rolling_direction = {}) {
  ContactParameters p = parameters();
  p.rolling_direction = rolling_direction;
  p.rolling = 0.03;
  p.torsional = 0.002;
  ContactPoint c;
  c.normal = {0, 0, 1};
  c.radius = radius;
  c.angular_velocity = angular_velocity;
  resist_turning(c, p, 10);
  EXPECT_LT(difference(c.moment, -(angular_damping_matrix(c) * angular_velocity)), 1e-16)
      << "the damping is that of the moment";
  return c.moment;
}

// Law: rolling r f_n against rolling, torsional f_n against spinning, each falling linearly to zero below 0.5 rad/s; corners
// have neither. In numbers: 15 mN m and 20 mN m.
TEST(ContactForce, RollingAndSpinningAreResistedByTwoCoefficients) {
  EXPECT_LT(difference(resistance({0, 10, 0}), {0, -0.015, 0}), 1e-16);
  EXPECT_LT(difference(resistance({0.5, 0, 0}), {-0.015, 0, 0}), 1e-16);
  EXPECT_LT(difference(resistance({0.25, 0, 0}), {-0.0075, 0, 0}), 1e-16);
  EXPECT_LT(difference(resistance({0, 0, 10}), {0, 0, -0.02}), 1e-16);
  EXPECT_LT(difference(resistance({0, 0, -0.25}), {0, 0, 0.01}), 1e-16);
  EXPECT_LT(difference(resistance({3, 4, -7}), {-0.009, -0.012, 0.02}), 1e-16);
  EXPECT_EQ(norm(resistance({3, 4, -7}, 0)), 0);
}

// Law: rolling (1 - g cos a) at the angle a between where the ball rolls and where the pile leans. A turn about y rolls along x. In
// numbers: g = 0.4 along x, 15 mN m across. Spinning knows no direction, and at half of 0.5 rad/s half of g is left.
TEST(ContactForce, RollingDependsOnTheDirectionByThePile) {
  const Vec3d pile{0.4, 0, 0};
  EXPECT_LT(difference(resistance({0, 10, 0}, 0.05, pile), {0, -0.009, 0}), 1e-16);
  EXPECT_LT(difference(resistance({0, -10, 0}, 0.05, pile), {0, 0.021, 0}), 1e-16);
  EXPECT_LT(difference(resistance({10, 0, 0}, 0.05, pile), {-0.015, 0, 0}), 1e-16);
  EXPECT_LT(difference(resistance({0, 0, 10}, 0.05, pile), {0, 0, -0.02}), 1e-16);
  EXPECT_LT(difference(resistance({-6, 8, 0}, 0.05, pile), 0.015 * (1 - 0.4 * 0.8) * Vec3d{0.6, -0.8, 0}), 1e-16);
  EXPECT_LT(difference(resistance({0, 0.25, 0}, 0.05, pile), {0, -0.0075 * 0.8, 0}), 1e-16);
}

}  // namespace
}  // namespace murosimf::collision
