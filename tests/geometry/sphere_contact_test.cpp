#include "murosimf/geometry/sphere_contact.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;
using fixtures::difference;
using fixtures::outside;
using fixtures::surface_samples;

/// All shapes whose distance the fixtures know exactly. The ellipsoid has its own test.
std::vector<Shape> exact_shapes() {
  std::vector<Shape> shapes;
  for (const Shape& shape : fixtures::shapes_of_all_kinds()) {
    if (!std::holds_alternative<Ellipsoid>(shape)) shapes.push_back(shape);
  }
  shapes.push_back(Plane{});
  return shapes;
}

/// One row about the contact of a sphere.
void expect_contact(const std::string& law, const std::string& source, const law::Measured& error, double limit) {
  law::expect_below({.law = law, .level = "sphere contact, exact shapes", .source = source}, error, limit, "m");
}

// Law: the sphere touches if its center is inside the shape or nearer to it than its radius; the depth is the radius
// less (outside) or plus (inside) the distance to the nearest point of the surface; the normal is along that distance,
// outwards. Point and normal are checked exactly: the point is on the surface, that far from the center, and no point
// of the surface is nearer. Tolerance: rounding.
TEST(SphereContactTest, AgainstSamplesOfTheSurface) {
  Dice dice("sphere contact");
  const double radius = 0.04;
  law::Worst point_error, depth_error, center_error, nearer;
  for (const Shape& shape : exact_shapes()) {
    const std::vector<Vec3d> samples = surface_samples(shape);
    int touching = 0, clear = 0, deep = 0;
    for (int i = 0; i < 1500; ++i) {
      const Vec3d center = dice.vector(0.2);
      const double distance = outside(shape, center);
      const auto contact = sphere_contact(center, radius, shape);
      ASSERT_EQ(contact.has_value(), distance < radius) << shape_name(shape) << ' ' << distance;
      if (!contact) {
        ++clear;
        continue;
      }
      ++touching;
      if (distance < 0) ++deep;
      EXPECT_NEAR(norm(contact->normal), 1, 1e-15) << shape_name(shape);
      point_error.see(std::abs(outside(shape, contact->point)), shape_name(shape), i);
      depth_error.see(std::abs(contact->depth - (radius - distance)), shape_name(shape), i);
      center_error.see(difference(center, contact->point + (radius - contact->depth) * contact->normal),
                       shape_name(shape), i);
      double nearest = 1e9;
      for (const Vec3d& p : samples) nearest = std::fmin(nearest, norm(p - center));
      nearer.see(std::fabs(radius - contact->depth) - nearest, shape_name(shape), i);
    }
    EXPECT_GT(touching, 50) << shape_name(shape);
    EXPECT_GT(clear, 50) << shape_name(shape);
    EXPECT_GT(deep, 10) << shape_name(shape);
  }
  expect_contact("sphere touches shape: distance of the contact point from the surface", "it lies on it", point_error,
                 1e-15);
  expect_contact("sphere touches shape: error of the depth", "radius less the center's distance", depth_error, 1e-15);
  expect_contact("sphere touches shape: error of the center, from point, normal and depth", "the sphere's center",
                 center_error, 1e-15);
  expect_contact("sphere touches shape: how much nearer samples of the surface are", "none is nearer", nearer, 1e-15);
}

// Law: by hand, one case per shape: sphere of 0.1 m whose center is 0.05 m outside.
TEST(SphereContactTest, ByHand) {
  const struct {
    Shape shape;
    Vec3d center, point, normal;
  } table[] = {{Sphere{1}, {1.05, 0, 0}, {1, 0, 0}, {1, 0, 0}},
               {Box{{1, 2, 3}}, {0.5, -2.05, 1}, {0.5, -2, 1}, {0, -1, 0}},
               {Capsule{1, 2}, {0, 1.05, 1.5}, {0, 1, 1.5}, {0, 1, 0}},
               {Capsule{1, 2}, {0, 0, -3.05}, {0, 0, -3}, {0, 0, -1}},
               {Cylinder{1, 2}, {-1.05, 0, 1}, {-1, 0, 1}, {-1, 0, 0}},
               {Cylinder{1, 2}, {0.3, 0.4, 2.05}, {0.3, 0.4, 2}, {0, 0, 1}},
               {Plane{}, {7, 8, 0.05}, {7, 8, 0}, {0, 0, 1}}};
  for (const auto& row : table) {
    const auto contact = sphere_contact(row.center, 0.1, row.shape);
    ASSERT_TRUE(contact) << shape_name(row.shape);
    EXPECT_LT(difference(contact->point, row.point), 1e-15) << shape_name(row.shape);
    EXPECT_LT(difference(contact->normal, row.normal), 1e-15) << shape_name(row.shape);
    EXPECT_NEAR(contact->depth, 0.05, 1e-15) << shape_name(row.shape);
  }
}

