// Search for four legs, and places of the feet in a trot.
#include "murosimf/locomotion/trot.h"

#include <gtest/gtest.h>

#include "tests/law.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

const Model& quadruped() {
  static const ModelPtr model = robot::read_robot(std::string(MUROSIMF_SOURCE_DIR) + "/models/quadruped.xml").model;
  return *model;
}

Vec3d foot_of(const Leg& leg, const TrotPose& pose, std::size_t k) {
  return pose_of(leg.chain, std::span(pose.q[k]).first(leg.joints.size())).tip;
}

TEST(Trot, FindsFourLegsInOrder) {
  const auto legs = find_four_legs(quadruped());
  const std::array<const char*, 4> knees{"j_fl_shin", "j_fr_shin", "j_hl_shin", "j_hr_shin"};
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_EQ(legs[k].joints.size(), 3U);
    EXPECT_EQ(quadruped().objects()[legs[k].joints[2]].name, knees[k]);
    EXPECT_NEAR(legs[k].thigh, 0.12, 1e-9);
    EXPECT_NEAR(legs[k].shin, 0.12, 1e-9);
    EXPECT_EQ(legs[k].weight, 0) << "three hinges do not turn a foot";
  }
  EXPECT_LT(legs[0].home[2], 0) << "elbows point back";
  EXPECT_GT(legs[2].home[2], 0) << "knees point forward";
}

TEST(Trot, ABipedHasNoFourLegs) { EXPECT_THROW((void)find_four_legs(*test::kid21()), SetupError); }

// The thigh leans by 0.5 rad and the knee is bent by 1 rad if the hip is 0.24 cos(0.5) m above the foot, straight above.
TEST(Trot, StandsWithKneesBentByOneRadian) {
  const auto legs = find_four_legs(quadruped());
  TrotParameters p = seeded_trot(quadruped(), legs);
  p.shift = {};
  p.hip_height = 0.24 * std::cos(0.5);
  const TrotPose pose = trot_pose(legs, p, 0, 0, {}, home_pose(legs));
  EXPECT_TRUE(pose.reachable);
  for (std::size_t k = 0; k < 4; ++k) {
    const double sign = k < 2 ? 1 : -1;
    EXPECT_NEAR(pose.q[k][0], 0, 1e-9);
    EXPECT_NEAR(pose.q[k][1], 0.5 * sign, 1e-9);
    EXPECT_NEAR(pose.q[k][2], -1.0 * sign, 1e-9);
  }
}

// Law: a foot that stands moves against the base as the ground does: with -(v + w x n).
TEST(Trot, StandingFeetMoveAsTheGroundDoes) {
  const auto legs = find_four_legs(quadruped());
  const TrotParameters p = seeded_trot(quadruped(), legs);
  const Vec3d velocity{0.2, 0.05, 0.3};
  const double step = 1e-3, dt = step * p.period / (2 * pi);
  const TrotPose rest = trot_pose(legs, p, 0, 0, {}, home_pose(legs));
  Vec3d middle;
  for (std::size_t k = 0; k < 4; ++k) middle += 0.25 * foot_of(legs[k], rest, k);
  law::Worst error;
  int standing = 0;
  TrotPose before = trot_pose(legs, p, 0, 1, velocity, rest);
  for (double phase = step; phase < 2 * pi; phase += step) {
    const TrotPose pose = trot_pose(legs, p, phase, 1, velocity, before);
    EXPECT_TRUE(pose.reachable);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3d now = foot_of(legs[k], pose, k), then = foot_of(legs[k], before, k);
      const double ground = foot_of(legs[k], rest, k).z;
      if (now.z > ground + 1e-9 || then.z > ground + 1e-9) continue;
      ++standing;
      const Vec3d n = foot_of(legs[k], rest, k) - middle;
      const Vec3d wanted{velocity.x - velocity.z * n.y, velocity.y + velocity.z * n.x, 0};
      error.see(norm((1 / dt) * (now - then) + wanted), "leg", k, "phase", phase);
    }
    before = pose;
  }
  EXPECT_NEAR(standing / (4 * 2 * pi / step), (1 + p.double_support) / 2, 0.02) << "share of the period";
  law::expect_below({.law = "trot: error of the velocity of standing feet",
                     .level = "trot",
                     .source = "that of the ground, seen from the moving base"},
                    error, 1e-5, "m/s");
}

TEST(Trot, DiagonalFeetSwingTogether) {
  const auto legs = find_four_legs(quadruped());
  const TrotParameters p = seeded_trot(quadruped(), legs);
  const TrotPose pose = trot_pose(legs, p, 0.5 * pi, 1, {}, home_pose(legs));
  const TrotPose rest = trot_pose(legs, p, 0, 0, {}, home_pose(legs));
  for (std::size_t k = 0; k < 4; ++k) {
    const bool swings = k == 1 || k == 2;
    EXPECT_NEAR(foot_of(legs[k], pose, k).z - foot_of(legs[k], rest, k).z, swings ? p.lift : 0, 1e-9) << k;
  }
}

}  // namespace
}  // namespace murosimf::locomotion
