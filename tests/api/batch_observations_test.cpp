// Batch::observe: numbers of robots by names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "murosimf/batch.h"

namespace murosimf::api {
namespace {

const std::vector<std::string> names = {"base.gravity",          "base.linear_velocity",
                                        "base.angular_velocity", "joint_position",
                                        "joint_velocity",        "last_action",
                                        "torso.position",        "lying",
                                        "head.orientation"};

Batch moving(std::size_t worlds) {
  Batch batch("walk", worlds, {.set = {"walker.level=articulated_dynamics", "walker.controller=none"}}, 2);
  std::vector<double> targets(worlds * batch.joints());
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = 0.8 * std::sin(0.9 * static_cast<double>(i));
  batch.set_joint_target(targets);
  batch.step(400);
  return batch;
}

/// R^T v, by the rotation (w, x, y, z) of the base: v + 2 u x (u x v - w v), u = (x, y, z), of the inverse.
Vector3 from_base(const Rotation& q, const Vector3& v) {
  const Vector3 u{-q.x, -q.y, -q.z};
  const Vector3 t{2 * (u.y * v.z - u.z * v.y), 2 * (u.z * v.x - u.x * v.z), 2 * (u.x * v.y - u.y * v.x)};
  return {v.x + q.w * t.x + u.y * t.z - u.z * t.y, v.y + q.w * t.y + u.z * t.x - u.x * t.z,
          v.z + q.w * t.z + u.x * t.y - u.y * t.x};
}

void expect_near(std::span<const float> seen, const Vector3& v) {
  EXPECT_NEAR(seen[0], v.x, 1e-5);
  EXPECT_NEAR(seen[1], v.y, 1e-5);
  EXPECT_NEAR(seen[2], v.z, 1e-5);
}

TEST(ApiBatchObservations, AreWhatTheWorldsShow) {
  constexpr std::size_t worlds = 11;
  Batch batch = moving(worlds);
  const std::size_t n = batch.joints(), width = 3 * 3 + 3 * n + 3 + 1 + 9;
  const std::span<const float> seen = batch.observe(names);
  ASSERT_EQ(seen.size(), worlds * width);
  for (std::size_t i = 0; i < worlds; ++i) {
    Scene world = batch.world(i);
    const Robot robot = world.robot();
    const std::span<const float> row = seen.subspan(i * width, width);
    const Rotation turned = robot.pose().orientation;
    expect_near(row, from_base(turned, {0, 0, -1}));
    expect_near(row.subspan(3), from_base(turned, robot.velocity().linear));
    expect_near(row.subspan(6), from_base(turned, robot.velocity().angular));
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(row[9 + k], static_cast<float>(robot.joint_position()[k]));
      EXPECT_EQ(row[9 + n + k], static_cast<float>(robot.joint_velocity()[k]));
      EXPECT_EQ(row[9 + 2 * n + k], static_cast<float>(robot.joint_target()[k]));
    }
    expect_near(row.subspan(9 + 3 * n), robot.pose("torso").position);
    EXPECT_EQ(row[12 + 3 * n], robot.fallen() ? 1 : 0);
    const auto head = robot.get("head", "orientation");
    for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(row[13 + 3 * n + k], static_cast<float>(head[k]));
  }
}

TEST(ApiBatchObservations, AreRenewedByStepsAndResets) {
  Batch batch = moving(10), other = moving(10);
  const std::span<const float> seen = batch.observe(names);
  const std::uint8_t which[] = {1, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  for (Batch* one : {&batch, &other}) {
    one->step(30);
    one->reset(which);
    one->step(3);
  }
  const std::span<const float> anew = other.observe(names);
  EXPECT_TRUE(std::ranges::equal(seen, anew));
  EXPECT_EQ(batch.observe(names).data(), seen.data());
  EXPECT_EQ(batch.observe({"lying"}).size(), 10U);
}

TEST(ApiBatchObservations, UnknownNamesAreRefused) {
  Batch batch = moving(2);
  EXPECT_THROW((void)batch.observe({"joint_positon"}), UnknownName);
  EXPECT_THROW((void)batch.observe({"tors.position"}), UnknownName);
  EXPECT_THROW((void)batch.observe({"torso.positions"}), UnknownName);
  EXPECT_TRUE(batch.observe({}).empty());
}

}  // namespace
}  // namespace murosimf::api
