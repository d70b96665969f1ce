// Key-frame motions: the blend, the joints that get their targets, feet by inverse kinematics.
#include "murosimf/locomotion/keyframe_player.h"

#include <gtest/gtest.h>

#include <functional>

#include "murosimf/locomotion/gait_properties.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

const KeyframeMotion wave{.name = "wave",
                          .columns = {{{"j_head", 1}}, {{"j_l_sh_pitch", 1}, {"j_r_sh_pitch", -1}}},
                          .start = {0.1, 0.0},
                          .frames = {{0.5, {0.1, 1.0}}, {1.0, {0.5, -1.0}}}};

TEST(KeyframeMotion, RunsAlongACosineFromFrameToFrame) {
  std::vector<double> values(2);
  const auto at = [&](double time) {
    sample(wave, time, values);
    return values;
  };
  EXPECT_DOUBLE_EQ(duration(wave), 1.5);
  EXPECT_EQ(at(-1), wave.start);
  EXPECT_EQ(at(0), wave.start);
  EXPECT_NEAR(at(0.25)[1], 0.5, 1e-15) << "half way in the middle";
  EXPECT_NEAR(at(0.5 / 3)[1], 0.25, 1e-15) << "cos 60 degrees is one half";
  EXPECT_EQ(at(0.5), wave.frames[0].values);
  EXPECT_NEAR(at(1.0)[0], 0.3, 1e-15);
  EXPECT_EQ(at(1.5), wave.frames[1].values);
  EXPECT_EQ(at(99), wave.frames[1].values);
}

TEST(KeyframeMotion, IsAtRestInEveryFrame) {
  std::vector<double> before(2), after(2);
  for (const double time : {0.0, 0.5, 1.5}) {
    sample(wave, time - 1e-4, before);
    sample(wave, time + 1e-4, after);
    EXPECT_NEAR(after[1] - before[1], 0, 1e-6) << time;
  }
}

struct Player {
  explicit Player(const KeyframeMotion& motion)
      : robot(rig.add("robot", test::kid21())),
        player(rig.simulation.attach<KeyframePlayer>("keyframe_player", robot, KeyframePlayer::rate_hz, motion)) {
    rig.simulation.attach<dynamics::KinematicWalking>("kinematic_walking", robot, 1000);
  }
  double target(const char* joint) { return robot.object(joint).get(properties::joint_target); }
  test::Rig rig;
  Entity& robot;
  KeyframePlayer& player;
};

TEST(KeyframePlayer, PlaysAnotherMotionFromTheNextStart) {
  Player player(wave);
  player.rig.run(0.5);
  KeyframeMotion other = wave;
  other.start[0] = -0.2;
  other.frames = {{0.1, {0.7, 0.0}}};
  player.player.play(other);
  player.rig.simulation.reset();
  EXPECT_NEAR(player.target("j_head"), -0.2, 1e-12);
  player.rig.run(0.2);
  EXPECT_NEAR(player.target("j_head"), 0.7, 1e-12);
}

TEST(KeyframePlayer, SetsTheJointsThatTheMotionNames) {
  Player player(wave);
  player.rig.run(0.001);
  player.rig.run(0.499);  // the step at 0.49 s writes what holds from 0.50 s on
  EXPECT_NEAR(player.target("j_l_sh_pitch"), 1, 1e-12);
  EXPECT_NEAR(player.target("j_r_sh_pitch"), -1, 1e-12);
  EXPECT_NEAR(player.target("j_head"), 0.1, 1e-12);
  EXPECT_EQ(player.target("j_l_shin"), 0);
  player.rig.run(3.0);
  EXPECT_NEAR(player.target("j_l_sh_pitch"), -1, 1e-12) << "the last frame is held";
  EXPECT_NEAR(player.robot.base().get(properties::motion_time), 1.5, 1e-12);
}

TEST(KeyframePlayer, PutsFeetWhereTheMotionSays) {
  const KeyframeMotion step{.name = "step",
                            .columns = {{{"right_foot.x", 1}}, {{"right_foot.z", 1}}},
                            .start = {0.0, 0.0},
                            .frames = {{0.5, {0.04, 0.03}}}};
  Player player(step);
  player.rig.run(0.001);
  const auto between_soles = [&] {
    return player.robot.object("r_sole").get(properties::position) -
           player.robot.object("l_sole").get(properties::position);
  };
  const Vec3d start = between_soles();
  player.rig.run(2.0);
  const Vec3d moved = between_soles() - start;
  EXPECT_NEAR(moved.x, 0.04, 1e-6);
  EXPECT_NEAR(moved.y, 0, 1e-6);
  EXPECT_NEAR(moved.z, 0.03, 1e-6);
}

TEST(KeyframePlayer, StandsAsTheWalkEngineDoes) {
  const KeyframeMotion stand{.name = "stand", .columns = {{{"left_foot.x", 1}}}, .start = {0}, .frames = {{1, {0}}}};
  Player player(stand);
  player.rig.run(0.1);
  const auto legs = find_legs(*test::kid21());
  const GaitPose pose = gait_pose(legs, seeded_parameters(legs), 0, 0, {});
  const auto& column = player.robot.column(properties::joint_target);
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(column.values[legs[side].joints[i]], pose.q[side][i], 1e-12);
    }
  }
}

std::string refusal(const std::string& channel) {
  try {
    Player player({.name = "bad", .columns = {{{channel, 1}}}, .start = {0}, .frames = {{1, {0}}}});
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(KeyframePlayer, RefusesWhatTheModelDoesNotHave) {
  EXPECT_NE(refusal("j_l_shn").find("unknown joint or foot 'j_l_shn'; did you mean 'j_l_shin'?"), std::string::npos);
  EXPECT_NE(refusal("l_foot").find("unknown joint"), std::string::npos) << "a body is no joint";
  EXPECT_NE(refusal("left_foot.q").find("unknown joint"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::locomotion
