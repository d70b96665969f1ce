// The model of Unitree G1: it has the sizes that its maker publishes, stands at every level, and walks with feedback.
#include <gtest/gtest.h>

#include "murosimf/multibody/kinematics.h"
#include "tests/physics/stand.h"
#include "tests/robot_data.h"

namespace murosimf::test {
namespace {

ModelPtr g1() { return robot::read_robot(fmt::format("{}/models/unitree_g1.xml", MUROSIMF_SOURCE_DIR)).model; }

// By hand from the published masses and places; the tilt of the hip's roll joint, 0.1749 rad, is taken back at the knee.
TEST(UnitreeG1, HasTheSizesThatArePublished) {
  const ModelPtr model = g1();
  const double leg = 1.35 + 1.52 + 1.702 + 1.932 + 0.074 + 0.608;
  const double arm = 0.718 + 0.643 + 0.734 + 0.6 + 0.085445 + 0.48405 + 0.254576;
  EXPECT_NEAR(model->tree().mass, 3.814 + 2 * leg + 0.214 + 0.086 + 7.818 + 2 * arm, 1e-6);
  ASSERT_EQ(model->joints().size(), 29U);
  const std::size_t count = model->objects().size();
  std::vector<Vec3d> r(count);
  std::vector<Mat3d> R(count);
  multibody::poses<double>(model->tree(), std::vector<double>(count), r, R);
  const double x = 0.025001 - 0.078273, z = -0.12412 - 0.17734, c = std::cos(0.1749), s = std::sin(0.1749);
  const Vec3d sole = r[model->object_index("left_sole")];
  EXPECT_NEAR(sole.x, c * x - s * z + 0.035, 1e-6);
  EXPECT_NEAR(sole.y, 0.064452 + 0.052 + 0.0021489 - 0.000094, 1e-6);
  EXPECT_NEAR(sole.z, -0.1027 - 0.030465 + s * x + c * z - 0.30001 - 0.017558 - 0.035, 1e-6);
  const Vec3d right = r[model->object_index("right_sole")];
  EXPECT_NEAR(norm(right - Vec3d{sole.x, -sole.y, sole.z}), 0, 1e-12) << "mirror images";
}

TEST(UnitreeG1, WalksOnKinematicFeet) {
  const Walk result = walk_two_meters(g1());
  EXPECT_NEAR(result.moved.x, 2.2, 0.2) << "2.25 m, less the start";
  EXPECT_NEAR(result.moved.y, 0, 0.1);
}

class UnitreeG1AtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, UnitreeG1AtLevel, testing::ValuesIn(dynamic_levels()), level_name);

TEST_P(UnitreeG1AtLevel, StandsAndWalks) {
  law::expect_below({.law = "unitree_g1 stands for 10 s: way of the base after two seconds",
                     .level = GetParam(),
                     .source = "its ankles damp little"},
                    stand_still(g1(), GetParam()).moved, 15, "mm");
  const Walk result = walk({.dynamics = {.level = GetParam()}, .command = {0.1, 0, 0}, .seconds = 10, .model = g1()});
  law::expect_below({.law = "unitree_g1 walks forward with 0.1 m/s: largest lean of the torso in 10 s",
                     .level = GetParam(),
                     .source = "it does not fall"},
                    result.lean, 20, "deg");
  law::expect_between({.law = "unitree_g1 walks forward with 0.1 m/s: way in 10 s",
                       .level = GetParam(),
                       .source = "the commanded way, what feet slip and legs sway"},
                      result.moved.x, 0.7, 1.7, "m");
}

}  // namespace
}  // namespace murosimf::test
