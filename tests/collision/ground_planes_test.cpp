#include <gtest/gtest.h>

#include "murosimf/collision/ground_contact.h"
#include "murosimf/world/world.h"
#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

/// The plane that a field gives whose shape is turned by R, with a friction_direction in the shape's frame.
GroundPlane plane_of(const Mat3d& R, const Vec3d& friction_direction) {
  PlacedShape shape = fixtures::placed(Plane{}, {0, 0, 0.2}, R);
  shape.surface.friction_direction = friction_direction;
  World world;
  const auto model = std::make_shared<const Model>("field", Chain{}.base().with(properties::shapes, {shape}));
  const std::vector<GroundPlane> planes = ground_planes(&world.add("field", model));
  EXPECT_EQ(planes.size(), 1u);
  return planes.at(0);
}

// Law: the plane is where its shape is, and so is its friction_direction: in the plane, of length 1, turned with the shape.
TEST(GroundPlanes, GrainTurnsWithTheShape) {
  fixtures::Dice dice("friction_direction");
  for (int i = 0; i < 20; ++i) {
    const Mat3d R = dice.turn();
    const GroundPlane plane = plane_of(R, {3, -4, 7});
    EXPECT_LT(difference(plane.normal, R.z), 1e-15);
    EXPECT_NEAR(plane.height, 0.2 * R.z.z, 1e-15);
    EXPECT_LT(difference(plane.friction_direction, 0.6 * R.x - 0.8 * R.y), 1e-14);
  }
}

// Rule: no friction_direction, or one straight up, is none.
TEST(GroundPlanes, NoGrain) {
  EXPECT_EQ(norm(plane_of({}, {}).friction_direction), 0);
  EXPECT_EQ(norm(plane_of({}, {0, 0, 1}).friction_direction), 0);
}

// Rule: it counts if a billionth of its length lies in the plane.
TEST(GroundPlanes, SlightestGrain) {
  EXPECT_LT(difference(plane_of({}, {0, -1.5e-9, 1}).friction_direction, {0, -1, 0}), 1e-15);
  EXPECT_EQ(norm(plane_of({}, {0, -0.75e-9, 1}).friction_direction), 0);
  EXPECT_LT(difference(plane_of({}, {0, -3e-9, 2}).friction_direction, {0, -1, 0}), 1e-15);
}

}  // namespace
}  // namespace murosimf::collision
