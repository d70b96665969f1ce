// List of the present contacts: pairs of entities, seen from either side.
#include "murosimf/collision/touches.h"

#include <gtest/gtest.h>

#include "murosimf/collision/body_pairs.h"
#include "tests/collision/meeting.h"
#include "tests/fixtures.h"

namespace murosimf::collision {
namespace {

using fixtures::difference;

void fill(ContactPoint& c, int object, double number) {
  c.object = object;
  c.point = {number, 0, 1};
  c.normal = {0, 0.6, 0.8};
  c.force = {1, number, 3};
  c.depth = 1e-3 * number;
}

PairContact pair(int a, int object, int b, int object_b, double number) {
  PairContact c;
  fill(c, object, number);
  c.a = a;
  c.b = b;
  c.object_b = object_b;
  return c;
}

/// A field and two robots, of which the list of moving entities has the second one first.
struct Listed {
  Listed() {
    const auto model = std::make_shared<const Model>(fixtures::two_legged());
    field = &world.add("field", model);
    red = &world.add("red", model);
    blue = &world.add("blue", model);
    ContactSet& set = red->column(contacts).values[0];
    set.environment = 0;
    set.environment_objects = {7, 3};
    set.points.resize(2);
    fill(set.points[0], 5, 1);
    fill(set.points[1], 6, 2);
    set.points[0].surface = 1;
    PairSet& pairs = world.common().column(pair_contacts).values[0];
    pairs.entities = {2, 1};
    pairs.points = {pair(0, 4, 1, 2, 3), pair(1, 8, 1, 9, 4)};
  }
  World world;
  Entity *field = nullptr, *red = nullptr, *blue = nullptr;
};

void expect_touch(const Touch& touch, const Entity* entity, int object, const Entity* other, int other_object) {
  EXPECT_EQ(touch.entity, entity);
  EXPECT_EQ(touch.object, object);
  EXPECT_EQ(touch.other, other);
  EXPECT_EQ(touch.other_object, other_object);
}

/// `sign` -1 for the side that feels the opposite.
void expect_numbers(const Touch& touch, double number, double sign) {
  EXPECT_EQ(difference(touch.point, {number, 0, 1}), 0);
  EXPECT_EQ(difference(touch.normal, sign * Vec3d{0, 0.6, 0.8}), 0);
  EXPECT_EQ(difference(touch.force, sign * Vec3d{1, number, 3}), 0);
  EXPECT_EQ(touch.depth, 1e-3 * number);
}

// The environment first, then others, then itself from both sides.
TEST(TouchList, AsBOfAPair) {
  const Listed listed;
  const auto found = touches(listed.world, *listed.red);
  ASSERT_EQ(found.size(), 5U);
  expect_touch(found[0], listed.red, 5, listed.field, 3);
  expect_numbers(found[0], 1, 1);
  expect_touch(found[1], listed.red, 6, listed.field, 7);
  expect_numbers(found[1], 2, 1);
  expect_touch(found[2], listed.red, 2, listed.blue, 4);
  expect_numbers(found[2], 3, -1);
  expect_touch(found[3], listed.red, 8, listed.red, 9);
  expect_numbers(found[3], 4, 1);
  expect_touch(found[4], listed.red, 9, listed.red, 8);
  expect_numbers(found[4], 4, -1);
}

TEST(TouchList, AsAOfAPair) {
  const Listed listed;
  const auto found = touches(listed.world, *listed.blue);
  ASSERT_EQ(found.size(), 1U);
  expect_touch(found[0], listed.blue, 4, listed.red, 2);
  expect_numbers(found[0], 3, 1);
}

TEST(TouchList, WithoutAnEnvironmentThereIsNoOther) {
  Listed listed;
  listed.red->column(contacts).values[0].environment = -1;
  EXPECT_EQ(touches(listed.world, *listed.red)[0].other, nullptr);
}

TEST(TouchList, OfWhoTouchesNobodyIsEmpty) {
  const Listed listed;
  EXPECT_TRUE(touches(listed.world, *listed.field).empty());
  listed.blue->freeze("test");
  EXPECT_TRUE(touches(listed.world, *listed.blue).empty());
}

TEST(Touches, AreSeenFromBothSides) {
  Meeting meeting("kelvin_voigt");
  meeting.rig.simulation.step();
  const auto small = touches(meeting.rig.simulation.world(), *meeting.small);
  const auto big = touches(meeting.rig.simulation.world(), *meeting.big);
  ASSERT_EQ(small.size(), 1U);
  ASSERT_EQ(big.size(), 1U);
  EXPECT_EQ(small[0].other, meeting.big);
  EXPECT_EQ(big[0].other, meeting.small);
  EXPECT_EQ(big[0].entity, meeting.big);
  EXPECT_LT(difference(small[0].normal, {0.48, 0.6, 0.64}), 1e-12);
  EXPECT_LT(difference(small[0].normal + big[0].normal, {}), 1e-15);
  EXPECT_LT(difference(small[0].force + big[0].force, {}), 1e-15);
  EXPECT_GT(dot(small[0].force, small[0].normal), 1);
  EXPECT_EQ(small[0].depth, big[0].depth);
  meeting.small->freeze("test");
  EXPECT_TRUE(touches(meeting.rig.simulation.world(), *meeting.small).empty());
}

}  // namespace
}  // namespace murosimf::collision
