// Worlds of a batch step side by side in lanes, and wait as packed states: each of them is a Scene alone, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "murosimf/batch.h"

namespace murosimf::api {
namespace {

SceneOptions options_of(const std::string& level, std::vector<std::string> more = {}) {
  std::vector<std::string> set = {"walker.level=" + level, "walker.controller=none", "start.jitter_heading_deg=20",
                                  "start.jitter_posture_deg=5"};
  set.insert(set.end(), more.begin(), more.end());
  return {.set = set};
}

/// Makes the same calls of a batch, and of scenes of which each is alone.
class BatchAndScenes {
 public:
  BatchAndScenes(const std::string& scene, std::size_t worlds, SceneOptions options, int threads)
      : batch_(scene, worlds, with_seed(options), threads) {
    for (std::size_t i = 0; i < worlds; ++i) {
      options.seed = 1 + i;
      alone_.emplace_back(scene, options);
    }
  }
  Batch& batch() { return batch_; }
  Scene& alone(std::size_t i) { return alone_[i]; }

  void step(int steps) {
    batch_.step(steps);
    for (Scene& scene : alone_) scene.step(steps);
  }
  /// Wild ones: robots fall.
  void move(double size) {
    const std::size_t each = batch_.joints();
    std::vector<double> targets(batch_.size() * each);
    for (double& target : targets) target = size * std::sin(++turn_ * 0.7);
    batch_.set_joint_target(targets);
    for (std::size_t i = 0; i < alone_.size(); ++i)
      alone_[i].robot().set_joint_target(std::span(targets).subspan(i * each, each));
  }
  void reset(std::uint64_t seed, std::size_t every, std::size_t from) {
    std::vector<std::uint8_t> which(batch_.size());
    for (std::size_t i = from; i < which.size(); i += every) {
      which[i] = 1;
      alone_[i].reset(seed + i);
    }
    batch_.reset(seed, which);
  }
  void expect_equal() {
    const auto q = batch_.joint_position();
    const std::size_t each = batch_.joints();
    for (std::size_t i = 0; i < alone_.size(); ++i) {
      EXPECT_EQ(batch_.state_hash(i), alone_[i].state_hash()) << "world " << i << " of " << alone_.size();
      const auto own = alone_[i].robot().joint_position();
      for (std::size_t k = 0; k < each; ++k) EXPECT_EQ(q[i * each + k], own[k]);
      EXPECT_EQ(batch_.fallen()[i], alone_[i].robot().fallen());
    }
  }
  void expect_equal_targets() {
    const auto targets = batch_.joint_target();
    const std::size_t each = batch_.joints();
    for (std::size_t i = 0; i < alone_.size(); ++i)
      EXPECT_TRUE(std::ranges::equal(targets.subspan(i * each, each), alone_[i].robot().joint_target())) << i;
    EXPECT_FALSE(std::ranges::equal(targets, batch_.joint_position()));
  }
  void expect_equal_balls() {
    const auto position = batch_.ball_position(), velocity = batch_.ball_velocity();
    ASSERT_EQ(position.size(), 3 * alone_.size());
    std::size_t moved = 0;
    for (std::size_t i = 0; i < alone_.size(); ++i) {
      const EntityHandle ball = alone_[i].entity("ball");
      EXPECT_EQ(position[3 * i], ball.pose().position.x) << i;
      EXPECT_EQ(position[3 * i + 2], ball.pose().position.z) << i;
      EXPECT_EQ(velocity[3 * i + 1], ball.velocity().linear.y) << i;
      if (velocity[3 * i] != 0) ++moved;
    }
    EXPECT_GT(moved, 0U);
  }

 private:
  static SceneOptions with_seed(SceneOptions options) {
    options.seed = 1;
    return options;
  }

