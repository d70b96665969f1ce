#include "murosimf/geometry/ray.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;

Shape octahedron(const Vec3d& size) {
  auto hull = std::make_shared<ConvexHull>();
  hull->vertices = {{size.x, 0, 0}, {-size.x, 0, 0}, {0, size.y, 0}, {0, -size.y, 0}, {0, 0, size.z}, {0, 0, -size.z}};
  hull->faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (const auto& face : hull->faces) {
    const Vec3d& corner = hull->vertices[face[0]];
    const Vec3d n = cross(hull->vertices[face[1]] - corner, hull->vertices[face[2]] - corner);
    hull->normals.push_back((1 / norm(n)) * n);
  }
  return Convex{hull};
}

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes = fixtures::shapes_of_all_kinds();
  shapes.push_back(octahedron({0.1, 0.15, 0.2}));
  shapes.push_back(Plane{});
  return shapes;
}

/// Of a point of the world from a shape.
double outside(const Shape& shape, const Transformd& at, const Vec3d& p) {
  return fixtures::outside(shape, transposed_times(at.orientation, p - at.position));
}

/// The first point of a ray in a shape, by steps of half a millimeter and bisection; negative if there is none.
double walk(const Ray& ray, const Shape& shape, const Transformd& at, double length) {
  const auto out = [&](double t) { return outside(shape, at, ray.origin + t * ray.direction); };
  constexpr double step = 5e-4;
  if (out(0) <= 0) return 0;
  for (double t = step; t < length; t += step) {
    if (out(t) > 0) continue;
    double low = t - step, high = t;
    while (high - low > 1e-13) (out(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    return high;
  }
  return -1;
}

/// A ray from somewhere around to a place in or near the shape.
Ray random_ray(Dice& dice, const Transformd& at) {
  const Vec3d from = at.position + dice.uniform(0, 0.5) * dice.unit();
  const Vec3d way = at.position + dice.vector(0.1) - from;
  return {from, (1 / norm(way)) * way};
}

// Law: what walking along the ray finds, for every kind. The walk may step over a corner that the ray cuts by less than
// a step, so rays that barely graze count for nothing.
TEST(Ray, MeetsWhatAWalkFinds) {
  Dice dice("rays");
  for (const Shape& shape : all_shapes()) {
    int hits = 0, misses = 0, grazes = 0;
    for (int i = 0; i < 300; ++i) {
      const Transformd at{dice.vector(0.3), dice.turn()};
      const Ray ray = random_ray(dice, at);
      const double walked = walk(ray, shape, at, 1.5);
      const auto met = meet(ray, shape, at);
      if (walked < 0) {
        ++misses;
        if (met && met->distance < 1.5) {
          ++grazes;
          EXPECT_GT(outside(shape, at, ray.origin + (met->distance + 5e-4) * ray.direction), 0) << shape_name(shape);
        }
        continue;
      }
      ++hits;
      ASSERT_TRUE(met) << shape_name(shape);
      EXPECT_NEAR(met->distance, walked, 1e-9) << shape_name(shape);
    }
    EXPECT_GT(hits, 50) << shape_name(shape);
    EXPECT_GT(misses, 10) << shape_name(shape);
    EXPECT_LT(grazes, 3) << shape_name(shape);
  }
}

// Law: the normal is a unit vector against the ray, and the slope of the distance from the surface.
TEST(Ray, NormalsPointOutwards) {
  Dice dice("normals");
  for (const Shape& shape : all_shapes()) {
    for (int i = 0; i < 300; ++i) {
      const Transformd at{dice.vector(0.3), dice.turn()};
      const Ray ray = random_ray(dice, at);
      const auto met = meet(ray, shape, at);
      if (!met || met->distance == 0) continue;
      EXPECT_NEAR(norm(met->normal), 1, 1e-12) << shape_name(shape);
      EXPECT_LT(dot(met->normal, ray.direction), 1e-9) << shape_name(shape);
      const Vec3d point = ray.origin + met->distance * ray.direction;
      constexpr double off = 1e-6;
      EXPECT_NEAR(outside(shape, at, point + off * met->normal), off, 0.05 * off) << shape_name(shape);
    }
  }
}

// Rule: from inside, at once, and against the ray.
TEST(Ray, FromInsideMeetsAtOnce) {
  Dice dice("inside");
  for (const Shape& shape : all_shapes()) {
    const Transformd at{dice.vector(1), dice.turn()};
    const Ray ray{at.position - 0.01 * at.orientation.z, dice.unit()};
    const auto met = meet(ray, shape, at);
    ASSERT_TRUE(met) << shape_name(shape);
    EXPECT_EQ(met->distance, 0);
    EXPECT_LT(fixtures::difference(met->normal, -ray.direction), 1e-15);
  }
}

TEST(Ray, ClosedForms) {
  const Transformd at{{5, 0, 0}, {}};
  const Ray forward{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(meet(forward, Sphere{0.5}, at)->distance, 4.5);
  EXPECT_EQ(meet(forward, Box{{1, 2, 3}}, at)->distance, 4);
  EXPECT_EQ(meet(forward, Capsule{0.5, 1}, at)->distance, 4.5);
  EXPECT_EQ(meet(forward, Cylinder{0.25, 1}, at)->distance, 4.75);
  EXPECT_EQ(meet(forward, Ellipsoid{{1, 2, 3}}, at)->distance, 4);
  EXPECT_NEAR(meet(forward, octahedron({1, 2, 3}), at)->distance, 4, 1e-15);
  EXPECT_EQ(meet({{0, 0, 2}, {0, 0, -1}}, Plane{}, {})->distance, 2);
  // along an axis, beside and behind
  EXPECT_EQ(meet({{5, 0, 9}, {0, 0, -1}}, Cylinder{0.25, 1}, at)->distance, 8);
  EXPECT_EQ(meet({{5, 0.1, 9}, {0, 0, -1}}, Box{{1, 2, 3}}, at)->distance, 6);
  for (const Shape& shape : fixtures::shapes_of_all_kinds()) {
    EXPECT_FALSE(meet({{0, 1, 0}, {1, 0, 0}}, shape, at)) << shape_name(shape);
    EXPECT_FALSE(meet({{9, 0, 0}, {1, 0, 0}}, shape, at)) << shape_name(shape);
  }
  EXPECT_FALSE(meet({{0, 0, 2}, {1, 0, 0}}, Plane{}, {}));
}

// A ray of a kilometer still meets a ball of 10 cm within a micrometer.
TEST(Ray, IsExactFromAfar) {
  const Vec3d away{800, 600, 0};
  const auto met = meet({away, {-0.8, -0.6, 0}}, Sphere{0.1}, {});
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->distance, 999.9, 1e-9);
}

}  // namespace
}  // namespace murosimf::geometry
