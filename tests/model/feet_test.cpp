#include <algorithm>

#include "murosimf/model/feet.h"

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"

namespace murosimf {
namespace {

/// Two legs of one joint each; only the left one has a sole, 0.1 m below its joint.
Model one_footed() {
  Chain leg = Chain{}.revolute("left", {0, 1, 0}).translation({0, 0, -0.1}, "left_foot");
  leg.endpoint("left_sole").with(properties::sole, Sole{0.04, 0.02});
  const Chain other = Chain{}.revolute("right", {0, 1, 0}).translation({0, 0, -0.1}, "right_foot");
  return {"one_footed", Chain{}.base("torso").fork(leg, other)};
}

// Rule: soles are objects with the property, and what moves with their link belongs to the foot.
TEST(Feet, AreWhatMovesWithASole) {
  const Model model = one_footed();
  const std::vector<Foot> feet = feet_of(model);
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_EQ(feet[0].object, model.object_index("left_sole"));
  EXPECT_EQ(feet[0].sole.half_length, 0.04);
  EXPECT_EQ(feet[0].place.offset.z, -0.1);
  for (const auto* name : {"left", "left_foot", "left_sole"})
    EXPECT_TRUE(belongs_to(model, feet[0], model.object_index(name))) << name;
  for (const auto* name : {"torso", "right", "right_foot"})
    EXPECT_FALSE(belongs_to(model, feet[0], model.object_index(name))) << name;
}

// Law: of the four corners of a tilted rectangle, the lowest. Tolerance: rounding.
TEST(Feet, LowestCorner) {
  const Sole sole{0.1, 0.05};
  const Mat3d R = rotation_y(0.3) * rotation_z(0.7);
  const Vec3d r{1, 2, 0.5};
  double lowest = 1;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) lowest = std::min(lowest, (r + R * Vec3d{x * 0.1, y * 0.05, 0}).z);
  }
  EXPECT_NEAR(lowest_corner(sole, r, R), lowest, 1e-15);
}

}  // namespace
}  // namespace murosimf
