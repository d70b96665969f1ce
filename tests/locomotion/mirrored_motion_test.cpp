// Motions for the other side: partners by geometry, for robots of several manufacturers, and the mirrored path of a motion.
#include "murosimf/locomotion/mirrored_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/keyframe_player.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/motion_file.h"
#include "tests/physics/rig.h"
#include "tests/robot_data.h"

namespace murosimf::locomotion {
namespace {

const KeyframeMotion all_kinds{.name = "all",
                               .columns = {{{"left_foot.y", 1}, {"right_foot.y", -1}},
                                           {{"left_foot.x", -1}},
                                           {{"right_foot.pitch", 1}},
                                           {{"j_l_sh_pitch", 1}, {"j_r_upper_arm", -1}},
                                           {{"j_head", 1}, {"j_neck", 1}, {"j_torso", -1}}},
                               .start = {1, 2, 3, 4, 5},
                               .frames = {{0.5, {5, 4, 3, 2, 1}}}};

using Columns = std::vector<std::vector<std::pair<std::string, double>>>;

Columns names_and_signs(const KeyframeMotion& motion) {
  Columns all;
  for (const auto& column : motion.columns) {
    auto& one = all.emplace_back();
    for (const Channel& channel : column) one.emplace_back(channel.name, channel.sign);
  }
  return all;
}

TEST(MirroredMotion, SwapsSidesAndSigns) {
  const KeyframeMotion image = mirrored(all_kinds, *test::kid21());
  EXPECT_EQ(names_and_signs(image), (Columns{{{"right_foot.y", -1}, {"left_foot.y", 1}},
                                             {{"right_foot.x", -1}},
                                             {{"left_foot.pitch", 1}},
                                             {{"j_r_sh_pitch", 1}, {"j_l_upper_arm", 1}},
                                             {{"j_head", 1}, {"j_neck", -1}, {"j_torso", 1}}}));
  EXPECT_EQ(image.start, all_kinds.start);
}

TEST(MirroredMotion, HasTheBallOnTheOtherSide) {
  KeyframeMotion kick = all_kinds;
  EXPECT_FALSE(mirrored(kick, *test::kid21()).kick);
  kick.kick = Kick{{0.2, -0.05, 0}, 0.1};
  const KeyframeMotion image = mirrored(kick, *test::kid21());
  ASSERT_TRUE(image.kick);
  EXPECT_EQ(norm(image.kick->ball - Vec3d{0.2, 0.05, 0}), 0);
  EXPECT_EQ(image.kick->direction, -0.1);
}

TEST(MirroredMotion, TwiceIsTheMotionItself) {
  const ModelPtr model = test::kid21();
  EXPECT_EQ(names_and_signs(mirrored(mirrored(all_kinds, *model), *model)), names_and_signs(all_kinds));
}

TEST(MirroredMotion, IsPlayedWhereTheMotionIsForTheOtherSide) {
  const ModelPtr model = test::kid21();
  KeyframeMotion given = all_kinds;
  EXPECT_EQ(names_and_signs(played_by(*model, given)), names_and_signs(all_kinds));
  given.other_side = true;
  const KeyframeMotion played = played_by(*model, given);
  EXPECT_EQ(names_and_signs(played), names_and_signs(mirrored(all_kinds, *model)));
  EXPECT_FALSE(played.other_side);
}

using Rename = std::function<std::string(const std::string&)>;

/// Partners of all joints are mutual, and those that names indicate.
void expect_pairs(const Model& model, const Rename& other_name) {
  int sided = 0;
  for (const int joint : model.joints()) {
    const std::string& name = model.objects()[joint].name;
    const MirroredJoint other = mirrored_joint(model, joint);
    const MirroredJoint back = mirrored_joint(model, other.joint);
    EXPECT_EQ(back.joint, joint) << name;
    EXPECT_EQ(back.sign, other.sign) << name;
    EXPECT_EQ(model.objects()[other.joint].name, other_name(name));
    sided += other.joint != joint;
  }
  EXPECT_GE(sided, 16);
}

/// Exchanges two words wherever they stand.
Rename exchange(const std::string& left, const std::string& right) {
  return [=](std::string name) {
    const auto at_left = name.find(left), at_right = name.find(right);
    if (at_left != std::string::npos) return name.replace(at_left, left.size(), right);
    if (at_right != std::string::npos) return name.replace(at_right, right.size(), left);
    return name;
  };
}

TEST(MirroredMotion, FindsThePartnersOfEveryJoint) {
  expect_pairs(*test::kid21(), exchange("_l_", "_r_"));
  const auto nao = robot::read_robot(files::find_data_file("spark_nao0", "models", ".xml"), {});
  expect_pairs(*nao.model, [](std::string name) {  // "laj1": first joint of the left arm
    if (name[0] != 'h') name[0] = name[0] == 'l' ? 'r' : 'l';
    return name;
  });
}

TEST(MirroredMotion, FindsThePartnersInARobotOfATeam) {
  if (!std::filesystem::exists(k1_mjcf())) GTEST_SKIP() << "no " << k1_mjcf();
  expect_pairs(*robot::read_robot(k1_mjcf(), {}).model, exchange("Left", "Right"));
}

TEST(MirroredMotion, RefusesAJointWithoutAPartner) {
  Chain chain = Chain{}.base("base").translation({0, 0.1, 0}).revolute("arm", {0, 1, 0}).with(properties::mass, 1.0);
  const Model one_arm("one_arm", chain.with(properties::inertia, diagonal(1.0)));
  try {
    (void)mirrored_joint(one_arm, one_arm.object_index("arm"));
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("joint 'arm' has no partner on the other side"), std::string::npos);
  }
}

/// [m] of the torso in steps of 0.1 s.
std::vector<Vec3d> path_of(const KeyframeMotion& motion) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21(), {.position = {0, 0, 0.28}});
  rig.attach_dynamics(robot, {.level = "simplified_dynamics"});
  rig.simulation.attach<KeyframePlayer>("keyframe_player", robot, KeyframePlayer::rate_hz, motion);
  std::vector<Vec3d> path;
  for (int i = 0; i < 20; ++i) {
    rig.run(0.1);
    path.push_back(robot.object("torso").get(properties::position));
  }
  return path;
}

TEST(MirroredMotion, MovesTheRobotOnTheMirroredPath) {
  const KeyframeMotion kick = robot::read_motion(robot::find_motion("kick"));
  KeyframeMotion other = kick;
  other.other_side = true;
  const std::vector<Vec3d> right = path_of(kick), left = path_of(other);
  double farthest = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    farthest = std::max(farthest, std::abs(right[i].y));
    EXPECT_NEAR(left[i].x, right[i].x, 1e-6) << i;
    EXPECT_NEAR(left[i].y, -right[i].y, 1e-6) << i;
    EXPECT_NEAR(left[i].z, right[i].z, 1e-6) << i;
  }
  EXPECT_GT(farthest, 0.03) << "it shifts its weight";
}

}  // namespace
}  // namespace murosimf::locomotion
