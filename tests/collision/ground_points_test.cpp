#include "murosimf/collision/ground_points.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::collision {
namespace {

using fixtures::Dice;
using fixtures::difference;
using fixtures::outside;
using fixtures::shapes_of_all_kinds;
using fixtures::surface_samples;

GroundShape random_shape(const Shape& shape, Dice& dice) {
  const Vec3d place = dice.vector(0.2);
  return collision::ground_shape(3, fixtures::placed(shape, place, dice.turn()), 16);
}

/// A place near the plane, so that about half of all poses touch.
GroundPlane plane_near(const Vec3d& normal, const GroundShape& g, const Vec3d& r, const Mat3d& R, Dice& dice) {
  return {normal, dot(normal, r + R * g.placed.position) + g.reach * dice.uniform(-1.2, 1.2), {}};
}

Vec3d to_shape(const GroundShape& g, const Vec3d& r, const Mat3d& R, const Vec3d& point) {
  return transposed_times(R * g.placed.orientation, point - (r + R * g.placed.position));
}

/// One row about contact points on the ground.
void expect_points(const std::string& law, const std::string& source, const law::Measured& error, double limit,
                   const std::string& unit) {
  law::expect_below({.law = law, .level = "ground points, all shapes", .source = source}, error, limit, unit);
}

// Both sides are exact (the samples lie on the surface), so the tolerance is rounding: 1e-14 of lengths below 1 m. The
// grid of samples is 2 degrees and 1/40 of a length wide.
TEST(GroundPoints, LowestPointAgainstSamples) {
  law::Worst below, above;
  Dice dice("lowest point");
  for (const Shape& shape : shapes_of_all_kinds()) {
    const std::vector<Vec3d> samples = surface_samples(shape);
    for (int i = 0; i < 40; ++i) {
      const GroundShape g = random_shape(shape, dice);
      const Vec3d r = dice.vector(0.5);
      const Mat3d R = dice.turn();
      const GroundPlane plane = plane_near(dice.unit(), g, r, R, dice);
      const double lowest = lowest_point(g, r, R, plane);
      double sampled = 1e9;
      for (const Vec3d& p : samples) {
        const Vec3d world = r + R * (g.placed.position + g.placed.orientation * p);
        sampled = std::fmin(sampled, dot(plane.normal, world) - plane.height);
      }
      below.see(lowest - sampled, shape_name(shape), i);
      above.see((sampled - lowest) / g.reach, shape_name(shape), i);
    }
  }
  expect_points("lowest point of a shape: how far samples are below it", "none is below", below, 1e-14, "m");
  expect_points("lowest point of a shape: distance of the lowest sample, in sizes of the shape",
                "one is there, up to the grid of samples", above, 0.02, "");
}

// There are none if the shape is clear of the ground. Tolerance: rounding.
TEST(GroundPoints, ContactsAreWhereTheyShouldBe) {
  law::Worst depth_error, outside_error, deepest_error, surface_error;
  Dice dice("ground contacts");
  for (const Shape& shape : shapes_of_all_kinds()) {
    int touching = 0, clear = 0;
    for (int i = 0; i < 200; ++i) {
      const GroundShape g = random_shape(shape, dice);
      const Vec3d r = dice.vector(0.5);
      const Mat3d R = dice.turn();
      const GroundPlane plane = plane_near(dice.unit(), g, r, R, dice);
      std::vector<ContactPoint> found;
      find_ground_contacts(g, r, R, plane, found);
      const double lowest = lowest_point(g, r, R, plane);
      if (lowest >= 0) {
        EXPECT_TRUE(found.empty()) << shape_name(shape);
        ++clear;
        continue;
      }
      ++touching;
      ASSERT_FALSE(found.empty()) << shape_name(shape);
      double deepest = 0;
      for (const ContactPoint& c : found) {
        EXPECT_EQ(c.object, 3);
        EXPECT_EQ(difference(c.normal, plane.normal), 0);
        EXPECT_GT(c.depth, 0);
        depth_error.see(std::abs(c.depth - plane.height + dot(plane.normal, c.point)), shape_name(shape), i);
        outside_error.see(outside(shape, to_shape(g, r, R, c.point)), shape_name(shape), i);
        deepest = std::fmax(deepest, c.depth);
      }
      deepest_error.see(std::abs(deepest + lowest), shape_name(shape), i);
      for (const ContactPoint& c : found) {
        if (c.depth == deepest)
          surface_error.see(std::abs(outside(shape, to_shape(g, r, R, c.point))), shape_name(shape), i);
      }
    }
    EXPECT_GT(touching, 40) << shape_name(shape);
    EXPECT_GT(clear, 10) << shape_name(shape);
  }
  expect_points("contact points: error of the depth", "distance below the ground", depth_error, 1e-15, "m");
  expect_points("contact points: distance outside of the shape", "none is outside", outside_error, 1e-14, "m");
  expect_points("deepest contact point: error of the depth", "the shape's lowest point", deepest_error, 1e-15, "m");
  expect_points("deepest contact point: distance from the shape's surface", "it lies on it", surface_error, 1e-14, "m");
}

std::vector<ContactPoint> standing(const Shape& shape, double sink) {
  GroundShape g = collision::ground_shape(0, fixtures::placed(shape), 0);
  GroundPlane plane;
  std::vector<ContactPoint> found;
  const double lowest = lowest_point(g, {}, {}, plane);
  find_ground_contacts(g, {0, 0, -lowest - sink}, {}, plane, found);
  return found;
}

// Law: what stands flat stands on its corners, all equally deep: a box on four, a cylinder on four of the rim, a
// standing capsule, a ball and an ellipsoid on one. Tolerance: rounding.
TEST(GroundPoints, StandingShapes) {
  const std::pair<Shape, std::size_t> table[] = {{Box{{0.1, 0.2, 0.3}}, 4},
                                                 {Cylinder{0.1, 0.3}, 4},
                                                 {Capsule{0.1, 0.3}, 1},
                                                 {Sphere{0.1}, 1},
                                                 {Ellipsoid{{0.1, 0.2, 0.3}}, 1}};
  for (const auto& [shape, count] : table) {
    const auto found = standing(shape, 1e-3);
    ASSERT_EQ(found.size(), count) << shape_name(shape);
    Vec3d sum;
    for (const ContactPoint& c : found) {
      EXPECT_NEAR(c.depth, 1e-3, 1e-15);
      sum += c.point;
    }
    EXPECT_NEAR(sum.x, 0, 1e-15);  // the corners surround the middle
    EXPECT_NEAR(sum.y, 0, 1e-15);
  }
}

// Law: a lying capsule and a lying cylinder touch with both ends and roll on their radius; a box has corners.
// Tolerance: rounding.
TEST(GroundPoints, LyingShapes) {
  for (const Shape& shape : {Shape(Capsule{0.1, 0.3}), Shape(Cylinder{0.1, 0.3})}) {
    GroundShape g = collision::ground_shape(0, fixtures::placed(shape), 0);
    std::vector<ContactPoint> found;
    find_ground_contacts(g, {0, 0, 0.1 - 1e-3}, rotation_y(pi / 2), GroundPlane{}, found);
    ASSERT_EQ(found.size(), 2u) << shape_name(shape);
    for (const ContactPoint& c : found) {
      EXPECT_NEAR(c.depth, 1e-3, 1e-15);
      EXPECT_EQ(c.radius, 0.1);
      EXPECT_NEAR(std::fabs(c.point.x), 0.3, 1e-15);
    }
  }
  EXPECT_EQ(standing(Sphere{0.07}, 1e-3)[0].radius, 0.07);
  EXPECT_EQ(standing(Box{{0.1, 0.2, 0.3}}, 1e-3)[0].radius, 0);
}

// Rule: features are numbers of corners: each once, rising, within the eight of the shape, and the same corner keeps
// its number when the pose changes a little, so that the law's memory finds it again.
TEST(GroundPoints, FeaturesAreStable) {
  Dice dice("features");
  for (const Shape& shape : shapes_of_all_kinds()) {
    for (int i = 0; i < 100; ++i) {
      const GroundShape g = random_shape(shape, dice);
      const Vec3d r = dice.vector(0.5);
      const Mat3d R = dice.turn();
      // deep: everything touches, so that the two poses have the same points
      const Vec3d n = dice.unit();
      const GroundPlane plane{n, dot(n, r + R * g.placed.position) + 0.99 * g.reach, {}};
      const Mat3d R_next = to_matrix(exponential(dice.vector(1e-6))) * R;
      std::vector<ContactPoint> now, next;
      find_ground_contacts(g, r, R, plane, now);
      find_ground_contacts(g, r + dice.vector(1e-6), R_next, plane, next);
      for (std::size_t k = 0; k < now.size(); ++k) {
        EXPECT_GE(now[k].feature, 16u);
        EXPECT_LT(now[k].feature, 16u + features_of(shape));
        if (k > 0) {
          EXPECT_GT(now[k].feature, now[k - 1].feature);
        }
      }
      for (const ContactPoint& a : now) {
        for (const ContactPoint& b : next) {
          // a rim point goes round faster than the pose turns when the axis stands nearly upright
          if (a.feature == b.feature) {
            EXPECT_LT(difference(a.point, b.point), 1e-4) << shape_name(shape);
          }
        }
      }
    }
  }
}

// Rule: a point that is exactly on the ground does not press on it; the shape counts as tested.
TEST(GroundPoints, JustTouchingIsNoContact) {
  const GroundShape g = collision::ground_shape(0, fixtures::placed(Box{{0.25, 0.5, 0.125}}), 0);
  std::vector<ContactPoint> found;
  EXPECT_TRUE(find_ground_contacts(g, {0, 0, 0.125}, {}, GroundPlane{}, found));
  EXPECT_TRUE(found.empty());
}

// Rule: contacts are appended; what was found before stays.
TEST(GroundPoints, Appends) {
  const GroundShape g = collision::ground_shape(0, fixtures::placed(Sphere{0.1}), 0);
  std::vector<ContactPoint> found(2);
  found[0].depth = 5;
  find_ground_contacts(g, {0, 0, 0.05}, {}, GroundPlane{}, found);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].depth, 5);
  EXPECT_NEAR(found[2].depth, 0.05, 1e-16);
}

// Rule: shapes of a model: those that collide, planes excluded, eight features each, with their object and reach.
TEST(GroundPoints, ShapesOfAModel) {
  using namespace properties;
  PlacedShape ghost = fixtures::placed(Sphere{0.3});
  ghost.collides = false;
  const Model model("m", Chain{}
                             .base()
                             .with(shapes, {fixtures::placed(Plane{}), fixtures::placed(Sphere{0.1}), ghost})
                             .translation({1, 0, 0})
                             .with(mass, 1)
                             .translation({1, 0, 0})
                             .with(shapes, {fixtures::placed(Box{{3, 4, 12}}), fixtures::placed(Capsule{1, 2})}));
  const auto found = ground_shapes(model);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].object, 0);
  EXPECT_EQ(found[0].reach, 0.1);
  EXPECT_EQ(found[1].object, 2);
  EXPECT_EQ(found[1].reach, 13);
  EXPECT_EQ(found[2].reach, 3);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(found[i].first_feature, i * 8);
}

}  // namespace
}  // namespace murosimf::collision
