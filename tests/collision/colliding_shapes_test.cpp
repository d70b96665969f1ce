// Which shapes of a model collide, in which order, how far they reach in any posture, and where objects are at rest.
#include "murosimf/collision/colliding_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

/// A base with a plane, a sign and a box; beyond a turn a slider, and beyond a hinge a ball.
Chain crane(double slider_from, double slider_to) {
  PlacedShape sign = placed(Sphere{50});
  sign.collides = false;
  return Chain{}
      .base("base")
      .with(properties::shapes, Shapes{placed(Plane{}), sign, placed(Box{{0.3, 0.4, 0}}, {0, 0, 1})})
      .rotation(rotation_z(pi / 2), "turn")
      .translation({3, 4, 0}, "arm")
      .prismatic("slider", {1, 0, 0})
      .with(properties::joint_range, {slider_from, slider_to})
      .with(properties::shapes, Shapes{placed(Sphere{0.5}, {0, 0, 2}), placed(Plane{})})
      .revolute("hinge", {0, 0, 1})
      .with(properties::joint_range, {0.2, 1.0})
      .translation({0, 0, -0.25}, "hand")
      .with(properties::shapes, Shapes{placed(Sphere{0.125})});
}

TEST(CollidingShapes, AreListedByObjectAndIndex) {
  const Model model("crane", crane(-1, 2));
  const auto shapes = colliding_shapes(model);
  ASSERT_EQ(shapes.size(), 3U);
  EXPECT_EQ(shapes[0].object, 0);
  EXPECT_EQ(shapes[0].index, 2);
  EXPECT_EQ(shapes[1].object, model.object_index("slider"));
  EXPECT_EQ(shapes[1].index, 0);
  EXPECT_EQ(shapes[2].object, model.object_index("hand"));
  EXPECT_EQ(shapes[1].placed.position.z, 2);
  const auto planes = colliding_planes(model);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].index, 0);
  EXPECT_EQ(planes[1].object, model.object_index("slider"));
  EXPECT_EQ(planes[1].index, 1);
}

// Offsets add up as lengths, whatever joints and turns are between; a slider may go to either end.
TEST(CollidingShapes, ReachIsTheLongestChain) {
  EXPECT_NEAR(farthest_reach(Model("crane", crane(-1, 2))), 2 + 0.5 + 2 + 5, 1e-12);
  EXPECT_NEAR(farthest_reach(Model("crane", crane(-3, 2))), 2 + 0.5 + 3 + 5, 1e-12);
  EXPECT_NEAR(farthest_reach(Model("base", Chain{}.base().with(properties::shapes,
                                                               Shapes{placed(Box{{0.3, 0.4, 0}}, {0, 0, 1})}))),
              1.5, 1e-12);
  EXPECT_EQ(farthest_reach(Model("nothing", Chain{}.base())), 0);
  const Chain free = Chain{}.base().prismatic("slider", {1, 0, 0}).with(properties::shapes, Shapes{placed(Sphere{1})});
  EXPECT_TRUE(std::isinf(farthest_reach(Model("free", free))));
}

// A joint whose range has no zero stands at its nearer end.
TEST(CollidingShapes, RestIsAsNearToZeroAsRangesAllow) {
  const Model model("crane", crane(0.5, 2));
  const auto poses = rest_poses(model);
  const auto at = [&](const char* name) { return poses[static_cast<std::size_t>(model.object_index(name))]; };
  EXPECT_LT(difference(at("base").position, {}), 1e-15);
  EXPECT_LT(difference(at("turn").orientation, rotation_z(pi / 2)), 1e-12);
  EXPECT_LT(difference(at("arm").position, {-4, 3, 0}), 1e-12);
  EXPECT_LT(difference(at("slider").position, {-4, 3.5, 0}), 1e-12);
  EXPECT_LT(difference(at("hinge").orientation, rotation_z(pi / 2 + 0.2)), 1e-12);
  EXPECT_LT(difference(at("hand").position, {-4, 3.5, -0.25}), 1e-12);
  const Model other("crane", crane(-2, -0.5));
  EXPECT_LT(difference(rest_poses(other)[static_cast<std::size_t>(other.object_index("slider"))].position,
                       {-4, 2.5, 0}),
            1e-12);
  const Model around("crane", crane(-2, 0.5));
  EXPECT_LT(difference(rest_poses(around)[static_cast<std::size_t>(around.object_index("slider"))].position,
                       {-4, 3, 0}),
            1e-12);
}

}  // namespace
}  // namespace murosimf::collision
