// The robots of the 3D simulation league: what they weigh, how they stand, and how they walk with slanted hips.
#include <gtest/gtest.h>

#include "tests/physics/stand.h"
#include "tests/physics/walk.h"

namespace murosimf::test {
namespace {

ModelPtr nao(int type) {
  const std::string file = fmt::format("{}/models/spark_nao{}.xml", MUROSIMF_SOURCE_DIR, type);
  return robot::read_robot(file).model;
}

// The league's table: torso, neck and head 1.6171 kg, 0.455 kg per arm, 1.04 kg per leg; 22 joints, or 24 with toes.
TEST(SparkNao, WeighsWhatTheLeaguesTableSays) {
  for (int type = 0; type <= 4; ++type) {
    const ModelPtr model = nao(type);
    EXPECT_NEAR(model->tree().mass, 4.6071, 1e-9) << type;
    EXPECT_EQ(model->joints().size(), type == 4 ? 24U : 22U) << type;
    EXPECT_EQ(model->having(properties::sole).size(), 2U) << type;
  }
}

// Thigh and shin by hand from the table: hip to knee sqrt((T + 0.08)^2 + 0.005^2), knee to the middle between the ankle's
// axes A + 0.045 + 0.0025.
TEST(SparkNao, HasLegsOfTheTable) {
  const auto legs = locomotion::find_legs(*nao(3));
  for (const locomotion::Leg& leg : legs) {
    EXPECT_FALSE(leg.signs);
    EXPECT_NEAR(leg.thigh, std::hypot(0.067868424 + 0.08, 0.005), 1e-9);
    EXPECT_NEAR(leg.shin, 0.082868424 + 0.045, 0.003);
  }
  EXPECT_NEAR(legs[0].hip.y, 0.072954143, 1e-9);
  EXPECT_NEAR(legs[1].hip.y, -0.072954143, 1e-9);
}

class SparkNaoAtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, SparkNaoAtLevel, testing::ValuesIn(dynamic_levels()), level_name);

TEST_P(SparkNaoAtLevel, StandsAndWalksSlowly) {
  for (const int type : {0, 3}) {
    const std::string name = fmt::format("spark_nao{}", type);
    expect_still(name, GetParam(), stand_still(nao(type), GetParam()));
    const Walk result =
        walk({.dynamics = {.level = GetParam()}, .command = {0.1, 0, 0}, .seconds = 10, .model = nao(type)});
    law::expect_below({.law = name + " walks forward with 0.1 m/s: largest lean of the torso in 10 s",
                       .level = GetParam(),
                       .source = "it does not fall"},
                      result.lean, 20, "deg");
    law::expect_above({.law = name + " walks forward with 0.1 m/s: way in 10 s",
                       .level = GetParam(),
                       .source = "it gets ahead: soft servos take more than half of slow and short steps"},
                      result.moved.x, 0.4, "m");
  }
}

TEST(SparkNao, WalksTwoMetersOnKinematicFeet) {
  for (const int type : {0, 1, 2, 3, 4}) {
    const Walk result = walk_two_meters(nao(type));
    const std::string name = fmt::format("spark_nao{} walks forward with 0.15 m/s: ", type);
    const std::string level = "kinematic_walking";
    law::expect_between({.law = name + "way in 15 s", .level = level, .source = "the commanded way, less the start"},
                        result.moved.x, 2, 2.25, "m");
    law::expect_below({.law = name + "aberration on 2 m", .level = level, .source = "none"}, std::abs(result.moved.y),
                      0.1, "m");
    law::expect_below({.law = name + "slip of the standing sole",
                       .level = level,
                       .source = "it is fixed, but for what it moves while it stops: 0.02 s, and back"},
                      result.slip, 0.0025, "m");
  }
}

}  // namespace
}  // namespace murosimf::test
