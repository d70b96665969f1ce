// The modes of a Booster robot: which requests each of them takes, and how a fall ends them.
#include <algorithm>

#include "murosimf/dds/booster/robot_modes.h"

#include <gtest/gtest.h>

#include "murosimf/dds/booster/joint_order.h"
#include "murosimf/model/error.h"

namespace murosimf::dds::booster {
namespace {

constexpr Posture up{}, down{.fallen = true}, rising{.fallen = true, .gets_up = true};
constexpr std::int64_t walking = 2, soccer = 4;

TEST(RobotModes, WalkOnlyWhereItWalks) {
  for (std::int64_t mode = 0; mode <= 4; ++mode) {
    RobotModes modes;
    EXPECT_EQ(modes.change(mode), Status::success);
    EXPECT_EQ(static_cast<std::int64_t>(modes.mode()), mode);
    const bool walks = mode == walking || mode == soccer;
    EXPECT_EQ(modes.move({0.1, 0, 0}), walks ? Status::success : Status::conflict) << mode;
    EXPECT_EQ(modes.velocity().x, walks ? 0.1 : 0);
    EXPECT_EQ(modes.change(mode), Status::success);
    EXPECT_EQ(modes.velocity().x, 0) << "a change stops it";
    EXPECT_EQ(modes.uses_motions(), mode != 0 && mode != 3);
  }
  RobotModes modes;
  for (const std::int64_t mode : {-1, 5, 1 << 30}) EXPECT_EQ(modes.change(mode), Status::bad_request);
  EXPECT_EQ(modes.mode(), Mode::prepare);
}

TEST(RobotModes, GoLimpAfterAFallUntilAskedToGetUp) {
  RobotModes modes(Mode::soccer);
  EXPECT_EQ(modes.get_up(walking, up), Status::conflict);
  EXPECT_EQ(modes.move({0.1, 0, 0}), Status::success);
  modes.follow(down);
  EXPECT_EQ(modes.mode(), Mode::damping);
  EXPECT_EQ(modes.fall_down(down), FallDown::fallen);
  EXPECT_EQ(modes.move({0.1, 0, 0}), Status::conflict);
  EXPECT_EQ(modes.get_up(3, down), Status::bad_request);
  EXPECT_EQ(modes.get_up(soccer, down), Status::success);
  for (const Posture& posture : {down, rising, rising}) {
    modes.follow(posture);
    EXPECT_TRUE(modes.rises());
    EXPECT_EQ(modes.body_control(), 7);
    EXPECT_EQ(modes.fall_down(posture), FallDown::getting_up);
    EXPECT_EQ(modes.move({0.1, 0, 0}), Status::conflict);
  }
  modes.follow(up);
  EXPECT_FALSE(modes.rises());
  EXPECT_EQ(modes.mode(), Mode::soccer);
  EXPECT_EQ(modes.velocity().x, 0) << "the old command is over";
  EXPECT_EQ(modes.body_control(), 5);
}

// At kinematic_walking robots neither fall nor lie.
TEST(RobotModes, AreUpAtOnceWhereNothingFalls) {
  RobotModes modes;
  EXPECT_EQ(modes.lie_down(), Status::success);
  modes.follow(up);
  EXPECT_EQ(modes.get_up(walking, up), Status::success);
  modes.follow(up);
  EXPECT_FALSE(modes.rises());
  EXPECT_EQ(modes.move({0.1, 0, 0}), Status::success);
}

TEST(RobotModes, LieWhereTheyWereAskedTo) {
  RobotModes modes;
  EXPECT_EQ(modes.lie_down(), Status::success);
  modes.follow(down);
  EXPECT_TRUE(modes.lies());
  EXPECT_EQ(modes.mode(), Mode::prepare) << "that is no fall";
  EXPECT_EQ(modes.lie_down(), Status::conflict);
  EXPECT_EQ(modes.change(walking), Status::conflict);
  EXPECT_EQ(modes.get_up(walking, down), Status::success);
  EXPECT_FALSE(modes.lies());
  EXPECT_EQ(RobotModes(Mode::custom).lie_down(), Status::conflict);
}

TEST(RobotModes, LowLevelCommandsMayFallAsTheyLike) {
  RobotModes modes(Mode::custom);
  modes.follow(down);
  EXPECT_EQ(modes.mode(), Mode::custom);
  EXPECT_EQ(modes.change(0), Status::success);
  EXPECT_EQ(modes.fall_down({.falling = true}), FallDown::falling);
}

TEST(JointOrder, KnowsTheFilesOfTheVendor) {
  for (const JointOrder& order : joint_orders()) {
    std::vector<std::string> names;
    for (const std::string_view name : order.names) {
      const bool first = name.starts_with("head_y") || name == "left_shoulder_pitch" || name == "right_shoulder_pitch";
      names.push_back((first ? "A" : "") + std::string(name));
      if (name == "head_yaw") names.back() = "AAHead_yaw";
    }
    std::reverse(names.begin(), names.end());
    const PlacedJoints placed = place_joints(names);
    EXPECT_EQ(placed.order->model, order.model);
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(placed.places[i], names.size() - 1 - i);
    names.back() = "other";
    EXPECT_THROW((void)place_joints(names), SetupError);
  }
}

}  // namespace
}  // namespace murosimf::dds::booster
