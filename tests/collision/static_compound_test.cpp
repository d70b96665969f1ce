// What stands on the field for good: which shapes, where, and whether a sphere comes near them.
#include "murosimf/collision/static_compound.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;
using fixtures::placed;

/// A plane, a box on a post that is turned about z, a ball beside it, and a sign visual only.
const Entity& field() {
  PlacedShape sign = placed(Sphere{9});
  sign.collides = false;
  static const Entity entity("field", std::make_shared<const Model>(
                                          "field", Chain{}
                                                       .base("ground")
                                                       .with(properties::shapes, Shapes{placed(Plane{}), sign})
                                                       .translation({2, 1, 0.5})
                                                       .rotation(rotation_z(pi / 2), "post")
                                                       .with(properties::shapes,
                                                             Shapes{placed(Box{{0.4, 0.1, 0.5}}, {0.3, 0, 0}),
                                                                    placed(Sphere{0.2}, {0, 1, 0}, rotation_x(0.3))})));
  return entity;
}

TEST(StaticCompound, ShapesStandWhereTheModelSays) {
  const StaticCompound compound(&field());
  EXPECT_FALSE(compound.empty());
  ASSERT_EQ(compound.compound().shapes().size(), 2U);
  EXPECT_TRUE(std::holds_alternative<Box>(compound.shape(0).placed.shape));
  EXPECT_TRUE(std::holds_alternative<Sphere>(compound.shape(1).placed.shape));
  EXPECT_EQ(compound.shape(1).object, field().model().object_index("post"));
  EXPECT_LT(difference(compound.pose(0).position, {2, 1.3, 0.5}), 1e-12);
  EXPECT_LT(difference(compound.pose(0).orientation, rotation_z(pi / 2)), 1e-12);
  EXPECT_LT(difference(compound.pose(1).position, {1, 1, 0.5}), 1e-12);
  EXPECT_LT(difference(compound.pose(1).orientation, rotation_z(pi / 2) * rotation_x(0.3)), 1e-12);
}

TEST(StaticCompound, WithoutAnEnvironmentItIsEmpty) {
  const StaticCompound compound(nullptr);
  EXPECT_TRUE(compound.empty());
  std::int64_t tests = 0;
  EXPECT_FALSE(compound.is_near({}, 1e3, tests));
  const Entity flat("flat", std::make_shared<const Model>("flat", Chain{}.base().with(properties::shapes,
                                                                                      Shapes{placed(Plane{})})));
  EXPECT_TRUE(StaticCompound(&flat).empty()) << "planes stand apart";
}

TEST(StaticCompound, IsOneForAllInAnEnvironment) {
  const auto shared = static_compound_of(&field());
  EXPECT_EQ(static_compound_of(&field()), shared);
  EXPECT_EQ(shared->compound().shapes().size(), StaticCompound(&field()).compound().shapes().size());
  ASSERT_TRUE(static_compound_of(nullptr));
  EXPECT_TRUE(static_compound_of(nullptr)->empty());
}

// The ball alone decides at first; then the box, whose bounding volume is much larger.
TEST(StaticCompound, IsNearWhatASphereMeets) {
  const StaticCompound compound(&field());
  std::int64_t tests = 0;
  EXPECT_TRUE(compound.is_near({0.5, 1, 0.5}, 0.301, tests));
  EXPECT_GT(tests, 0);
  const std::int64_t before = tests;
  EXPECT_FALSE(compound.is_near({0.5, 1, 0.5}, 0.299, tests));
  EXPECT_GT(tests, before) << "they are added up";
  EXPECT_TRUE(compound.is_near({2, 1.3, 0.5}, 0.01, tests)) << "in the box";
  EXPECT_TRUE(compound.is_near({2.5, 1.3, 0.5}, 0.401, tests)) << "beside the box, which is turned";
  EXPECT_FALSE(compound.is_near({2.5, 1.3, 0.5}, 0.399, tests)) << "in its bounding volume";
  EXPECT_FALSE(compound.is_near({9, 9, 9}, 1, tests));
}

TEST(StaticCompound, AnAnswerHoldsForFiveCentimeters) {
  const StaticCompound compound(&field());
  NearStatics near;
  std::int64_t tests = 0;
  EXPECT_TRUE(near(compound, {2.5, 1.3, 0.5}, 0.351, tests)) << "the margin is in it";
  std::int64_t before = tests;
  EXPECT_TRUE(near(compound, {2.549, 1.3, 0.5}, 0.351, tests));
  EXPECT_EQ(tests, before) << "no repeated test";
  EXPECT_FALSE(near(compound, {2.551, 1.3, 0.5}, 0.351, tests));
  EXPECT_GT(tests, before);
}

}  // namespace
}  // namespace murosimf::collision
