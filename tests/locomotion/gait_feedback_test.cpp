// Numbers of a walk with feedback: scaled by the legs' length, replaced by name, and each of them has an effect.
#include "murosimf/locomotion/gait_feedback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

TEST(GaitFeedback, OfKid21IsAsItStands) {
  const GaitFeedback numbers = gait_feedback(*test::kid21(), {});
  EXPECT_DOUBLE_EQ(numbers.ankle_forward, GaitFeedback{}.ankle_forward);
  EXPECT_DOUBLE_EQ(numbers.omega, GaitFeedback{}.omega);
  EXPECT_DOUBLE_EQ(numbers.most_deviation, 0.3);
  EXPECT_DOUBLE_EQ(numbers.still_rate, 0.05);
  EXPECT_NEAR(numbers.compliant_lag, 0.03, 1e-7) << "droop " << fmt::format("{:.10g}", hip_droop(*test::kid21()));
}

TEST(GaitFeedback, OfALongerRobotIsScaled) {
  const ModelPtr nao = scene::Scene("walk", {.overrides = {"walker.model=spark_nao0"}, .cameras = false})
                           .simulation()
                           .world()
                           .entity("walker")
                           .model_ptr();
  const Leg& leg = legs_of(*nao)[0];
  const double scale = (leg.thigh + leg.shin) / 0.24;
  const GaitFeedback numbers = gait_feedback(*nao, {}), kid21;
  EXPECT_NEAR(numbers.most_forward, scale * kid21.most_forward, 1e-12) << "a length";
  EXPECT_NEAR(numbers.step_decay, std::sqrt(scale) * kid21.step_decay, 1e-12) << "a time";
  EXPECT_NEAR(numbers.omega, kid21.omega / std::sqrt(scale), 1e-12) << "a rate";
  EXPECT_NEAR(numbers.ankle_forward, kid21.ankle_forward / scale, 1e-12) << "an angle over a length";
  EXPECT_NEAR(numbers.ankle_pitch, kid21.ankle_pitch, 1e-15) << "a ratio";
  EXPECT_NEAR(numbers.most_deviation, scale * kid21.most_deviation, 1e-12) << "a length";
  EXPECT_NEAR(numbers.still_rate, kid21.still_rate / std::sqrt(scale), 1e-12) << "a rate";
  EXPECT_EQ(numbers.compliant_lag, 0.043) << "its file says so";
  const ModelPtr g1 = robot::read_robot(files::find_data_file("unitree_g1", "models", ".xml"), {}).model;
  EXPECT_NEAR(gait_feedback(*g1, {}).compliant_lag / kid21.compliant_lag, hip_droop(*g1) / hip_droop(*test::kid21()),
              1e-6);
}

TEST(GaitFeedback, TakesNumbersByName) {
  const ModelPtr model = test::kid21();
  EXPECT_EQ(gait_feedback(*model, {{"dead_zone", 0.01}}).dead_zone, 0.01);
  EXPECT_EQ(balanced_walk(*model, {{"period", 0.5}}).period, 0.5);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] {
                               (void)gait_feedback(*model, {{"dead_zone", -1.0}});
                             }),
                             {"dead_zone"}));
}

/// kid21 is pushed while it stands, and again while it walks.
std::uint64_t hash_with(const std::string& level, const std::string& option) {
  std::vector<std::string> overrides{"walker.controller=motions", "walker.level=" + level};
  if (!option.empty()) overrides.push_back("walker.options." + option);
  scene::Scene scene("walk", {.overrides = overrides,
                              .events = {"0:walker.command=[0,0,0]", "3:walker.command=[0.2,0.05,0.2]"},
                              .pushes = {"walker.torso=[20,15,0]@1..1.1", "walker.torso=[-15,-15,0]@5..5.1"},
                              .cameras = false});
  scene.simulation().run(std::chrono::seconds(6));
  return scene.simulation().state_hash();
}

