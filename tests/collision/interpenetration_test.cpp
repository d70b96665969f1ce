// Detection of entities that are too deep in others, or have passed through them.
#include "murosimf/collision/interpenetration.h"

#include <gtest/gtest.h>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/pair_finder.h"
#include "murosimf/geometry/hull.h"
#include "tests/collision/movers.h"

namespace murosimf::collision {
namespace {

using namespace std::chrono_literals;
using fixtures::placed;

TEST(Interpenetration, ThicknessIsTheLeastWidth) {
  EXPECT_EQ(thickness(Sphere{0.1}), 0.2);
  EXPECT_EQ(thickness(Box{{0.3, 0.1, 0.2}}), 0.2);
  EXPECT_EQ(thickness(Capsule{0.05, 0.3}), 0.1);
  EXPECT_EQ(thickness(Cylinder{0.05, 0.01}), 0.02);
  EXPECT_EQ(thickness(Cylinder{0.05, 0.2}), 0.1);
  EXPECT_EQ(thickness(Ellipsoid{{0.3, 0.04, 0.2}}), 0.08);
  EXPECT_TRUE(std::isinf(thickness(Plane{})));
  // a regular tetrahedron of edge a: its height, a sqrt(2/3), is more than the distance of two opposite edges, a / sqrt(2)
  const std::vector<Vec3d> corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const Convex tetrahedron{std::make_shared<const ConvexHull>(geometry::make_hull(corners).hull)};
  EXPECT_NEAR(thickness(tetrahedron), 4 / std::sqrt(3.0), 1e-12);
}

ModelPtr plate() {
  return std::make_shared<const Model>("plate", Chain{}
                                                    .base("plate")
                                                    .with(properties::mass, 1.0)
                                                    .with(properties::inertia, diagonal(0.01))
                                                    .with(properties::shapes, Shapes{placed(Box{{0.01, 0.2, 0.2}})}));
}

/// A plate 20 mm thick across x, and a ball of radius 40 mm.
struct Meeting : Movers {
  Meeting() {
    add("plate", plate());
    add("ball", ball(0.04, 1));
    for (const MovingEntity& one : all) finder.add(one);
    for (const MovingEntity& one : all) set.entities.push_back(one.number);
    set.parameters = finder.parameters();
  }
  void ball_at(double x, double speed, Duration now) {
    place(all[1], {x, 0, 0});
    launch(all[1], {speed, 0, 0});
    start_step();
    finder.find(all, set);
    note_interpenetrations(all, dt, now, set);
  }
  [[nodiscard]] const std::vector<Interpenetration>& found() const { return set.interpenetrations; }

  static constexpr double dt = 1e-3;
  PairFinder finder{MaterialTable{}, ContactConditions{}, Vec3d{}};
};

// In numbers: the ball's surface is 10 mm in the plate when its middle is 40 mm from the plate's.
TEST(Interpenetration, BeyondHalfOfTheThinnerOneIsNoted) {
  Meeting meeting;
  meeting.ball_at(-0.049, 9, 1ms);
  meeting.ball_at(-0.0405, 9, 2ms);
  EXPECT_TRUE(meeting.found().empty());
  meeting.ball_at(-0.039, 9, 3ms);
  ASSERT_EQ(meeting.found().size(), 1u);
  const Interpenetration& one = meeting.found()[0];
  EXPECT_EQ(one.a, meeting.all[0].number);
  EXPECT_EQ(one.b, meeting.all[1].number);
  EXPECT_NEAR(one.depth, 0.011, 1e-12);
  EXPECT_EQ(one.thickness, 0.02);
  EXPECT_FALSE(one.crossed);
  EXPECT_EQ(one.time, 3ms);
  meeting.ball_at(-0.03, 9, 4ms);
  EXPECT_EQ(meeting.found().size(), 1u) << "each pair once";
}

TEST(Interpenetration, ComingOutOnTheOtherSideIsNoted) {
  Meeting meeting;
  meeting.ball_at(-0.045, 60, 1ms);
  EXPECT_TRUE(meeting.found().empty());
  meeting.ball_at(0.045, 60, 2ms);
  ASSERT_EQ(meeting.found().size(), 1u);
  EXPECT_TRUE(meeting.found()[0].crossed);
}

// An entity that was placed there is separated slowly; a warning has been given before.
TEST(Interpenetration, WhatWasPutThereDoesNotCount) {
  Meeting meeting;
  meeting.ball_at(-0.03, 0, 1ms);
  ASSERT_FALSE(meeting.set.points.empty());
  EXPECT_GT(meeting.set.points[0].lift, 0);
  meeting.ball_at(-0.03, 0, 2ms);
  EXPECT_TRUE(meeting.found().empty());
}

// It comes from before the plate to beyond its middle in one step, from where the shortest way out is on: it was not put there.
TEST(Interpenetration, BeyondTheMiddleInOneStepIsNoted) {
  Meeting meeting;
  meeting.ball_at(-0.06, 62, 1ms);
  meeting.ball_at(0.002, 62, 2ms);
  EXPECT_GT(meeting.set.points[0].lift, 0);
  ASSERT_EQ(meeting.found().size(), 1u);
  EXPECT_TRUE(meeting.found()[0].crossed);
}

}  // namespace
}  // namespace murosimf::collision
