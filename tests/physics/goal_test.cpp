// Goals stand in the way of balls and robots.
#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/encounters.h"

namespace murosimf::test {
namespace {

/// How deep [m] a ball is in any of the twelve boxes, from its middle alone.
double depth_in_goals(const scene_file::FieldSize& size, const Vec3d& center, double radius) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double side : {1.0, -1.0}) {
    for (const scene_file::GoalBox& part : scene_file::goal_boxes(size, side)) {
      nearest = std::min(nearest, fixtures::outside(part.box, center - part.center));
    }
  }
  return std::max(0.0, radius - nearest);
}

struct Shot {
  Shot(const std::string& level, const Vec3d& from, const Vec3d& velocity, bool weightless = false) {
    if (weightless) pitch.simulation.world().gravity = {};
    ball = &pitch.add("ball", scene_file::ball_model(), {.position = from});
    pitch.attach_together({{ball, {.level = level}}});
    pitch.simulation.initialize();
    Rig::launch(*ball, velocity);
  }
  void fly(double seconds) {
    for (int i = 0; i < std::lround(1000 * seconds); ++i) {
      pitch.simulation.step();
      deepest = std::max(deepest, depth_in_goals(pitch.size, Rig::place(*ball), 0.05));
    }
  }
  Pitch pitch;
  Entity* ball = nullptr;
  double deepest = 0;
};

class Goal : public testing::TestWithParam<std::string> {};

// Tolerance: as for the ground (ball_test.cpp).
TEST_P(Goal, PostSendsABallBackWithItsRestitution) {
  const scene_file::FieldSize& size = scene_file::kid_size_2008;
  const double v = 1, restitution = 0.5, y = (size.goal_width + size.post_width) / 2;
  double kept = 0, deepest = 0;
  constexpr int phases = 10;
  for (int i = 0; i < phases; ++i) {
    Shot shot(GetParam(), {size.length / 2 - 0.1 - 1e-3 * i / phases, y, 0.4}, {v, 0, 0}, true);
    shot.fly(0.2);
    kept += -Rig::velocity(*shot.ball).x / v / phases;
    deepest = std::max(deepest, shot.deepest);
  }
  law::expect_near({.law = "ball hits a goal post head-on: speed that it keeps, as a part",
                    .level = GetParam(),
                    .source = "restitution of ball on plastic"},
                   kept, restitution, 1e-3, "");
  EXPECT_GT(deepest, 1e-5) << "it did not hit";
  law::expect_below({.law = "ball hits a goal post head-on: deepest overlap with any of 12 boxes",
                     .level = GetParam(),
                     .source = "its way in a step"},
                    deepest, v * 1e-3 + 1e-9, "m");
}

TEST_P(Goal, HoldsABallThatRollsIn) {
  const scene_file::FieldSize& size = scene_file::kid_size_2008;
  const double line = size.length / 2, rear = line + size.goal_depth - size.post_width;
  Shot shot(GetParam(), {line - 0.3, 0.2, 0}, {1, 0.3, 0});
  shot.fly(6);
  const Vec3d end = Rig::place(*shot.ball);
  EXPECT_GT(shot.deepest, 1e-5) << "it did not reach the bar";
  EXPECT_LT(norm(Rig::velocity(*shot.ball)), 1e-3);
  law::expect_between({.law = "ball rolls into a goal: where it comes to rest, behind the goal line",
                       .level = GetParam(),
                       .source = "between the line and the rear bar"},
                      end.x - line, 0, rear - line, "m");
  EXPECT_LT(depth_in_goals(size, end, 0.05), 1e-3);
  EXPECT_LT(std::abs(end.y), size.goal_width / 2);
}

INSTANTIATE_TEST_SUITE_P(Levels, Goal, testing::ValuesIn(dynamic_levels()), level_name);

class RobotAtPost : public testing::TestWithParam<std::string> {};

TEST_P(RobotAtPost, DoesNotGetThrough) {
  Pitch pitch;
  const scene_file::GoalBox post = pitch.goal_box("post_left");
  Entity& robot = pitch.add("robot", kid21(), {.position = {post.center.x - 0.35, post.center.y, 0}});
  pitch.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, locomotion::WalkEngine::rate_hz,
                                                  Vec3d{0.2, 0, 0});
  pitch.attach_together({{&robot, {.level = GetParam()}}});
  Overlap overlap(pitch.simulation.world(), {&robot}, pitch.body_of("goal_right_post_left"));
  law::Worst deepest;
  bool touched = false;
  for (int i = 0; i < 8000; ++i) {
    pitch.simulation.step();
    const double depth = overlap.now();
    deepest.see(depth, "step", i);
    touched |= depth > 0;
  }
  EXPECT_TRUE(touched) << "it did not reach the post";
  law::expect_below({.law = "robot walks against a goal post: deepest overlap",
                     .level = GetParam(),
                     .source = "a tenth of the post"},
                    deepest, 0.1 * pitch.size.post_width, "m");
  const double width = 2 * post.box.half_size.y;
  const Vec3d end = Rig::place(robot);
  EXPECT_TRUE(end.x < post.center.x || std::abs(end.y - post.center.y) > width) << "it went through";
  EXPECT_FALSE(robot.frozen());
}

INSTANTIATE_TEST_SUITE_P(Levels, RobotAtPost, testing::ValuesIn(all_levels()), level_name);

}  // namespace
}  // namespace murosimf::test