TEST(GaitFeedback, EveryNumberActs) {
  const std::string rigid = "full_dynamics", soft = "articulated_dynamics";
  const std::map<std::string, std::uint64_t> plain{{rigid, hash_with(rigid, "")}, {soft, hash_with(soft, "")}};
  const GaitFeedback usual;
  for (const OptionInfo& option : feedback_options()) {
    const double other = option.name == "quickest" ? 1.01 : option.name == "slowest" ? 0.99 : 0.5;
    GaitFeedback changed = gait_feedback(*test::kid21(), {{option.name, other}});
    ASSERT_NE(std::memcmp(&changed, &usual, sizeof(usual)), 0) << option.name;
    double value = std::max(option.lowest.value, std::min(option.highest, other));
    if (option.unit == "m") value = 0.002;
    // A slope is followed where servos yield.
    const std::string& level = option.name == "slope" ? soft : rigid;
    EXPECT_NE(hash_with(level, fmt::format("{}={}", option.name, value)), plain.at(level)) << option.name;
  }
}

/// [m] (along, across) of a walk to a side, its command 0.1 m/s for 5 s; `along` is negative if it went to the other side.
Vec3d walked(const std::string& model, const std::string& level, double side) {
  scene::Scene scene("walk",
                     {.overrides = {"walker.model=" + model, "walker.controller=motions", "walker.level=" + level,
                                    "walker.position=[0,0]", fmt::format("walker.command=[0,{},0]", 0.1 * side)},
                      .cameras = false});
  scene.simulation().run(std::chrono::seconds(5));
  Entity& robot = scene.simulation().world().entity("walker");
  EXPECT_EQ(robot.base().get(properties::motion_state).falls, 0) << model << " at " << level;
  const Vec3d came = robot.base().get(properties::position);
  return {side * came.y, came.x, 0};
}

TEST(GaitFeedback, RobotsGoToTheSideThatTheyAreTold) {
  // [m] of 0.5 m; walks of G1 to a side begin slowly, those of T1 differ (docs/motions.md).
  const std::map<std::string, double> least{
      {"kid21", 0.35}, {"spark_nao0", 0.35}, {"booster_k1", 0.35}, {"booster_t1", 0.25}, {"unitree_g1", 0.28}};
  for (const char* level : {"simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
    for (const auto& [model, way] : least) {
      for (const double side : {1.0, -1.0})
        EXPECT_GT(walked(model, level, side).x, way) << model << " at " << level << ", to " << side;
    }
  }
}

TEST(GaitFeedback, ABoosterT1WhoseHipsYieldWalksForward) {
  scene::Scene scene("walk", {.overrides = {"walker.model=booster_t1", "walker.controller=motions",
                                            "walker.level=articulated_dynamics", "walker.position=[0,0]",
                                            "walker.command=[0.2,0,0]"},
                              .cameras = false});
  scene.simulation().run(std::chrono::seconds(10));
  const Vec3d came = scene.simulation().world().entity("walker").base().get(properties::position);
  EXPECT_NEAR(came.x, 2.0, 0.4);
  EXPECT_NEAR(came.y, 0.0, 0.3);
}

TEST(GaitFeedback, WithTrimAG1DoesNotComeForwardOnItsWayToASide) {
  for (const double side : {1.0, -1.0})  // [m] in 5 s: 0.35 to 0.4 without
    EXPECT_LT(std::abs(walked("unitree_g1", "articulated_dynamics", side).y), 0.15) << side;
}

/// Its servos yield, and without the trim it comes forward whatever it is told.
TEST(GaitFeedback, TrimMakesUpForADrift) {
  const auto forward = [](double trim) {
    scene::Scene scene("walk", {.overrides = {"walker.model=booster_k1", "walker.controller=motions",
                                              "walker.level=articulated_dynamics", "walker.position=[0,0]",
                                              "walker.command=[-0.1,0,0]", fmt::format("walker.options.trim={}", trim)},
                                .cameras = false});
    scene.simulation().run(std::chrono::seconds(8));
    return scene.simulation().world().entity("walker").base().get(properties::position).x;
  };
  EXPECT_LT(forward(1), -0.55);
  EXPECT_GT(forward(0), -0.3);
}

}  // namespace
}  // namespace murosimf::locomotion
