// Servos that give all they have are counted, joint by joint, alone and in lanes.
#include "murosimf/dynamics/servo/saturation_watch.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/scene/scene.h"
#include "tests/dynamics/part.h"
#include "tests/written_scene.h"

namespace murosimf::dynamics {
namespace {

// Rule: shares of the time since the level began, the largest first; nothing is said of less than 1 %.
TEST(SaturationWatch, NamesTheJointsAndTheShareOfTime) {
  test::Alone<SaturationWatch> watch(
      Chain{}.base("base").revolute("hip", {0, 1, 0}).revolute("knee", {0, 1, 0}).revolute("ankle", {0, 1, 0}));
  watch.part->initialize();
  EXPECT_EQ(saturation_message(watch.entity), "");
  for (int step = 0; step < 1000; ++step) {
    watch.part->begin(1e-3);
    if (step % 4 == 0) watch.part->add(watch.index("knee"), 1e-3);
    if (step % 50 == 0) watch.part->add(watch.index("hip"), 1e-3);
    if (step < 9) watch.part->add(watch.index("ankle"), 1e-3);
  }
  EXPECT_EQ(saturation_message(watch.entity), "robot: servos give all they have: knee in 25 % of the time, hip 2 %");
  watch.part->initialize();
  EXPECT_EQ(saturation_message(watch.entity), "");
}

/// [1] share of the time in which the arm's servo is at a bound while it lifts its load to the horizontal; with its load at 0.1 m.
double share_while_lifting(const std::string& load) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto model = fixtures::temp_folder() / (std::string(test->name()) + ".xml");
  std::ofstream(model)
      << "<mujoco model='crane'><worldbody><body name='base'><freejoint/><geom type='box' size='.2 .2 .2' "
         "mass='50'/><body name='arm' pos='0 0 .5'><joint name='j' axis='0 1 0'/><geom type='sphere' "
         "size='.02' pos='.1 0 0' mass='"
      << load << "'/></body></body></worldbody></mujoco>";
  std::ofstream(std::filesystem::path(model).replace_extension(".toml"))
      << "[servos.s]\nlaw = 'ideal_pd'\nstall_torque = 2\nposition_gain = 1000\nvelocity_gain = 10\nrotor_inertia = "
         "0.001\njoints = ['j']\n";
  scene::Scene scene(fixtures::write_scene("[[robots]]\nname = 'r'\nmodel = '" + model.string() +
                                           "'\nlevel = 'articulated_dynamics'\ncontroller = 'none'\n"));
  scene.simulation().run(from_seconds(1));
  Entity& robot = scene.simulation().world().entity("r");
  EXPECT_NEAR(robot.base().get(properties::watched_time), 1, 1e-9);
  return robot.object("j").get(properties::saturated_time);
}

// A load of m g 0.1 m is held by a servo of 2 N m if it has 1 kg, and not if it has 3 kg: then it sinks, the servo at its end.
TEST(SaturationWatch, CountsAServoThatIsTooWeakAndNoOther) {
  EXPECT_LT(share_while_lifting("1"), 0.02);
  EXPECT_GT(share_while_lifting("3"), 0.95);
}

// Rule: in lanes it is the same, to the bit.
TEST(SaturationWatch, IsTheSameInLanes) {
  std::string robots;
  for (int i = 0; i < 8; ++i) {
    robots += "[[robots]]\nname = 'r" + std::to_string(i) + "'\nmodel = 'kid21'\nlevel = 'articulated_dynamics'\n" +
              "controller = 'walk'\ncommand = [0.0" + std::to_string(i) + ", 0, 0]\nsensors = false\nposition = [0, " +
              std::to_string(2 * i) + ", 0]\n";
  }
  const std::string file = fixtures::write_scene(robots);
  scene::Scene together(file), alone(file, {.lanes = false});
  for (scene::Scene* scene : {&together, &alone}) scene->simulation().run(from_seconds(2));
  EXPECT_EQ(together.simulation().state_hash(), alone.simulation().state_hash());
  Entity& robot = together.simulation().world().entity("r3");
  EXPECT_GT(robot.object("j_l_shin").get(properties::saturated_time), 0.2);
  EXPECT_TRUE(saturation_message(robot).starts_with("r3: servos give all they have: j_")) << saturation_message(robot);
}

}  // namespace
}  // namespace murosimf::dynamics
