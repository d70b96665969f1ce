// Objects fixed to a link of a body that turns: their velocity is that of a point of it.
#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/world/entity.h"
#include "murosimf/world/state_hash.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

TEST(StructuralObjects, MoveAsPointsOfTheirLink) {
  Entity entity("robot", std::make_shared<const Model>("robot", Chain{}
                                                                    .base("base")
                                                                    .translation({0.3, -0.2, 0.5})
                                                                    .rotation({1, 0, 0}, 0.4)
                                                                    .translation({0, 0.1, 0}, "hand")
                                                                    .structural()
                                                                    .endpoint("tip")));
  for (const auto* property : {&properties::position, &properties::linear_velocity, &properties::angular_velocity}) {
    entity.column(*property);
  }
  entity.column(properties::orientation);
  const Mat3d R = rotation_z(0.7) * rotation_y(-0.3);
  const Vec3d r{1, 2, 3}, v{0.4, -0.6, 0.1}, w{2, -1, 3};
  entity.column(properties::position).values[0] = r;
  entity.column(properties::orientation).values[0] = R;
  entity.column(properties::linear_velocity).values[0] = v;
  entity.column(properties::angular_velocity).values[0] = w;
  const Vec3d arm = R * (Vec3d{0.3, -0.2, 0.5} + rotation_x(0.4) * Vec3d{0, 0.1, 0});
  const auto hand = entity.object("hand");
  EXPECT_LT(fixtures::difference(hand.get(properties::position), r + arm), 1e-15);
  EXPECT_LT(fixtures::difference(hand.get(properties::orientation), R * rotation_x(0.4)), 1e-15);
  EXPECT_LT(fixtures::difference(hand.get(properties::linear_velocity), v + cross(w, arm)), 1e-15);
  EXPECT_LT(fixtures::difference(hand.get(properties::angular_velocity), w), 1e-15);
  // by name the same, and nothing has been written: others may read at the same time
  const Vec3d place = hand.get(properties::position);
  EXPECT_EQ(hand.get("position").numbers, (std::vector<double>{place.x, place.y, place.z}));
  EXPECT_EQ(hand.get("orientation").numbers.size(), 9u);
  EXPECT_EQ(hand.get("position").unit, "m");
  const int row = entity.model().object_index("hand");
  Hasher hasher, again;
  append_state(hasher, entity);
  EXPECT_NE(fixtures::difference(entity.column(properties::position).values[static_cast<std::size_t>(row)], place), 0);
  entity.column(properties::position).values[static_cast<std::size_t>(row)] = {7, 8, 9};
  append_state(again, entity);
  EXPECT_EQ(hasher.value(), again.value()) << "its rows hold nothing";
}

}  // namespace
}  // namespace murosimf
