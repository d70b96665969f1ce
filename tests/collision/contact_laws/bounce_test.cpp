#include "murosimf/collision/contact_laws/bounce.h"
#include "murosimf/collision/contact_laws/depenetration.h"

#include <gtest/gtest.h>

#include "tests/collision/law_fixtures.h"

namespace murosimf::collision {
namespace {

constexpr double g = 9.81;  // [m/s^2]

ContactParameters round_thing(double restitution) {
  ContactParameters p = parameters();
  p.mass = 0.1;
  p.restitution = restitution;
  return p;
}

/// A point at `depth` [m] in level ground that comes with `speed` [m/s].
ContactPoint falling(double depth, double speed) {
  ContactPoint c;
  c.normal = {0, 0, 1};
  c.depth = depth;
  c.velocity = {0.3, 0, -speed};
  return c;
}

/// Height [m] that a ball reaches after one bounce from a fall of `height`, in steps of semi-implicit Euler.
double height_after(double restitution, double height, double step) {
  const ContactParameters p = round_thing(restitution);
  double z = height, v = 0, highest = 0;
  ContactPoint c;
  c.bounce = -2;  // has not touched
  while (v <= 0 || z + step * (v - step * g) > z) {
    double next = v - step * g;
    if (z < 0 && c.bounce == -2) {
      c = falling(-z, -v);
      begin_bounce(c, p, {0, 0, -g}, step);
      next = std::max(next, c.bounce);
    }
    v = next;
    z += step * v;
    if (v > 0) highest = std::max(highest, z);
  }
  return highest;
}

// Law: e^2 h, whatever the step and wherever in it the ball touches. Tolerance: places lie on the parabola, of which steps see one of
// g dt^2 / 8 below the top at worst.
TEST(Bounce, RestitutionIsRightInEveryStep) {
  for (const double step : {0.5e-3, 1e-3, 2e-3, 5e-3, 8e-3, 10e-3}) {
    law::Worst error;
    for (const double e : {0.0, 0.2, 0.5, 0.8, 1.0}) {
      for (int i = 0; i < 20; ++i) {
        const double height = 0.3 + 0.037 * i;
        const double reached = height_after(e, height, step), kept = std::sqrt(reached / height);
        if (e == 0) {
          EXPECT_LE(reached, 9.81 * step * step + 2.5e-5 * height) << "it may be a step above the ground";
          continue;
        }
        error.see(std::abs(kept - e), "restitution", e);
        EXPECT_LE(kept, e + 1e-3) << "no energy comes from nowhere";
      }
    }
    expect_law("bounce", fmt::format("fall of 0.3 to 1 m in steps of {} ms: error of the restitution", 1e3 * step),
               "height e^2 h after a fall from h", error, 2e-3 + 20 * step * step, "1");
  }
}

TEST(Bounce, WhatIsSlowOrWasPutThereOrIsNotRoundDoesNotBounce) {
  const auto bounce = [](ContactPoint c, const ContactParameters& p) {
    begin_bounce(c, p, {}, dt);
    return c.bounce;
  };
  EXPECT_DOUBLE_EQ(bounce(falling(0, 2), round_thing(0.6)), 1.2);
  EXPECT_LT(bounce(falling(0, 0.09), round_thing(0.6)), 0);
  EXPECT_LT(bounce(falling(0, -2), round_thing(0.6)), 0) << "it leaves";
  EXPECT_LT(bounce(falling(0, 2), parameters()), 0);
  ContactPoint deep = falling(0, 2);
  deep.lift = depenetration_speed;
  EXPECT_LT(bounce(deep, round_thing(0.6)), 0);
  EXPECT_DOUBLE_EQ(bounce(falling(0, 2), round_thing(0)), 0.01) << "a dead ball comes out of a wall all the same";
}

// Rule: after its bounce a point is free, as long as it leaves, and then its spring's.
TEST(Bounce, GoesOnUntilThePointComesBack) {
  ContactPoint c = falling(1e-3, -2);
  c.bounce = 1.2;
  c.stretch = {1, 0, 0};
  c.last_normal_force = 1000;
  go_on_bouncing(c);
  EXPECT_EQ(c.bounce, 0);
  EXPECT_EQ(norm(c.stretch) + c.last_normal_force, 0) << "the impulse is no memory of a spring";
  EXPECT_EQ(c.state, ContactState::open);
  c.velocity.z = -0.01;
  go_on_bouncing(c);
  EXPECT_LT(c.bounce, 0);
  ContactPoint resting = falling(1e-3, 0);
  resting.stretch = {1, 0, 0};
  go_on_bouncing(resting);
  EXPECT_EQ(resting.stretch.x, 1);
}

// Law: in the step of the bounce the normal velocity is the bounce's, whatever else pushes, and friction stops the point along the
// surface within its cone.
TEST(Bounce, TheStepEndsWithItsVelocity) {
  const ContactParameters p = round_thing(0.6);
  ContactPoint c = falling(1e-3, 2);
  begin_bounce(c, p, {}, dt);
  const double b = implicit_damping(c, p, dt);
  const double v = (p.mass * -2 + dt * resting_force(c, p, dt)) / (p.mass + dt * b);  // of a mass alone
  EXPECT_NEAR(v, 1.2, 1e-5);
  EXPECT_LT(v, 1.2);
  EXPECT_EQ(implicit_tangent_damping(c, p, dt), b);
}

}  // namespace
}  // namespace murosimf::collision
