// include/murosimf/batch.h: worlds together are worlds alone.
#include "murosimf/batch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace murosimf::api {
namespace {

SceneOptions jittered() {
  return {.set = {"start.jitter_heading_deg=20", "walker.level=simplified_dynamics", "walker.controller=none"}};
}

TEST(ApiBatch, WorldsAreThoseOfTheirSeeds) {
  for (const int threads : {1, 2}) {
    Batch batch("walk", 5, jittered(), threads);
    batch.step(100);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      SceneOptions options = jittered();
      options.seed = 1 + i;  // that of the scene is 1
      Scene alone("walk", options);
      alone.step(100);
      EXPECT_EQ(batch.world(i).state_hash(), alone.state_hash()) << i;
    }
  }
}

TEST(ApiBatch, RowsAreThoseOfTheWorlds) {
  Batch batch("walk", 3, jittered());
  const std::size_t n = batch.joints();
  std::vector<double> targets(3 * n);
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = 0.1 * std::sin(static_cast<double>(i));
  batch.set_joint_target(targets);
  batch.step(300);
  const std::span<const double> q = batch.joint_position(), pose = batch.base_pose(), v = batch.base_velocity();
  ASSERT_EQ(q.size(), 3 * n);
  ASSERT_EQ(pose.size(), 21U);
  ASSERT_EQ(v.size(), 18U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Robot robot = batch.world(i).robot();
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(q[i * n + k], robot.joint_position()[k]);
      EXPECT_EQ(targets[i * n + k], robot.joint_target()[k]);
      EXPECT_EQ(batch.joint_velocity()[i * n + k], robot.joint_velocity()[k]);
    }
    EXPECT_EQ(pose[7 * i + 2], robot.pose().position.z);
    EXPECT_EQ(pose[7 * i + 3], robot.pose().orientation.w);
    EXPECT_EQ(v[6 * i + 5], robot.velocity().angular.z);
    EXPECT_EQ(batch.fallen()[i], robot.fallen());
  }
  EXPECT_EQ(batch.joint_position().data(), q.data());
  targets.pop_back();
  EXPECT_THROW(batch.set_joint_target(targets), InputError);
}

TEST(ApiBatch, SomeAreResetAndOthersGoOn) {
  Batch batch("walk", 3, jittered());
  const std::uint64_t start = batch.world(1).state_hash();
  batch.step(50);
  const std::uint64_t first = batch.world(0).state_hash();
  const std::uint8_t which[] = {0, 1, 0};
  batch.reset(which);
  EXPECT_EQ(batch.world(0).state_hash(), first);
  EXPECT_EQ(batch.world(1).state_hash(), start);
  batch.reset(100);
  EXPECT_NE(batch.world(1).state_hash(), start);
  const Batch other("walk", 2, {.seed = 100, .set = jittered().set});
  EXPECT_EQ(batch.world(1).state_hash(), other.world(1).state_hash());
  EXPECT_THROW(batch.reset(std::span(which, 2)), InputError);
  EXPECT_THROW((void)batch.world(3), InputError);
  EXPECT_THROW(Batch("walk", 0), InputError);
  EXPECT_THROW(Batch("walk", 1, {}, 0), InputError);
  EXPECT_THROW(Batch("wlak", 2), InputError);
  const Batch moved = std::move(batch);
  EXPECT_EQ(moved.size(), 3U);
  EXPECT_THROW(batch.step(), Error);  // NOLINT(bugprone-use-after-move): it is looked at
}

}  // namespace
}  // namespace murosimf::api
