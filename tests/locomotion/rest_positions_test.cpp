// Joints that neither walk nor motion moves are held where the robot's file says, by every controller; legs and named joints are not.
#include "murosimf/locomotion/rest_positions.h"

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_balance.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/keyframe_targets.h"
#include "murosimf/scene/scene.h"
#include "tests/physics/rig.h"

namespace murosimf::locomotion {
namespace {

using namespace std::chrono_literals;

/// kid21 whose left arm is held out by 0.5 rad; a knee's rest position is that of no walk.
Model with_arm_out() {
  const Model& kid21 = *test::kid21();
  ConstantTable constants = kid21.constants();
  constants.set(properties::rest_position, kid21.object_index("j_l_upper_arm"), 0.5);
  constants.set(properties::rest_position, kid21.object_index("j_l_shin"), 2.0);
  return kid21.with(std::move(constants));
}

TEST(RestPositions, AreZeroWhereNothingIsSaid) {
  for (const double rest : rest_positions(*test::kid21())) EXPECT_EQ(rest, 0);
}

TEST(RestPositions, HoldWhatAMotionDoesNotName) {
  const Model model = with_arm_out();
  const int arm = model.object_index("j_l_upper_arm"), knee = model.object_index("j_l_shin");
  std::vector<double> targets(static_cast<std::size_t>(model.size()), 9);
  const std::vector<double> value{0.25};
  KeyframeTargets(model, {.columns = {{{"j_head", 1}}}}).write(value, targets);
  EXPECT_EQ(targets[model.object_index("j_head")], 0.25);
  EXPECT_EQ(targets[arm], 0.5);
  EXPECT_EQ(targets[knee], 2.0);
  EXPECT_EQ(targets[model.object_index("j_r_upper_arm")], 0);
  KeyframeTargets(model, {.columns = {{{"j_l_upper_arm", -1}}}}).write(value, targets);
  EXPECT_EQ(targets[arm], -0.25) << "what is named is not added to it";
  KeyframeTargets(model, {.columns = {{{"left_foot.x", 1}}}}).write(value, targets);
  EXPECT_EQ(targets[arm], 0.5);
  EXPECT_LT(targets[knee], 1.9) << "legs follow the feet";
}

// An arm of 0.41 kg whose masses lie 5, 11.5 and so on below the shoulder: where it is held moves the center of mass outward.
TEST(RestPositions, CountWhereTheCenterOfMassIs) {
  const Model model = with_arm_out();
  const auto& legs = legs_of(model);
  const WalkParameters stance = seeded_parameters(legs);
  const double held = balance_of(model, legs, stance).center.y,
               hangs = balance_of(*test::kid21(), legs, stance).center.y;
  const double moment = (0.2 * 0.05 + 0.15 * (0.11 + 0.055)) * std::sin(0.5);  // [kg m] upper arm and forearm
  EXPECT_NEAR(held - hangs, moment / model.tree().mass, 1e-9);
}

TEST(RestPositions, AreKeptByEveryControllerOfTwoLegs) {
  for (const char* controller : {"walk", "motions", "balance"}) {
    scene::Scene scene("walk", {.overrides = {"walker.model=booster_k1", "walker.level=full_dynamics",
                                              std::string("walker.controller=") + controller},
                                .cameras = false});
    scene.simulation().run(500ms);
    Entity& robot = scene.simulation().world().entity("walker");
    const auto& targets = robot.column(properties::joint_target).values;
    EXPECT_EQ(targets[robot.model().object_index("Left_Shoulder_Roll")], -1.3) << controller;
    EXPECT_EQ(targets[robot.model().object_index("Right_Shoulder_Roll")], 1.3) << controller;
  }
}

}  // namespace
}  // namespace murosimf::locomotion
