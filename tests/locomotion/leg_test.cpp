// Inverse kinematics against direct kinematics, and legs found in models.
#include "murosimf/locomotion/leg.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/leg_ik.h"
#include "murosimf/math/random.h"
#include "murosimf/multibody/kinematics.h"
#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

Mat3d foot_turn(const std::array<double, 6>& q) {
  return rotation_z(q[0]) * rotation_x(q[1]) * rotation_y(q[2] + q[3] + q[4]) * rotation_x(q[5]);
}
Vec3d ankle_place(const std::array<double, 6>& q, double thigh, double shin) {
  const Mat3d hip = rotation_z(q[0]) * rotation_x(q[1]) * rotation_y(q[2]);
  return hip * (Vec3d{0, 0, -thigh} + rotation_y(q[3]) * Vec3d{0, 0, -shin});
}

// Different leg lengths; 1e-9 rad is rounding away from the stretched knee, where the angle is ill-conditioned (knee >
// 0.1 rad here).
TEST(LegIk, InvertsDirectKinematics) {
  const RandomStream random(1, "leg_ik");
  std::uint64_t n = 0;
  const auto draw = [&](double low, double high) { return random.uniform(n++, low, high); };
  law::Worst error;
  for (int i = 0; i < 10000; ++i) {
    const double thigh = draw(0.08, 0.4), shin = draw(0.08, 0.4);
    const std::array<double, 6> q{draw(-0.8, 0.8), draw(-0.6, 0.6), draw(-1.2, 0.6),
                                  draw(0.1, 2.2),  draw(-0.9, 0.9), draw(-0.6, 0.6)};
    const LegAngles found = leg_angles(thigh, shin, ankle_place(q, thigh, shin), foot_turn(q));
    EXPECT_TRUE(found.reachable);
    for (std::size_t k = 0; k < 6; ++k) error.see(std::abs(found.q[k] - q[k]), "joint", k, "posture", i);
  }
  law::expect_below({.law = "inverse kinematics of the leg: error of angles, 10,000 postures",
                     .level = "leg_ik",
                     .source = "IK(FK(q)) = q"},
                    error, 1e-9, "rad");
}

TEST(LegIk, TooFarPointsAtTheTarget) {
  const LegAngles found = leg_angles(0.12, 0.12, {0, 0, -0.5}, Mat3d{});
  EXPECT_FALSE(found.reachable);
  EXPECT_LT(found.q[3], 0.1);
  EXPECT_NEAR(found.q[1], 0, 1e-12);
}

TEST(Leg, IsFoundInKid21) {
  const auto legs = find_legs(*test::kid21());
  EXPECT_EQ(test::kid21()->objects()[legs[0].joints[3]].name, "j_l_shin");
  EXPECT_EQ(test::kid21()->objects()[legs[1].joints[0]].name, "j_r_hip_yaw");
  for (const Leg& leg : legs) {
    EXPECT_NEAR(leg.thigh, 0.12, 1e-12);
    EXPECT_NEAR(leg.shin, 0.12, 1e-12);
    EXPECT_NEAR(leg.ankle_height, 0.04, 1e-12);
  }
  EXPECT_NEAR(legs[0].hip.y, 0.05, 1e-12);
}

Chain leg_chain(double side, const Vec3d& knee_axis) {
  return Chain{}
      .translation({0, side * 0.06, 0})
      .revolute(side > 0 ? "l_yaw" : "r_yaw", {0, 0, -1})
      .revolute(side > 0 ? "l_roll" : "r_roll", {1, 0, 0})
      .revolute(side > 0 ? "l_pitch" : "r_pitch", {0, 1, 0})
      .translation({0, 0, -0.2})
      .revolute(side > 0 ? "l_knee" : "r_knee", knee_axis)
      .translation({0, 0, -0.18})
      .revolute(side > 0 ? "l_ankle" : "r_ankle", {0, -1, 0})
      .revolute(side > 0 ? "l_foot" : "r_foot", {1, 0, 0})
      .with(properties::mass, 0.5)
      .translation({0, 0, -0.05})
      .endpoint(side > 0 ? "l_sole" : "r_sole")
      .with(properties::sole, {0.1, 0.05});
}

