// The model of Booster T1: it has the sizes that its maker publishes, stands and walks.
#include <gtest/gtest.h>

#include "murosimf/multibody/kinematics.h"
#include "tests/physics/stand.h"
#include "tests/robot_data.h"

namespace murosimf::test {
namespace {

ModelPtr t1() { return robot::read_robot(fmt::format("{}/models/booster_t1.xml", MUROSIMF_SOURCE_DIR)).model; }

// By hand from the published masses, places of joints and the foot's contact box.
TEST(BoosterT1, HasTheSizesThatArePublished) {
  const ModelPtr model = t1();
  const double arm = 0.53 + 0.16 + 1.02 + 0.3292, leg = 1.021 + 0.385 + 2.168 + 1.82 + 0.073 + 0.685;
  EXPECT_NEAR(model->tree().mass, 11.7 + 0.4439 + 0.631 + 2 * arm + 2.581 + 2 * leg, 1e-9);
  ASSERT_EQ(model->joints().size(), 23U);
  const std::size_t count = model->objects().size();
  std::vector<Vec3d> r(count);
  std::vector<Mat3d> R(count);
  multibody::poses<double>(model->tree(), std::vector<double>(count), r, R);
  const Vec3d sole = r[model->object_index("left_sole")];
  EXPECT_NEAR(sole.x, 0.0625 - 0.014 + 0.0101, 1e-9);
  EXPECT_NEAR(sole.y, 0.106 + 0.0002, 1e-9);
  EXPECT_NEAR(sole.z, -(0.1155 + 0.02 + 0.0819 + 0.134 + 0.28 + 0.012 + 0.0432), 1e-9);
  EXPECT_NEAR(r[model->object_index("Right_Elbow_Yaw")].y, -(0.1063 + 0.047 + 0.0605 + 0.1471), 1e-9);
}

class BoosterT1AtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, BoosterT1AtLevel, testing::ValuesIn(dynamic_levels()), level_name);

TEST_P(BoosterT1AtLevel, StandsAndWalks) {
  // On its ankles (together 700 N m/rad and 10 N m s/rad, less m g h = 170 N m/rad of its weight) 9.6 kg m^2 sway with a damping ratio of 0.07,
  // which takes 1.9 s to fall to 1/e: after two seconds it is not yet still.
  law::expect_below({.law = "booster_t1 stands for 10 s: way of the base after two seconds",
                     .level = GetParam(),
                     .source = "its ankles damp little"},
                    stand_still(t1(), GetParam()).moved, 15, "mm");
  const Walk result = walk({.dynamics = {.level = GetParam()}, .command = {0.15, 0, 0}, .seconds = 10, .model = t1()});
  law::expect_below({.law = "booster_t1 walks forward with 0.15 m/s: largest lean of the torso in 10 s",
                     .level = GetParam(),
                     .source = "it does not fall"},
                    result.lean, 20, "deg");
  law::expect_between({.law = "booster_t1 walks forward with 0.15 m/s: way in 10 s",
                       .level = GetParam(),
                       .source = "the commanded way, and what feet slip"},
                      result.moved.x, 1.1, 1.7, "m");
}

}  // namespace
}  // namespace murosimf::test
