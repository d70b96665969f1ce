// Poses where directions vanish or coincide, and sizes from a millimeter to a hundred meters.
#include <gtest/gtest.h>

#include "murosimf/geometry/collide.h"
#include "murosimf/geometry/distance.h"
#include "tests/geometry/pairs.h"

namespace murosimf::geometry {
namespace {

using namespace pairs;

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

struct Resize {
  double scale;
  Shape operator()(const Sphere& s) const { return Sphere{scale * s.radius}; }
  Shape operator()(const Box& s) const { return Box{scale * s.half_size}; }
  Shape operator()(const Capsule& s) const { return Capsule{scale * s.radius, scale * s.half_length}; }
  Shape operator()(const Cylinder& s) const { return Cylinder{scale * s.radius, scale * s.half_length}; }
  Shape operator()(const Ellipsoid& s) const { return Ellipsoid{scale * s.semi_axes}; }
  Shape operator()(const Plane& s) const { return s; }
  Shape operator()(const Convex& s) const {
    ConvexHull hull = *s.hull;
    for (Vec3d& vertex : hull.vertices) vertex = scale * vertex;
    return Convex{std::make_shared<const ConvexHull>(std::move(hull))};
  }
};

Shape resized(const Shape& shape, double scale) { return std::visit(Resize{scale}, shape); }

/// All numbers are good, the shift along the normal is the depth; and nothing is found only if there is nothing.
void expect_sound(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, double tolerance) {
  const std::string name = std::string(shape_name(a)) + '-' + shape_name(b);
  Manifold found;
  const Gap gap = distance(a, at_a, b, at_b);
  EXPECT_TRUE(std::isfinite(gap.distance) && finite(gap.on_a) && finite(gap.on_b)) << name;
  if (!collide(a, at_a, b, at_b, found)) {
    EXPECT_GT(gap.distance, -tolerance) << name;
    return;
  }
  EXPECT_NEAR(norm(found.normal), 1, 1e-9) << name;
  ASSERT_GT(found.count, 0) << name;
  double deepest = 0;
  for (int i = 0; i < found.count; ++i) {
    EXPECT_TRUE(finite(found.points[i].point)) << name;
    EXPECT_GT(found.points[i].depth, 0) << name;
    deepest = std::fmax(deepest, found.points[i].depth);
  }
  EXPECT_NEAR(deepest, shift(a, at_a, b, at_b, found.normal), tolerance) << name;
  EXPECT_NEAR(gap.distance, -deepest, tolerance) << name;
}

template <class Visit>
void for_kinds(const Visit& visit) {
  for (const Shape& a : all_kinds()) {
    for (const Shape& b : all_kinds()) visit(a, b);
  }
}

const Mat3d quarters[] = {{}, rotation_x(pi / 2), rotation_y(pi / 2), rotation_z(pi / 2)};

// Rule: with both centers in one place there is no direction between them; still the least shift is found.
TEST(Degenerate, Concentric) {
  for_kinds([](const Shape& a, const Shape& b) {
    for (const Mat3d& turn : quarters) {
      const Transformd here{{0.3, -0.2, 0.1}, {}}, turned{here.position, turn};
      expect_sound(a, turned, b, here, 1e-7);
      Manifold found;
      ASSERT_TRUE(collide(a, turned, b, here, found));
      const double least = LeastShift(a, turned, b, here).value();
      EXPECT_NEAR(shift(a, turned, b, here, found.normal), least, 1e-6) << shape_name(a) << '-' << shape_name(b);
    }
  });
}

// Rule: so it is with parallel axes, and where the surfaces just touch, to rounding on either side.
TEST(Degenerate, ParallelAndTouching) {
  for_kinds([](const Shape& a, const Shape& b) {
    for (const Mat3d& turn : quarters) {
      for (const Vec3d& way : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, -1}, Vec3d{0.6, 0.8, 0}}) {
        const Transformd at_b{};
        Transformd at_a{{}, turn};
        const double touching = shift(a, at_a, b, at_b, way);
        for (const double past : {-1e-3, -1e-9, -1e-13, 0.0, 1e-16, 1e-13, 1e-9, 1e-3}) {
          at_a.position = (touching + past) * way;
          expect_sound(a, at_a, b, at_b, 1e-7);
        }
      }
    }
  });
}

// Rule: nothing is found between shapes that are far apart, and the distance is about that of the centers.
TEST(Degenerate, FarAway) {
  for_kinds([](const Shape& a, const Shape& b) {
    const Transformd far{{1e4, -2e4, 3e4}, rotation_x(0.4)};
    Manifold found;
    EXPECT_FALSE(collide(a, far, b, {}, found));
    EXPECT_NEAR(distance(a, far, b, {}).distance, norm(far.position), bounding_radius(a) + bounding_radius(b) + 1e-6);
  });
}

// Rule: sizes do not matter, alone or together, from 1e-3 to 1e2 m; tolerance: 1e-7 of the larger size.
TEST(Degenerate, TinyAndHuge) {
  Dice dice("sizes");
  for_kinds([&](const Shape& a, const Shape& b) {
    for (const double size_a : {1e-2, 1.0, 1e3}) {
      for (const double size_b : {1e-2, 1e3}) {
        const Shape sized_a = resized(a, size_a), sized_b = resized(b, size_b);
        for (int i = 0; i < 10; ++i) {
          const Transformd at_a = random_pose(dice, 0.12 * std::fmax(size_a, size_b)), at_b{{}, dice.turn()};
          expect_sound(sized_a, at_a, sized_b, at_b, 1e-8 * std::fmax(size_a, size_b));
        }
      }
    }
  });
}

// Rule: equal boxes stacked edge on edge keep four points or more: every corner lies on another shape's edge.
TEST(Degenerate, EqualBoxesStacked) {
  const Shape box = Box{{0.1, 0.1, 0.1}};
  for (const Mat3d& turn : quarters) {
    Manifold found;
    ASSERT_TRUE(collide(box, {{0, 0, 0.2 - 1e-4}, turn}, box, {}, found));
    EXPECT_GE(found.count, 4);
    EXPECT_NEAR(std::abs(found.normal.z), 1, 1e-12);
    for (int i = 0; i < found.count; ++i) EXPECT_NEAR(found.points[i].depth, 1e-4, 1e-12);
  }
}

}  // namespace
}  // namespace murosimf::geometry