// Every sole of the gait's pose is where the gait puts it, on a robot with other lengths and mirrored axes.
TEST(Gait, FeetAreLevelOnARobotWithMirroredAxes) {
  const Model model(
      "other",
      Chain{}.base("pelvis").with(properties::mass, 3.0).fork(leg_chain(1, {0, -1, 0}), leg_chain(-1, {0, -1, 0})));
  const auto legs = find_legs(model);
  ASSERT_TRUE(legs[0].signs);
  EXPECT_EQ((*legs[0].signs)[0], -1);
  EXPECT_EQ((*legs[0].signs)[3], -1);
  const WalkParameters p = seeded_parameters(legs);
  const GaitPose pose = gait_pose(legs, p, 0, 0, {});
  EXPECT_TRUE(pose.reachable);
  std::vector<double> q(static_cast<std::size_t>(model.size()));
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) q[legs[side].joints[i]] = pose.q[side][i];
  }
  std::vector<Vec3d> r(q.size());
  std::vector<Mat3d> R(q.size());
  R[0] = rotation_y(p.pitch);  // the pelvis leans forward, the feet must be level
  multibody::poses<double>(model.tree(), q, r, R);
  law::Worst tilt, height;
  for (const char* name : {"l_sole", "r_sole"}) {
    const int sole = model.object_index(name);
    tilt.see(std::abs(R[sole].z.z - 1), name);
    const Vec3d hip = R[0] * legs[0].hip;
    height.see(std::abs(r[sole].z - hip.z + p.hip_height), name);
  }
  law::expect_below({.law = "gait on a robot with mirrored axes: 1 - cos of the soles' tilt",
                     .level = "gait",
                     .source = "soles are level"},
                    tilt, 1e-12, "");
  law::expect_below({.law = "gait on a robot with mirrored axes: error of the soles' height",
                     .level = "gait",
                     .source = "the hip height of the parameters"},
                    height, 1e-9, "m");
}

TEST(Leg, WhatIsNoLegIsRefusedWithTheReason) {
  const Model model(
      "crooked",
      Chain{}.base("pelvis").with(properties::mass, 3.0).fork(leg_chain(1, {1, 0, 0}), leg_chain(-1, {0, 1, 0})));
  try {
    (void)find_legs(model);
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("its knee turns about (1 0 0), not sideways"), std::string::npos)
        << error.what();
  }
}

// The seed formula returns the parameters that were found for kid21; the sway by the pendulum within 0.1 mm.
TEST(Gait, SeedsGiveKid21ItsOwnParameters) {
  const WalkParameters seeded = seeded_parameters(find_legs(*test::kid21()));
  const WalkParameters found;
  EXPECT_NEAR(seeded.period, found.period, 1e-12);
  EXPECT_NEAR(seeded.hip_height, found.hip_height, 1e-12);
  EXPECT_NEAR(seeded.half_width, found.half_width, 1e-12);
  law::expect_near({.law = "seeded walk parameters of kid21: sway",
                    .level = "gait",
                    .source = "what was found for kid21 by search; the seed is the pendulum's"},
                   seeded.sway, found.sway, 1e-4, "m");
}

// The gait is continuous in phase: at a control cycle's step no foot jumps by more than the swing's top speed allows.
TEST(Gait, IsContinuous) {
  const auto legs = find_legs(*test::kid21());
  const WalkParameters p = seeded_parameters(legs);
  const double step = 0.001;
  auto before = gait_pose(legs, p, 2 * pi - step, 1, {0.25, 0.1, 0.5});
  law::Worst jump;
  for (double phase = 0; phase < 2 * pi; phase += step) {
    const auto pose = gait_pose(legs, p, phase, 1, {0.25, 0.1, 0.5});
    EXPECT_TRUE(pose.reachable);
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < 6; ++i)
        jump.see(std::abs(pose.q[side][i] - before.q[side][i]), "phase", phase, "side", side, "joint", i);
    }
    before = pose;
  }
  law::expect_below({.law = "gait at full speed: largest change of a joint target per 0.001 rad of phase",
                     .level = "gait",
                     .source = "it is continuous, as fast as the swing allows"},
                    jump, 0.02, "rad");
}

}  // namespace
}  // namespace murosimf::locomotion
