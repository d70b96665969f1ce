#include "murosimf/geometry/volume.h"

#include <gtest/gtest.h>

#include "tests/geometry/volume_fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;

/// A tetrahedron with unequal sides; its axis-aligned box has its middle at the origin.
Shape tetrahedron() {
  auto hull = std::make_shared<ConvexHull>();
  hull->vertices = {{-0.1, -0.2, -0.05}, {0.1, -0.1, -0.05}, {0, 0.2, -0.05}, {0.03, 0, 0.05}};
  hull->faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& face : hull->faces) {
    const Vec3d n =
        cross(hull->vertices[face[1]] - hull->vertices[face[0]], hull->vertices[face[2]] - hull->vertices[face[0]]);
    hull->normals.push_back((1 / norm(n)) * n);
  }
  return Convex{hull};
}

std::vector<Shape> finite_shapes() {
  std::vector<Shape> shapes = fixtures::shapes_of_all_kinds();
  shapes.push_back(Cylinder{0.2, 0.01});
  shapes.push_back(Ellipsoid{{0.3, 0.1, 0.2}});
  shapes.push_back(Capsule{0.1, 0});
  shapes.push_back(tetrahedron());
  return shapes;
}

// Law: a bound of a shape, in any frame and moved with a body, encloses its surface.
TEST(Volume, BoundsEncloseShapes) {
  Dice dice("bounds");
  for (const Shape& shape : finite_shapes()) {
    const std::vector<Vec3d> samples = fixtures::surface_samples(shape);
    for (int i = 0; i < 3; ++i) {
      const Transformd local{dice.vector(1), dice.turn()}, body{dice.vector(1), dice.turn()};
      fixtures::for_all_kinds([&]<class V>(const V&) {
        const V v = moved(fit<V>(shape, local), body.position, body.orientation);
        double worst = -1;
        for (const Vec3d& p : samples) {
          const Vec3d in_body = local.position + local.orientation * p;
          worst = std::fmax(worst, fixtures::outside(v, body.position + body.orientation * in_body));
        }
        EXPECT_LT(worst, 1e-12) << shape_name(shape) << ", " << typeid(V).name();
      });
    }
  }
}

/// How far the least of the samples is from the surface of the bound.
template <class V>
double slack(const Shape& shape, const Transformd& at) {
  const V v = fit<V>(shape, at);
  double nearest = 1e300;
  for (const Vec3d& p : fixtures::surface_samples(shape)) {
    nearest = std::fmin(nearest, -fixtures::outside(v, at.position + at.orientation * p));
  }
  return nearest;
}

// Rule: bounds are tight: the shape touches its bound, within what the sampling leaves open.
TEST(Volume, BoundsTouchShapes) {
  Dice dice("tight");
  for (const Shape& shape : finite_shapes()) {
    const Transformd at{dice.vector(1), dice.turn()};
    fixtures::for_all_kinds([&]<class V>(const V&) { EXPECT_LT(slack<V>(shape, at), 1e-3) << shape_name(shape); });
  }
}

TEST(Volume, BoundsOfBallsAndCapsulesAreExact) {
  const Transformd at{{1, 2, 3}, rotation_x(0.3)};
  EXPECT_EQ(fit<BoundingSphere>(Sphere{0.2}, at).radius, 0.2);
  const BoundingCapsule capsule = fit<BoundingCapsule>(Capsule{0.1, 0.4}, at);
  EXPECT_EQ(capsule.radius, 0.1);
  EXPECT_NEAR(norm(capsule.half_axis), 0.4, 1e-15);
  EXPECT_EQ(norm(fit<Obb>(Box{{0.1, 0.2, 0.3}}, at).half - Vec3d{0.1, 0.2, 0.3}), 0);
}

// Law: what two volumes hold, their common volume holds.
TEST(Volume, MergedHoldsBoth) {
  Dice dice("merge");
  fixtures::for_all_kinds([&]<class V>(const V&) {
    double worst = -1;
    for (int i = 0; i < 500; ++i) {
      const V a = fixtures::random_volume<V>(dice), b = fixtures::random_volume<V>(dice);
      const V both = merged(a, b);
      for (int k = 0; k < 20; ++k) {
        worst = std::fmax(worst, fixtures::outside(both, fixtures::point_in(a, dice)));
        worst = std::fmax(worst, fixtures::outside(both, fixtures::point_in(b, dice)));
      }
    }
    EXPECT_LT(worst, 1e-12) << typeid(V).name();
  });
}

// Closed form: the sphere about two spheres reaches from one far side to the other; one inside the other is no change.
TEST(Volume, MergedSpheres) {
  const BoundingSphere two = merged(BoundingSphere{{0, 0, 0}, 1}, BoundingSphere{{4, 0, 0}, 2});
  EXPECT_EQ(two.radius, 3.5);
  EXPECT_EQ(norm(two.center - Vec3d{2.5, 0, 0}), 0);
  const BoundingSphere big{{0, 0, 0}, 3}, small{{1, 0, 0}, 1};
  EXPECT_EQ(merged(big, small).radius, 3);
  EXPECT_EQ(norm(merged(small, big).center), 0);
  EXPECT_EQ(merged(big, big).radius, 3);
}

// Rule: size is the radius of a sphere about the volume: nothing in it is farther from its middle, and something is as
// far.
TEST(Volume, SizeIsTheRadiusOfTheSphereAround) {
  EXPECT_EQ(size(BoundingSphere{{1, 2, 3}, 0.4}), 0.4);
  EXPECT_NEAR(size(Aabb{{1, 2, 3}, {0.2, 0.3, 0.6}}), 0.7, 1e-15);
  EXPECT_NEAR(size(Obb{{1, 2, 3}, rotation_y(1), {0.2, 0.3, 0.6}}), 0.7, 1e-15);
  EXPECT_NEAR(size(BoundingCapsule{{1, 2, 3}, {0, 3, 4}, 0.5}), 5.5, 1e-15);
}

}  // namespace
}  // namespace murosimf::geometry
