// Batch::randomize: numbers that differ from world to world.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "murosimf/batch.h"

namespace murosimf::api {
namespace {

const SceneOptions standing{.set = {"walker.level=articulated_dynamics", "walker.controller=none"}};
const std::vector<Randomized> drawn_properties = {{"torque_enabled", 0.5, 0.9}, {"torso.applied_force", -8, 8, false}};

std::vector<double> drawn(const Batch& batch, std::size_t world, const char* object, const char* property) {
  return batch.world(world).robot().get(object, property);
}

TEST(ApiBatchRandom, EachWorldIsASceneWithItsNumbers) {
  Batch batch("walk", 10, standing, 2), looked_at("walk", 10, standing);
  for (Batch* one : {&batch, &looked_at}) {
    one->randomize(drawn_properties);
    one->reset();
  }
  batch.step(300);
  for (const std::size_t i : {0U, 3U, 9U}) {
    SceneOptions options = standing;
    options.seed = 1 + i;
    Scene alone("walk", options);
    const Robot robot = alone.robot(), like = looked_at.world(i).robot();
    for (const JointInfo& joint : robot.joints())
      alone.robot().set(joint.name, "torque_enabled", like.get(joint.name, "torque_enabled"));
    alone.robot().set("torso", "applied_force", like.get("torso", "applied_force"));
    alone.step(300);
    EXPECT_EQ(batch.state_hash(i), alone.state_hash()) << i;
  }
}

TEST(ApiBatchRandom, NumbersFollowFromTheSeedAndFillTheirRange) {
  Batch batch("walk", 60, standing), fewer("walk", 5, standing, 2);
  const double usual = drawn(batch, 0, "j_l_shin", "torque_enabled")[0];
  for (Batch* one : {&batch, &fewer}) {
    one->randomize(drawn_properties);
    one->reset();
  }
  std::set<double> seen;
  double sum = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const double share = drawn(batch, i, "j_l_shin", "torque_enabled")[0] / usual;
    EXPECT_GE(share, 0.5);
    EXPECT_LE(share, 0.9);
    seen.insert(share);
    sum += share;
  }
  EXPECT_EQ(seen.size(), batch.size());
  EXPECT_NEAR(sum / 60, 0.7, 4 * 0.4 / std::sqrt(12.0 * 60));  // four standard deviations
  EXPECT_EQ(drawn(batch, 4, "torso", "applied_force"), drawn(fewer, 4, "torso", "applied_force"));
  EXPECT_NE(drawn(batch, 4, "torso", "applied_force"), drawn(batch, 5, "torso", "applied_force"));
  batch.randomize({});
  batch.reset();
  EXPECT_EQ(drawn(batch, 7, "j_l_shin", "torque_enabled")[0], usual);
}

TEST(ApiBatchRandom, WhatIsWrongIsRefused) {
  Batch batch("walk", 2, standing);
  EXPECT_THROW(batch.randomize({{"torque_enable", 0.5, 0.9}}), UnknownName);
  EXPECT_THROW(batch.randomize({{"torque_enabled", 0.9, 0.5}}), InputError);
}

}  // namespace
}  // namespace murosimf::api
