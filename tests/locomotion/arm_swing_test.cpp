// Arms that swing against the legs: what turns about the vertical, which arm goes where, and what a model must have.
#include "murosimf/locomotion/arm_swing.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

constexpr double speed = 0.2;  // [m/s]

ModelPtr own(const std::string& name) {
  return robot::read_robot(std::string(MUROSIMF_SOURCE_DIR) + "/models/" + name + ".xml").model;
}

WalkParameters swinging(const Model& model, double share) {
  WalkParameters p = seeded_parameters(model);
  p.arm_swing = share;
  return p;
}

/// [kg m^2/rad] about the vertical of all masses, legs swung about their hips (unit vectors of the axes to the left) as the equations say, per phase: where
/// the speed is largest, in the middle of a step.
double turning(const Model& model, const WalkParameters& p) {
  const auto& legs = legs_of(model);
  const ArmSwing arms(model, legs, p);
  const double swing = p.period * (1 + p.double_support) / 2 * speed / (2 * p.hip_height);  // [rad] of a leg
  const auto places = [&](double phase) {
    std::vector<double> q = rest_positions(model);
    write_pose(legs, gait_pose(legs, p, 0, 0, {}), q);
    arms.write(phase, 1, speed, q);
    for (const std::size_t side : {0, 1}) {
      for (const int joint : legs[side].joints) {
        const Link& link = model.tree().links[model.tree().link_of[joint]];
        if (std::abs(link.axis.y) < 0.9) continue;
        q[joint] -= (side == 0 ? 1 : -1) * link.axis.y * swing * std::cos(phase);  // forward at phase 0
        break;
      }
    }
    std::vector<Vec3d> r(q.size());
    std::vector<Mat3d> R(q.size());
    R[0] = rotation_y(p.pitch);
    multibody::poses<double>(model.tree(), q, r, R);
    std::vector<Vec3d> centers;
    for (const Link& link : model.tree().links) centers.push_back(r[link.object] + R[link.object] * link.com);
    return centers;
  };
  constexpr double step = 1e-4;
  const auto before = places(pi / 2 - step), after = places(pi / 2 + step);
  double sum = 0;
  for (std::size_t l = 0; l < before.size(); ++l) {
    const Vec3d v = (0.5 / step) * (after[l] - before[l]);
    sum += model.tree().links[l].mass * (before[l].x * v.y - before[l].y * v.x);
  }
  return sum;
}

// Differences of places of all masses; arms and legs whose axes slant a little leave some per cent.
TEST(ArmSwing, BalancesTheLegsAboutTheVertical) {
  for (const char* name : {"kid21", "booster_k1"}) {
    const ModelPtr model = own(name);
    const double still = turning(*model, swinging(*model, 0)), half = turning(*model, swinging(*model, 0.5)),
                 swings = turning(*model, swinging(*model, 1));
    EXPECT_GT(std::abs(still), 1e-4) << name;
    EXPECT_LT(std::abs(swings), 0.05 * std::abs(still)) << name;
    EXPECT_NEAR(half, 0.5 * (still + swings), 1e-6) << name;
  }
}

TEST(ArmSwing, SwingsTheArmBackWhoseLegIsAhead) {
  const Model& model = *test::kid21();
  const ArmSwing arms(model, legs_of(model), swinging(model, 1));
  std::vector<double> targets(static_cast<std::size_t>(model.size()), 9);
  arms.write(0, 1, speed, targets);
  const double left = targets[model.object_index("j_l_sh_pitch")];
  EXPECT_GT(left, 0.05) << "backward";
  EXPECT_LT(left, 0.6);
  EXPECT_EQ(targets[model.object_index("j_r_sh_pitch")], -left);
  EXPECT_EQ(targets[model.object_index("j_l_forearm")], 9) << "shoulders alone";
  arms.write(pi, 1, speed, targets);
  EXPECT_NEAR(targets[model.object_index("j_l_sh_pitch")], -left, 1e-12);
  arms.write(0, 0.5, -speed, targets);
  EXPECT_NEAR(targets[model.object_index("j_l_sh_pitch")], -0.5 * left, 1e-12);
  std::vector<double> same(targets.size(), 9);
  ArmSwing(model, legs_of(model), swinging(model, 0)).write(0, 1, speed, same);
  for (const double target : same) EXPECT_EQ(target, 9);
}

// At joint positions zero the arms of a spark_nao point ahead: what is in front of a shoulder does not turn the body.
TEST(ArmSwing, NeedsArmsThatHang) {
  const ModelPtr nao = own("spark_nao0");
  try {
    ArmSwing(*nao, legs_of(*nao), swinging(*nao, 1));
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("model 'spark_nao0' has no left arm that hangs"), std::string::npos)
        << error.what();
  }
}

TEST(ArmSwing, IsPartOfBothWalks) {
  for (const char* controller : {"walk", "motions"}) {
    scene::Scene scene("walk",
                       {.overrides = {"walker.level=full_dynamics", "walker.command=[0.2,0,0]",
                                      "walker.options.arm_swing=1", std::string("walker.controller=") + controller},
                        .cameras = false});
    Entity& robot = scene.simulation().world().entity("walker");
    double most = 0;
    for (int i = 0; i < 300; ++i) {
      scene.simulation().run(std::chrono::milliseconds(10));
      most = std::max(most, robot.object("j_l_sh_pitch").get(properties::joint_target));
    }
    EXPECT_GT(most, 0.05) << controller;
  }
}

}  // namespace
}  // namespace murosimf::locomotion
