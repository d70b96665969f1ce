#include "murosimf/dataset/ground_reach.h"

#include <gtest/gtest.h>

#include "murosimf/math/scalar.h"
#include "murosimf/model/properties.h"

namespace murosimf::dataset {
namespace {

TEST(GroundReach, OfABoxIsHalfItsDiagonal) {
  Chain chain;
  chain.base("box").with(properties::shapes, Shapes{PlacedShape{.shape = Box{{0.3, 0.4, 2}}}});
  const Model model("box", std::move(chain));
  const Vec3d at{3, 4, 1};
  const Mat3d level, turned = rotation_z(1), lying = rotation_y(0.5 * pi);
  EXPECT_NEAR(ground_reach(model, {&at, 1}, {&level, 1}), 0.5, 1e-12);
  EXPECT_NEAR(ground_reach(model, {&at, 1}, {&turned, 1}), 0.5, 1e-12);
  EXPECT_GT(ground_reach(model, {&at, 1}, {&lying, 1}), 2);
}

TEST(Footprint, IsARectangleThatTurnsWithTheShape) {
  const Footprint one = footprint_of(Box{{1, 0.1, 0.5}}, {{2, 3, 0}, rotation_z(0.5 * pi)});
  EXPECT_NEAR(one.distance({2, 3.9, 7}), 0, 1e-12);
  EXPECT_NEAR(one.distance({2.5, 3, 0}), 0.4, 1e-12);
  EXPECT_NEAR(one.distance({2, 4.5, 0}), 0.5, 1e-12);
  EXPECT_NEAR(one.distance({2.4, 4.4, 0}), 0.5, 1e-12);  // 0.3 and 0.4 from a corner
}

}  // namespace
}  // namespace murosimf::dataset
