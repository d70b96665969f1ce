// When a moving sphere first touches a shape, in closed form; and where a fast body is stopped.
#include "murosimf/collision/continuous_collision.h"

#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/collision/static_compound.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

constexpr double dt = 0.01;

TEST(FirstTouchOf, OfAFace) {
  // 0.5 m from the middle of the sphere to the face at x = 0.4, less the radius, at 30 m/s
  const auto time = first_touch({-0.1, 0.02, 0}, 0.3, {30, 0, 0}, Box{{0.1, 1, 1}}, {{0.5, 0, 0}, Mat3d{}}, dt);
  ASSERT_TRUE(time);
  EXPECT_NEAR(time->time, (0.5 - 0.3) / 30, 1e-7);
  EXPECT_FALSE(first_touch({-0.1, 0.02, 0}, 0.3, {30, 0, 0}, Box{{0.1, 1, 1}}, {{0.5, 0, 0}, Mat3d{}}, 0.006));
  EXPECT_FALSE(first_touch({-0.1, 0.02, 0}, 0.3, {-30, 0, 0}, Box{{0.1, 1, 1}}, {{0.5, 0, 0}, Mat3d{}}, dt));
}

// |c + t v| = R + r
TEST(FirstTouchOf, OfASphere) {
  for (const double aside : {0.0, 0.05, 0.1, 0.139}) {
    const Vec3d center{-0.2, aside, 0.01}, velocity{25, 1, -2};
    const double reach = 0.1 + 0.04, a = dot(velocity, velocity), b = dot(center, velocity),
                 c = dot(center, center) - reach * reach, under = b * b - a * c;
    const auto time = first_touch(center, 0.04, velocity, Sphere{0.1}, {}, dt);
    ASSERT_EQ(time.has_value(), under > 0) << aside;
    if (time) {
      EXPECT_NEAR(time->time, (-b - std::sqrt(under)) / a, 1e-7) << aside;
    }
  }
}

TEST(FirstTouchOf, OfAThinBarIsFoundWhateverTheWay) {
  const Shape bar = Cylinder{0.01, 0.5};
  for (int i = 0; i < 100; ++i) {
    const double before = 0.08 + 0.0021 * i;
    const auto time = first_touch({-before, 0, 0}, 0.065, {30, 0, 0}, bar, {}, dt);
    ASSERT_TRUE(time) << before;
    EXPECT_NEAR(time->time, (before - 0.075) / 30, 1e-7);
  }
}

TEST(FirstTouchOf, OfWhatIsInEachOtherIsNowUnlessTheyPart) {
  const auto touch = first_touch({0.13, 0, 0}, 0.04, {-30, 0, 0}, Sphere{0.1}, {}, dt);
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->time, 0);
  EXPECT_NEAR(touch->normal.x, -1, 1e-12);
  EXPECT_FALSE(first_touch({0.13, 0, 0}, 0.04, {30, 0, 0}, Sphere{0.1}, {}, dt));
}

struct Throw : Movers {
  Throw() { add("ball", ball(0.04, 1)); }
  void fly(const Vec3d& from, const Vec3d& velocity) {
    place(all[0], from);
    launch(all[0], velocity);
    start_step();
    for (MovingEntity& one : all) one.separation[0] = {};
    stop_at_touch(all, {}, nothing, {}, dt);
  }
  /// Where it will be after the step.
  [[nodiscard]] Vec3d end(int i) const { return all[i].r[0] + dt * all[i].v[0] + all[i].separation[0]; }
  StaticCompound nothing{nullptr};
};

TEST(StopAtTouch, SlowBodiesAreLeftAlone) {
  Throw flight;
  flight.add("other", ball(0.04, 1));
  flight.place(flight.all[1], {0.083, 0, 0});
  flight.fly({}, {1.9, 0, 0});  // 19 mm: less than half of its radius
  EXPECT_EQ(norm(flight.all[0].separation[0]), 0);
}

// The first one stops, the second one sees where.
TEST(StopAtTouch, TwoBallsEndWhereTheyMeet) {
  Throw flight;
  flight.add("other", ball(0.04, 1));
  flight.place(flight.all[1], {0.3, 0, 0});
  Movers::launch(flight.all[1], {-12, 0, 0});
  flight.fly({}, {30, 0, 0});
  EXPECT_NEAR(norm(flight.end(1) - flight.end(0)), 0.08 - 0.1 * 0.04, 3e-6) << "cores touch";
}

// It comes from aside: what is left of the step goes along the surface.
TEST(StopAtTouch, TheWayGoesOnAlongTheSurface) {
  Throw flight;
  flight.add("other", ball(0.04, 1));
  flight.place(flight.all[1], {0.1, 0, 0});
  Movers::launch(flight.all[1], {});
  flight.all[1].entity->column(properties::dynamic).values[0] = 0;  // it cannot be pushed
  flight.fly({}, {20, 5, 0});
  const auto touch = first_touch({}, 0.036, {20, 5, 0}, Sphere{0.04}, {{0.1, 0, 0}, Mat3d{}}, dt);
  ASSERT_TRUE(touch);
  const Vec3d along = flight.end(0) - touch->time * Vec3d{20, 5, 0};
  EXPECT_NEAR(dot(along, touch->normal), 0, 1e-12);
  EXPECT_NEAR(norm(along), (dt - touch->time) * std::sqrt(425 - std::pow(dot(Vec3d{20, 5, 0}, touch->normal), 2)),
              1e-11);
}

TEST(StopAtTouch, WhatFliesAlongIsNoObstacle) {
  Throw flight;
  flight.add("other", ball(0.04, 1));
  flight.place(flight.all[1], {0.1, 0, 0});
  Movers::launch(flight.all[1], {30, 0, 0});
  flight.fly({}, {30, 0, 0});
  EXPECT_EQ(norm(flight.all[0].separation[0]), 0);
}

}  // namespace
}  // namespace murosimf::collision
