// Facets enclose their shape: corners on its surface, normals outwards, no holes. They need cairo only to be built.
#include "murosimf/render/shape_facets.h"

#include <gtest/gtest.h>

#ifdef MUROSIMF_HAS_CAIRO

#include <algorithm>

#include "tests/fixtures.h"

namespace murosimf::render {
namespace {

std::vector<Shape> solids() {
  std::vector<Shape> shapes = fixtures::shapes_of_all_kinds();
  std::erase_if(shapes, [](const Shape& shape) { return std::holds_alternative<Plane>(shape); });
  return shapes;
}

/// Twice the area, along the normal.
Vec3d area_of(const Facet& facet) {
  Vec3d area;
  for (std::size_t i = 1; i + 1 < facet.size(); ++i) area += cross(facet[i] - facet[0], facet[i + 1] - facet[0]);
  return area;
}

TEST(ShapeFacets, CornersLieOnTheSurface) {
  for (const Shape& shape : solids()) {
    const double tolerance = 1e-9 * bounding_radius(shape);
    for (const Facet& facet : shape_facets(shape)) {
      ASSERT_GE(facet.size(), 3u);
      for (const Vec3d& p : facet) EXPECT_NEAR(fixtures::outside(shape, p), 0, tolerance) << shape_name(shape);
    }
  }
}

TEST(ShapeFacets, AreFlatAndLookOutwards) {
  for (const Shape& shape : solids()) {
    for (const Facet& facet : shape_facets(shape)) {
      const Vec3d area = area_of(facet);
      EXPECT_GT(dot(area, facet[0]), 0) << shape_name(shape);  // all shapes have their origin inside
      for (const Vec3d& p : facet) {
        EXPECT_NEAR(dot(area, p - facet[0]) / norm(area), 0, 1e-9 * bounding_radius(shape)) << shape_name(shape);
      }
    }
  }
}

TEST(ShapeFacets, CloseTheSurface) {
  for (const Shape& shape : solids()) {
    Vec3d sum;
    double all = 0;
    for (const Facet& facet : shape_facets(shape)) {
      sum += area_of(facet);
      all += norm(area_of(facet));
    }
    EXPECT_LT(norm(sum), 1e-12 * all) << shape_name(shape);
  }
}

TEST(ShapeFacets, RoundShapesLookRound) {
  for (const Shape& shape : solids()) {
    const double allowed = 0.02 * bounding_radius(shape);
    const auto facets = shape_facets(shape);
    for (const Vec3d& p : fixtures::surface_samples(shape)) {
      double farthest = -1e300;
      for (const Facet& facet : facets) {
        const Vec3d area = area_of(facet);
        farthest = std::max(farthest, dot(area, p - facet[0]) / norm(area));
      }
      EXPECT_LT(farthest, allowed) << shape_name(shape);
    }
  }
}

TEST(ShapeFacets, PlaneHasNone) { EXPECT_TRUE(shape_facets(Plane{}).empty()); }

TEST(Outline, EnclosesAllPointsAndTurnsLeftOnly) {
  fixtures::Dice dice("outline");
  for (int n = 3; n < 60; ++n) {
    std::vector<Vec3d> points;
    for (int i = 0; i < n; ++i) points.push_back({dice.uniform(-1, 1), dice.uniform(-1, 1), 0});
    const auto hull = outline(points);
    ASSERT_GE(hull.size(), 3u);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec3d a = hull[i], way = hull[(i + 1) % hull.size()] - a;
      for (const Vec3d& p : points) EXPECT_GE(cross(way, p - a).z, -1e-15);
    }
  }
}

TEST(Outline, HasNoAreaWithoutThreeCorners) {
  EXPECT_LT(outline({}).size(), 3u);
  EXPECT_LT(outline({{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}).size(), 3u);
  EXPECT_LT(outline({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).size(), 3u);
}

}  // namespace
}  // namespace murosimf::render

#endif