  Batch batch_;
  std::vector<Scene> alone_;
  double turn_ = 0;
};

/// Falls, resets of some, and times that differ from world to world.
void compare(BatchAndScenes worlds) {
  worlds.expect_equal();
  worlds.step(30);
  worlds.expect_equal();
  worlds.move(0.9);
  worlds.step(7);
  worlds.reset(40, 3, 1);
  worlds.expect_equal();
  worlds.step(250);
  worlds.move(0.4);
  worlds.step(3);
  worlds.reset(7, 2, 0);
  for (int i = 0; i < 4; ++i) {
    worlds.move(1.2);
    worlds.step(100);
  }
  worlds.expect_equal();
}

TEST(ApiBatchLanes, EachWorldIsASceneAlone) {
  for (const char* level : {"articulated_dynamics", "simplified_dynamics"}) {
    for (const std::size_t worlds : {1U, 7U, 8U, 9U, 21U}) {
      for (const int threads : {1, 2}) {
        SCOPED_TRACE(fmt::format("{}, {} worlds, {} threads", level, worlds, threads));
        compare({"walk", worlds, options_of(level, {"walker.sensors=false"}), threads});
      }
    }
  }
}

TEST(ApiBatchLanes, AlsoManyWithSensors) { compare({"walk", 64, options_of("articulated_dynamics"), 2}); }

TEST(ApiBatchLanes, AlsoAtOtherLevels) {
  compare({"walk", 9, options_of("full_dynamics"), 2});
  compare({"walk", 3, options_of("articulated_dynamics", {"walker.contact=kelvin_voigt"}), 1});
}

TEST(ApiBatchLanes, SomeFall) {
  Batch batch("walk", 16, options_of("articulated_dynamics"));
  std::vector<double> targets(batch.size() * batch.joints());
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = std::sin(0.7 * static_cast<double>(i));
  batch.set_joint_target(targets);
  batch.step(3000);
  EXPECT_GT(std::ranges::count(batch.fallen(), 1), 3);
}

TEST(ApiBatchLanes, AlsoWalkingOnesWithTheirEngines) {
  for (const char* level : {"articulated_dynamics", "kinematic_walking"}) {
    BatchAndScenes worlds("walk", 10, {.set = {std::string("walker.level=") + level, "start.jitter_heading_deg=20"}},
                          2);
    worlds.step(105);
    worlds.reset(3, 2, 1);
    worlds.step(701);
    worlds.expect_equal();
    worlds.expect_equal_targets();
  }
}

TEST(ApiBatchLanes, TargetsThatWereGivenAreShownAtOnce) {
  BatchAndScenes worlds("walk", 9, options_of("articulated_dynamics"), 1);
  worlds.move(0.4);
  worlds.expect_equal_targets();
  worlds.reset(30, 2, 1);
  worlds.step(5);
  worlds.expect_equal_targets();
}

TEST(ApiBatchLanes, AlsoTeamsWithABall) {
  BatchAndScenes worlds("three_on_three", 5, {.cameras = false}, 2);
  worlds.step(200);
  worlds.reset(9, 2, 0);
  worlds.step(601);
  worlds.expect_equal();
}

/// States that differ in what is zero come after each other to the same place: of fallen robots, and of new ones beside a ball.
TEST(ApiBatchLanes, AlsoKickingOnesWithABall) {
  const std::vector<std::string> set = {"robot.level=articulated_dynamics", "robot.controller=none",
                                        "start.jitter_posture_deg=5"};
  BatchAndScenes worlds("kick", 19, {.set = set, .cameras = false}, 1);
  for (const std::size_t from : {0U, 1U, 2U}) {
    worlds.move(1.5);
    worlds.step(150);
    worlds.reset(20 + from, 3, from);
    worlds.step(150);
  }
  worlds.expect_equal();
  worlds.expect_equal_balls();
}

TEST(ApiBatchLanes, PushedOnesStayInTheBatch) {
  BatchAndScenes worlds("walk", 11, options_of("articulated_dynamics"), 2);
  worlds.step(20);
  for (const std::size_t world : {2U, 3U, 10U}) {
    worlds.batch().push(world, "torso", {20, 5, 0}, 0.05, {0, 0.1, 0});
    worlds.alone(world).robot().push("torso", {20, 5, 0}, 0.05, {0, 0.1, 0});
  }
  worlds.step(33);
  worlds.expect_equal();
  worlds.step(60);
  worlds.expect_equal();
  EXPECT_THROW(worlds.batch().push(11, "", {1, 0, 0}, 0.1), InputError);
  EXPECT_THROW(worlds.batch().push(1, "tail", {1, 0, 0}, 0.1), UnknownName);
  EXPECT_THROW((void)worlds.batch().ball_position(), UnknownName);
  worlds.expect_equal();
}

TEST(ApiBatchLanes, AWorldThatIsAskedForGoesOnAsASceneOfItsOwn) {
  BatchAndScenes worlds("walk", 10, options_of("articulated_dynamics"), 2);
  worlds.move(0.5);
  worlds.step(50);
  Scene third = worlds.batch().world(3);
  EXPECT_EQ(third.state_hash(), worlds.alone(3).state_hash());
  third.robot().push("torso", {30, 0, 0}, 0.1);
  worlds.alone(3).robot().push("torso", {30, 0, 0}, 0.1);
  worlds.step(60);
  worlds.move(0.3);
  worlds.step(60);
  worlds.expect_equal();
  EXPECT_EQ(third.state_hash(), worlds.alone(3).state_hash());
  EXPECT_EQ(worlds.batch().world(3).state_hash(), third.state_hash());
}

TEST(ApiBatchLanes, WhatIsPlannedForLaterHappensToo) {
  SceneOptions options = options_of("articulated_dynamics");
  options.events = {"0.05:walker.level=simplified_dynamics"};
  BatchAndScenes worlds("walk", 3, options, 2);
  worlds.step(100);
  worlds.expect_equal();
  EXPECT_EQ(worlds.batch().world(2).robot().level(), "simplified_dynamics");
}

TEST(ApiBatchLanes, ALevelIsThatOfScenesThatWereOpenedWithIt) {
  Batch batch("walk", 9, options_of("articulated_dynamics"), 2);
  batch.step(50);
  EXPECT_THROW(batch.set_level("articulated_dynamic"), InputError);
  batch.step(10);
  const Scene before = [] {
    SceneOptions options = options_of("articulated_dynamics");
    options.seed = 9;
    Scene scene("walk", options);
    scene.step(60);
    return scene;
  }();
  EXPECT_EQ(batch.state_hash(8), before.state_hash());
  for (const char* level : {"simplified_dynamics", "articulated_dynamics"}) {
    batch.set_level(level);
    batch.step(70);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      SceneOptions options = options_of(level);
      options.seed = 1 + i;
      Scene alone("walk", options);
      alone.step(70);
      EXPECT_EQ(batch.state_hash(i), alone.state_hash()) << level << i;
    }
    EXPECT_EQ(batch.world(4).robot().level(), level);
  }
}

}  // namespace
}  // namespace murosimf::api