// Law: at the edge of a box and the rim of a cylinder the normal points from the edge to the center. Tolerance:
// rounding.
TEST(SphereContactTest, EdgesAndRims) {
  const auto box = sphere_contact({1.03, 1.04, 0.2}, 0.1, Box{{1, 1, 1}});
  ASSERT_TRUE(box);
  EXPECT_LT(difference(box->normal, {0.6, 0.8, 0}), 1e-14);  // 0.03 and 0.04 carry the rounding of 1.03 and 1.04
  EXPECT_NEAR(box->depth, 0.05, 1e-15);
  const auto rim = sphere_contact({0, 1.03, -1.04}, 0.1, Cylinder{1, 1});
  ASSERT_TRUE(rim);
  EXPECT_LT(difference(rim->normal, {0, 0.6, -0.8}), 1e-14);
  EXPECT_NEAR(rim->depth, 0.05, 1e-15);
}

// Rule: touching without overlap is no contact, with either side's rounding.
TEST(SphereContactTest, TouchingIsNoContact) {
  EXPECT_FALSE(sphere_contact({1.5, 0, 0}, 0.5, Sphere{1}));
  EXPECT_FALSE(sphere_contact({0, 0, 0.5}, 0.5, Plane{}));
  EXPECT_FALSE(sphere_contact({1.5, 0, 0}, 0.5, Box{{1, 1, 1}}));
  EXPECT_TRUE(sphere_contact({1.5 - 1e-9, 0, 0}, 0.5, Box{{1, 1, 1}}));
}

// Rule: a center at the very middle still gives a unit normal and the depth of the whole way out.
TEST(SphereContactTest, CenterInTheMiddle) {
  for (const Shape& shape : exact_shapes()) {
    const auto contact = sphere_contact({}, 0.04, shape);
    ASSERT_TRUE(contact) << shape_name(shape);
    EXPECT_NEAR(norm(contact->normal), 1, 1e-15) << shape_name(shape);
    EXPECT_NEAR(contact->depth, 0.04 - outside(shape, {}), 1e-15) << shape_name(shape);
  }
}

// Rule: also for a center on the axis of a capsule the point is on its surface, sideways: along the axis it would be
// inside, and the depth wrong.
TEST(SphereContactTest, CenterOnTheAxisOfACapsule) {
  const Shape capsule = Capsule{0.05, 0.12};
  for (const double z : {-0.1, 0.0, 0.05}) {
    const auto contact = sphere_contact({0, 0, z}, 0.04, capsule);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->normal.z, 0, 1e-15) << z;
    EXPECT_NEAR(outside(capsule, contact->point), 0, 1e-15) << z;
  }
}

// Rule: a center that is outside by rounding only is pushed out of the face where it is, not upwards.
TEST(SphereContactTest, CenterAHairOutside) {
  const auto box = sphere_contact({0.1 + 1e-14, 0, 0}, 0.04, Box{{0.1, 0.1, 0.1}});
  ASSERT_TRUE(box);
  EXPECT_LT(difference(box->normal, {1, 0, 0}), 1e-9);
  const auto cylinder = sphere_contact({0, -0.1 - 1e-14, 0}, 0.04, Cylinder{0.1, 0.1});
  ASSERT_TRUE(cylinder);
  EXPECT_LT(difference(cylinder->normal, {0, -1, 0}), 1e-9);
}

// Law: against an ellipsoid: the point is on its surface, the center is straight above or below it, as far away as depth
// and radius say, and no sample of the surface is nearer. Tolerance: rounding.
TEST(SphereContactTest, Ellipsoid) {
  Dice dice("ellipsoid");
  law::Worst point_error, center_error, nearer;
  for (const Vec3d& axes : {Vec3d{0.05, 0.09, 0.14}, Vec3d{0.09, 0.14, 0.05}, Vec3d{0.1, 0.1, 0.02}}) {
    const Shape shape = Ellipsoid{axes};
    const std::vector<Vec3d> samples = surface_samples(shape);
    for (int i = 0; i < 500; ++i) {
      Vec3d center = dice.vector(0.15);
      if (i % 4 == 1) center.z = 0;
      if (i % 4 == 2) center.x = center.y = 0;
      const double radius = 0.3;
      const auto contact = sphere_contact(center, radius, shape);
      ASSERT_TRUE(contact);
      const double distance = radius - contact->depth;
      point_error.see(std::abs(outside(shape, contact->point)), i);
      center_error.see(difference(center, contact->point + distance * contact->normal), i);
      double nearest = 1e9;
      for (const Vec3d& p : samples) nearest = std::fmin(nearest, norm(p - center));
      nearer.see(std::fabs(distance) - nearest, i);
    }
  }
  expect_contact("sphere touches ellipsoid: distance of the contact point from the surface", "it lies on it",
                 point_error, 1e-14);
  expect_contact("sphere touches ellipsoid: error of the center, from point, normal and depth", "the sphere's center",
                 center_error, 1e-14);
  expect_contact("sphere touches ellipsoid: how much nearer samples of the surface are", "none is nearer", nearer,
                 1e-14);
}

}  // namespace
}  // namespace murosimf::geometry
