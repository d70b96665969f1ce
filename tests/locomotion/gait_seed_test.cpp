// Computed numbers of a walk, against sums over the masses by hand; and numbers that a user gives instead.
#include "murosimf/locomotion/gait_seed.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/walk_options.h"
#include "murosimf/model/error.h"
#include "murosimf/model/feet.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/biped_urdf.h"
#include "tests/law.h"
#include "tests/physics/rig.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::locomotion {
namespace {

ModelPtr biped(const fixtures::Biped& biped) {
  return robot::read_robot(robot_formats::urdf::urdf_files::write("biped.urdf", fixtures::biped_urdf(biped))).model;
}

/// [m] along x, with both feet down: the center of mass and the left sole from the left ankle.
struct Lever {
  double center = 0, sole = 0;
};

Lever lever(const Model& model, const WalkParameters& p) {
  const auto& legs = legs_of(model);
  const GaitPose pose = gait_pose(legs, p, 0, 0, {});
  std::vector<double> q(static_cast<std::size_t>(model.size()));
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < legs[side].joints.size(); ++i) q[legs[side].joints[i]] = pose.q[side][i];
  }
  std::vector<Vec3d> r(q.size());
  std::vector<Mat3d> R(q.size());
  R[0] = rotation_y(p.pitch);
  multibody::poses<double>(model.tree(), q, r, R);
  Vec3d moment;
  for (const Link& link : model.tree().links) moment += link.mass * (r[link.object] + R[link.object] * link.com);
  const double ankle = r[model.object_index("l_ankle_pitch")].x;
  const Foot foot = feet_of(model)[0];
  const int link = model.tree().links[foot.place.link].object;
  return {moment.x / model.tree().mass - ankle, (r[link] + R[link] * foot.place.offset).x - ankle};
}

TEST(GaitSeed, PutsTheCenterOfMassOverTheSoles) {
  const ModelPtr model = biped({.ankle = 1000});
  const Lever at = lever(*model, seeded_parameters(*model));
  EXPECT_GT(at.sole, 0.04);
  law::expect_near({.law = "seeded walk of a humanoid with strong ankles: center of mass from the ankle",
                    .level = "gait",
                    .source = "the middle of its sole"},
                   at.center, at.sole, 1e-4, "m");
}

TEST(GaitSeed, AsksWeakAnklesForAFifthOfTheirTorque) {
  const ModelPtr model = biped({.ankle = 20});
  const Lever at = lever(*model, seeded_parameters(*model));
  law::expect_near({.law = "seeded walk of a humanoid with ankles of 20 N m: torque of one ankle that carries it all",
                    .level = "gait",
                    .source = "a fifth of what it has"},
                   at.center * model->tree().mass * 9.81, 0.2 * 20, 0.1, "N m");
}

TEST(GaitSeed, LiftsFeetByTheLegsLengthAndTheDroopOfTheHips) {
  const ModelPtr model = biped({});
  const WalkParameters p = seeded_parameters(*model);
  const double droop = model->tree().mass * 9.81 * 0.1 / (4 * 180 / 0.1);  // feet under the hips, 0.2 m apart
  EXPECT_NEAR(p.hip_roll, droop, 0.25 * droop) << "feet are a little wider apart than the hips";
  EXPECT_NEAR(p.lift, 0.045 * 0.82 + 2 * 0.1 * droop, 0.003);
}

TEST(GaitSeed, TakesWhatIsGiven) {
  const ModelPtr model = biped({});
  const OptionValues given{{"lift", 0.021}, {"period", 0.7}, {"setback", 0.01}, {"sway", 0.03}};
  const WalkParameters p = walk_parameters(*model, given);
  EXPECT_EQ(p.lift, 0.021);
  EXPECT_EQ(p.period, 0.7);
  EXPECT_EQ(p.setback, 0.01);
  EXPECT_EQ(p.sway, 0.03);
  EXPECT_THROW((void)walk_parameters(*model, {{"lift", -1.0}}), SetupError);
  EXPECT_THROW((void)walk_parameters(*model, {{"lifft", 0.1}}), SetupError);
  const OptionValues all = walk_option_values(p);
  EXPECT_EQ(all.size(), walk_options().size());
  EXPECT_EQ(std::get<double>(all.at("lean")), p.pitch);
}

// kid21's own numbers are in its TOML file, and are those of gait.h.
TEST(GaitSeed, TheFilesOwnNumbersCount) {
  const WalkParameters seeded = seeded_parameters(*test::kid21()), found;
  EXPECT_EQ(seeded.lift, found.lift);
  EXPECT_EQ(seeded.hip_roll, found.hip_roll);
  EXPECT_EQ(seeded.lead, found.lead);
  EXPECT_EQ(seeded.setback, found.setback);
}

// Behind a waist that both legs share, they bend as without it.
TEST(Leg, JointsThatBothLegsShareArePartOfNone) {
  const ModelPtr with = biped({.waist = true}), without = biped({});
  const auto &a = legs_of(*with), &b = legs_of(*without);
  ASSERT_EQ(a[0].joints.size(), 6u);
  const FootTarget target{.ankle = {0.1, 0.05, -0.7}, .sole = rotation_z(0.2)};
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<double> q_a = a[side].home, q_b = b[side].home;
    EXPECT_TRUE(bend(a[side], target, q_a));
    EXPECT_TRUE(bend(b[side], target, q_b));
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(q_a[i], q_b[i], 1e-8) << i;
  }
  EXPECT_EQ(with->objects()[a[0].joints[0]].name, "l_hip_yaw");
}

}  // namespace
}  // namespace murosimf::locomotion
