// What sensors and users see of contacts: which bodies, where, which force.
#include "murosimf/collision/touches.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene_file/field.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::test {
namespace {

using collision::Touch;
using collision::touches;

std::vector<Touch> touches_of(Rig& rig, const Entity& entity) { return touches(rig.simulation.world(), entity); }

/// Force [N] that one entity feels from another.
Vec3d force_from(const std::vector<Touch>& all, const Entity* other) {
  Vec3d sum;
  for (const Touch& touch : all) {
    if (touch.other == other) sum += touch.force;
  }
  return sum;
}

class Touches : public testing::TestWithParam<LevelAndLaw> {};

TEST_P(Touches, OfAStandingBoxCarryItsWeight) {
  Rig rig;
  Entity& box = rig.add("box", box_model());
  rig.attach_dynamics(box, dynamics(GetParam()));
  rig.run(2);
  const auto found = touches_of(rig, box);
  ASSERT_EQ(found.size(), 4u);
  for (const Touch& touch : found) {
    EXPECT_EQ(touch.entity, &box);
    EXPECT_EQ(touch.other, rig.ground);
    EXPECT_EQ(touch.object, 0);
    EXPECT_EQ(touch.other_object, 0);
    EXPECT_GT(touch.depth, 0);
    EXPECT_NEAR(touch.normal.z, 1, 1e-15);
    EXPECT_NEAR(std::abs(touch.point.x), 0.15, 1e-3);
    EXPECT_NEAR(std::abs(touch.point.y), 0.10, 1e-3);
  }
  law::expect_near({.law = "standing box: force of the ground that a contact sensor reads",
                    .level = words_of(GetParam()),
                    .source = "its weight"},
                   force_from(found, rig.ground).z, 4.3 * g, 1e-3 * 4.3 * g, "N");
}

INSTANTIATE_TEST_SUITE_P(Laws, Touches, at_every_level({"implicit_stick", "kelvin_voigt", "island_gauss_seidel"}),
                         test_name);

class TouchLevels : public testing::TestWithParam<std::string> {};

// Two entities see the same contacts, with opposite force and normal.
TEST_P(TouchLevels, AreSeenFromBothSides) {
  Rig rig;
  rig.materials = MaterialTable::standard();
  Entity& box = rig.add("box", box_model({"plastic"}));
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {0.02, 0.01, 0.1}});
  rig.attach_together({{&box, {.level = GetParam()}}, {&ball, {.level = GetParam()}}});
  rig.run(2);
  const auto of_ball = touches_of(rig, ball), of_box = touches_of(rig, box);
  ASSERT_EQ(of_ball.size(), 1u);
  ASSERT_EQ(of_box.size(), 5u);  // the environment comes first
  const Touch &one = of_ball[0], &other = of_box[4];
  EXPECT_EQ(of_box[3].other, rig.ground);
  EXPECT_EQ(one.entity, &ball);
  EXPECT_EQ(one.other, &box);
  EXPECT_EQ(other.entity, &box);
  EXPECT_EQ(other.other, &ball);
  EXPECT_EQ(norm(one.force + other.force), 0);
  EXPECT_EQ(norm(one.normal + other.normal), 0);
  EXPECT_EQ(norm(one.point - other.point), 0);
  EXPECT_NEAR(one.normal.z, 1, 1e-3);
  const double weight = g * ball.base().get(properties::total_mass);
  law::expect_near({.law = "ball on a box: force of the box that a contact sensor of the ball reads",
                    .level = GetParam(),
                    .source = "the weight of the ball"},
                   one.force.z, weight, 1e-3 * weight, "N");
}

INSTANTIATE_TEST_SUITE_P(Levels, TouchLevels, testing::ValuesIn(dynamic_levels()), level_name);

// The field's objects are told apart: the ground is "field", a post has its own name.
TEST(Touches, NameTheGoalPostThatABallHits) {
  Rig rig;
  const auto& size = scene_file::kid_size_2008;
  Entity& field = rig.add("field", scene_file::field_model(size, "carpet"));
  const double y = size.goal_width / 2 + size.post_width / 2;
  Entity& ball = rig.add("ball", scene_file::ball_model(), {.position = {size.length / 2 - 0.06, y, 0}});
  rig.materials = MaterialTable::standard();
  rig.simulation.attach<collision::GroundContact>("ground_contact", ball, rig.rate, &field, law_named("implicit_stick"),
                                                  rig.materials);
  rig.simulation.attach<dynamics::SimplifiedDynamics>("simplified_dynamics", ball, rig.rate);
  rig.simulation.initialize();
  Rig::launch(ball, {1, 0, 0});
  double largest = 0;
  for (int i = 0; i < 50; ++i) {
    rig.simulation.step();
    for (const Touch& touch : touches_of(rig, ball)) {
      ASSERT_EQ(touch.other, &field);
      const std::string& name = field.model().objects()[static_cast<std::size_t>(touch.other_object)].name;
      EXPECT_EQ(name, std::abs(touch.normal.z) > 0.5 ? "field" : "goal_right_post_left");
      if (name == "goal_right_post_left") largest = std::max(largest, -touch.force.x);
    }
  }
  EXPECT_GT(largest, 1) << "the ball did not hit the post";
}

// A frozen entity feels nothing, and nobody feels it.
TEST(Touches, AreNoneOfAFrozenEntity) {
  Rig rig;
  Entity& box = rig.add("box", box_model());
  rig.attach_dynamics(box);
  rig.run(0.1);
  EXPECT_FALSE(touches_of(rig, box).empty());
  box.freeze("test");
  EXPECT_TRUE(touches_of(rig, box).empty());
}

}  // namespace
}  // namespace murosimf::test
