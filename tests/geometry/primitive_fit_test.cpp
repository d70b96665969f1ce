/// primitive_fit_test - primitives that stand for convex polyhedra: they find themselves, and always the volume.
#include "murosimf/geometry/primitive_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/geometry/hull.h"
#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/robot_formats/mass_properties.h"
#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

using fixtures::Dice;
using fixtures::difference;
using fixtures::surface_samples;

constexpr std::array all_kinds{PrimitiveKind::sphere, PrimitiveKind::capsule, PrimitiveKind::cylinder,
                               PrimitiveKind::box};

/// Hull of points that are turned and moved.
Hull hull_of(const std::vector<Vec3d>& points, const Mat3d& turn, const Vec3d& shift) {
  std::vector<Vec3d> moved;
  for (const Vec3d& p : points) moved.push_back(shift + turn * p);
  return make_hull(moved);
}

std::vector<Vec3d> corners(const Vec3d& half) {
  std::vector<Vec3d> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  }
  return points;
}

/// Whether the columns of both are the same axes, in any order and direction.
double axes_apart(const Mat3d& a, const Mat3d& b) {
  double worst = 0;
  for (const Vec3d& axis : {a.x, a.y, a.z}) {
    worst = std::max(worst,
                     1 - std::max({std::fabs(dot(axis, b.x)), std::fabs(dot(axis, b.y)), std::fabs(dot(axis, b.z))}));
  }
  return worst;
}

Vec3d sorted(Vec3d v) {
  if (v.x > v.y) std::swap(v.x, v.y);
  if (v.y > v.z) std::swap(v.y, v.z);
  if (v.x > v.y) std::swap(v.x, v.y);
  return v;
}

TEST(PrimitiveFit, ABoxFindsItselfAlsoIfItIsACubeOrHasASquareSide) {
  Dice dice("fit boxes");
  for (const Vec3d& half :
       {Vec3d{0.05, 0.1, 0.2}, Vec3d{0.05, 0.05, 0.2}, Vec3d{0.1, 0.02, 0.1}, Vec3d{0.1, 0.1, 0.1}}) {
    for (int i = 0; i < 5; ++i) {
      const Mat3d turn = dice.turn();
      const Vec3d shift = dice.vector(0.5);
      const Hull hull = hull_of(corners(half), turn, shift);
      const FittedPrimitive fitted = fit_primitive(hull.hull, PrimitiveKind::best);
      ASSERT_TRUE(std::holds_alternative<Box>(fitted.shape)) << shape_name(fitted.shape);
      EXPECT_LT(difference(sorted(std::get<Box>(fitted.shape).half_size), sorted(half)), 1e-6);
      EXPECT_LT(difference(hull.middle + fitted.position, shift), 1e-6);
      EXPECT_LT(axes_apart(fitted.orientation, turn), 1e-6);
      EXPECT_GT(fitted.overlap, 0.999);
    }
  }
}

TEST(PrimitiveFit, RoundShapesFindThemselves) {
  Dice dice("fit round shapes");
  for (const Shape& shape : {Shape{Sphere{0.1}}, Shape{Capsule{0.05, 0.12}}, Shape{Cylinder{0.08, 0.1}},
                             Shape{Cylinder{0.08, 0.02}}, Shape{Cylinder{0.03, 0.2}}}) {
    const Mat3d turn = dice.turn();
    const Vec3d shift = dice.vector(0.5);
    std::vector<Vec3d> some;
    for (const Vec3d& p : surface_samples(shape)) {
      if (dice.chance(0.2)) some.push_back(p);
    }
    const Hull hull = hull_of(some, turn, shift);
    const FittedPrimitive fitted = fit_primitive(hull.hull, PrimitiveKind::best);
    ASSERT_STREQ(shape_name(fitted.shape), shape_name(shape));
    EXPECT_LT(difference(hull.middle + fitted.position, shift), 1e-3);
    EXPECT_NEAR(robot_formats::volume(fitted.shape) / robot_formats::volume(shape), 1, 0.01) << "samples cut corners";
    EXPECT_NEAR(bounding_radius(fitted.shape) / bounding_radius(shape), 1, 0.01);
    if (std::holds_alternative<Sphere>(shape)) continue;
    EXPECT_NEAR(std::fabs(dot(fitted.orientation.z, turn.z)), 1, 1e-4);
  }
}

TEST(PrimitiveFit, VolumeAndCenterAreThoseOfTheHull) {
  Dice dice("fit odd hulls");
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 4 + 3 * i; ++k) {
      const Vec3d p = dice.vector(0.1);
      points.push_back({p.x, 0.5 * p.y, 2 * p.z});
    }
    const ConvexHull hull = make_hull(points).hull;
    const SolidMass solid = solid_mass(hull);
    for (const PrimitiveKind kind : all_kinds) {
      const FittedPrimitive fitted = fit_primitive(hull, kind);
      EXPECT_NEAR(robot_formats::volume(fitted.shape) / solid.volume, 1, 1e-9) << shape_name(fitted.shape);
      EXPECT_LT(difference(fitted.position, solid.center), 1e-12);
    }
  }
}

/// Independent of the fit: dice instead of fixed points, the fixtures' distance instead of its own test.
double diced_overlap(const ConvexHull& hull, const FittedPrimitive& fitted) {
  Dice dice("overlap");
  const double reach = bounding_radius(fitted.shape);
  int inside = 0, both = 0;
  for (int i = 0; i < 60000; ++i) {
    const Vec3d p = dice.vector(reach);
    if (fixtures::outside(fitted.shape, p) > 0) continue;
    ++inside;
    const Vec3d q = fitted.position + fitted.orientation * p;
    bool in_hull = true;
    for (std::size_t k = 0; k < hull.faces.size(); ++k) {
      in_hull = in_hull && dot(hull.normals[k], q - hull.vertices[hull.faces[k][0]]) <= 0;
    }
    both += in_hull ? 1 : 0;
  }
  return static_cast<double>(both) / inside;
}

TEST(PrimitiveFit, OverlapIsTheShareInCommonAndTheBestKindHasTheLargest) {
  Dice dice("fit overlap");
  for (int i = 0; i < 4; ++i) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 30; ++k) points.push_back(dice.vector(0.1));
    const ConvexHull hull = make_hull(points).hull;
    const double best = fit_primitive(hull, PrimitiveKind::best).overlap;
    for (const PrimitiveKind kind : all_kinds) {
      const FittedPrimitive fitted = fit_primitive(hull, kind);
      EXPECT_NEAR(fitted.overlap, diced_overlap(hull, fitted), 0.025) << shape_name(fitted.shape);
      EXPECT_LE(fitted.overlap, best + 0.01);
    }
  }
}

}  // namespace
}  // namespace murosimf::geometry
