// The model of Booster K1: it is the robot that its maker publishes, stands and walks.
#include <gtest/gtest.h>

#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"
#include "tests/physics/stand.h"
#include "tests/robot_data.h"

namespace murosimf::test {
namespace {

ModelPtr k1() { return robot::read_robot(fmt::format("{}/models/booster_k1.xml", MUROSIMF_SOURCE_DIR)).model; }

struct Posed {
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
  Vec3d center;  // [m] of mass
};

/// Joints [rad] in the order of the model.
Posed posed(const Model& model, const std::vector<double>& angles) {
  const std::size_t count = model.objects().size();
  std::vector<double> q(count);
  for (std::size_t i = 0; i < angles.size(); ++i) q[model.joints()[i]] = angles[i];
  Posed pose{.r = std::vector<Vec3d>(count), .R = std::vector<Mat3d>(count), .center = {}};
  multibody::poses<double>(model.tree(), q, pose.r, pose.R);
  const std::vector<Vec3d> rest(count);
  pose.center = multibody::common_body<double>(model.tree(), pose.r, pose.R, rest, rest).center;
  return pose;
}

// By hand from the published places of joints and of the foot's contact box.
TEST(BoosterK1, HasTheSizesThatArePublished) {
  const ModelPtr model = k1();
  EXPECT_NEAR(model->tree().mass, 19.666, 1e-9);
  ASSERT_EQ(model->joints().size(), 22U);
  const Posed pose = posed(*model, std::vector<double>(22));
  const Vec3d sole = pose.r[model->object_index("left_sole")];
  EXPECT_NEAR(sole.x, 0.012 - 0.014 + 0.0002 + 0.026, 1e-9);
  EXPECT_NEAR(sole.y, 0.096 + 0.0002, 1e-9);
  EXPECT_NEAR(sole.z, -(0.077 + 0.026 + 0.0485 + 0.117 + 0.2452 + 0.038), 1e-9);
  EXPECT_NEAR(pose.r[model->object_index("Right_Elbow_Yaw")].y, -(0.077 + 0.068 + 0.0444 + 0.1215), 1e-9);
}

// Rounded figures of one side for both: places differ by less than 0.1 mm, the center of mass by less than 0.5 mm.
TEST(BoosterK1, IsWhatItsMakersFileSays) {
  if (!std::filesystem::is_regular_file(k1_mjcf()))
    GTEST_SKIP() << "no " << k1_mjcf() << "; MUROSIMF_TEST_DATA names another folder";
  const ModelPtr ours = k1(), theirs = robot::read_robot(k1_mjcf()).model;
  ASSERT_EQ(theirs->joints().size(), 22U);
  std::vector<double> angles(22);
  for (std::size_t i = 0; i < 22; ++i) {
    const int own = ours->joints()[i], other = theirs->joints()[i];
    const std::string& name = ours->objects()[own].name;
    EXPECT_EQ(name, theirs->objects()[other].name);
    const Vec3d range = *theirs->find(properties::joint_range, other) - *ours->find(properties::joint_range, own);
    EXPECT_LT(norm(range), 1e-12) << name;
    EXPECT_EQ(ours->find(properties::servo, own)->stall_torque, theirs->find(properties::servo, other)->stall_torque);
    angles[i] = 0.3 * std::sin(1 + 2.0 * static_cast<double>(i));
  }
  const Posed own = posed(*ours, angles), other = posed(*theirs, angles);
  EXPECT_LT(norm(own.center - other.center), 5e-4);
  for (std::size_t i = 0; i < 22; ++i)
    EXPECT_LT(norm(own.r[ours->joints()[i]] - other.r[theirs->joints()[i]]), 1e-4) << i;
}

class BoosterK1AtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, BoosterK1AtLevel, testing::ValuesIn(dynamic_levels()), level_name);

TEST_P(BoosterK1AtLevel, StandsAndWalks) {
  expect_still("booster_k1", GetParam(), stand_still(k1(), GetParam()));
  const Walk result = walk({.dynamics = {.level = GetParam()}, .command = {0.15, 0, 0}, .seconds = 10, .model = k1()});
  law::expect_below({.law = "booster_k1 walks forward with 0.15 m/s: largest lean of the torso in 10 s",
                     .level = GetParam(),
                     .source = "it does not fall"},
                    result.lean, 20, "deg");
  law::expect_between({.law = "booster_k1 walks forward with 0.15 m/s: way in 10 s",
                       .level = GetParam(),
                       .source = "the commanded way, and what feet slip"},
                      result.moved.x, 1.1, 1.7, "m");
}

TEST(BoosterK1, WalksTwoMetersOnKinematicFeet) {
  const Walk result = walk_two_meters(k1());
  EXPECT_GT(result.moved.x, 2);
  EXPECT_LT(result.moved.x, 2.25);
  EXPECT_LT(std::abs(result.moved.y), 0.1);
}

}  // namespace
}  // namespace murosimf::test
