// What a scene sets and nothing uses is warned about by name; what cannot be is refused; what acts later is no error.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene_file {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

const std::string pair_scene = R"([defaults]
model = "kid21"
sensors = false
controller = "none"
[[robots]]
name = "still"
[[robots]]
name = "real"
level = "articulated_dynamics"
position = [1.0, 0.0]
)";

struct What {
  std::vector<std::string> set = {}, at = {};
  std::string text = pair_scene;
};

/// All warnings, one per line, of a run of 20 ms.
std::string warnings_of(const What& what) {
  scene::Scene scene(fixtures::write_scene(what.text), {.overrides = what.set, .events = what.at});
  scene.simulation().run(20ms);
  return fmt::format("{}", fmt::join(make_report(scene).warnings, "\n"));
}

std::string refusal_of(const What& what) {
  return error_of([&] { (void)warnings_of(what); });
}

TEST(UnusedKeys, OfALevelAreNamed) {
  EXPECT_EQ(warnings_of({}), "");
  for (const char* key : {"contact=paper", "servo_law=ideal_pd", "roll_deg=10", "pitch_deg=10", "fixed_base=true",
                          "self_collision=true", "integrator=rk4"}) {
    const std::string name(key, std::string_view(key).find('='));
    EXPECT_TRUE(says(warnings_of({.set = {std::string("still.") + key}}),
                     {"still: kinematic_walking has no '" + name + "'; it changes nothing"}))
        << key;
  }
  EXPECT_TRUE(says(warnings_of({.set = {"still.position=[0, 0, 0.1]"}}), {"has no z of 'position'"}));
  EXPECT_EQ(warnings_of({.set = {"still.position=[0, 0, 0]", "still.roll_deg=0"}}), "");
  EXPECT_EQ(warnings_of({.set = {"real.servo_law=ideal_pd", "real.contact=paper", "real.self_collision=true"}}), "");
}

TEST(UnusedKeys, OfALaterLevelAct) {
  EXPECT_EQ(warnings_of({.set = {"still.contact=kelvin_voigt"}, .at = {"0.01:still.level=full_dynamics"}}), "");
  EXPECT_TRUE(
      says(warnings_of({.set = {"still.roll_deg=5"}, .at = {"0.01:still.level=full_dynamics"}}), {"has no 'roll_deg'"}))
      << "only the first level places the robot";
}

TEST(UnusedKeys, OfDefaultsAreNamedOnceIfTheyHelpNobody) {
  EXPECT_EQ(warnings_of({.set = {"defaults.contact=paper"}}), "") << "'real' uses it";
  const std::string said = warnings_of({.set = {"defaults.motion=kick"}});
  EXPECT_TRUE(says(said, {"defaults: no robot uses 'motion'", "controller 'none'"}));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
}

TEST(UnusedKeys, OfEventsAreNamed) {
  EXPECT_TRUE(
      says(warnings_of({.at = {"0.01:still.contact=paper"}}), {"kinematic_walking has no 'contact' at 0.010 s"}));
  EXPECT_TRUE(says(warnings_of({.at = {"0.01:still.servo_law=ideal_pd"}}), {"has no 'servo_law'"}));
  EXPECT_EQ(warnings_of({.at = {"0.01:real.servo_law=ideal_pd"}}), "");
}

TEST(UnusedKeys, OfTheStartAreNamed) {
  EXPECT_EQ(warnings_of({.set = {"start.jitter_tilt_deg=1", "start.jitter_posture_deg=1"}}), "");
  const std::string said = warnings_of({.set = {"start.jitter_tilt_deg=1", "start.jitter_posture_deg=1",
                                                "*.controller=walk", "real.level=kinematic_walking"}});
  EXPECT_TRUE(says(said, {"'jitter_tilt_deg'", "'jitter_posture_deg' changes nothing"}));
}

TEST(UnusedKeys, CommandsBeyondTheWalkSayWhatItDoes) {
  EXPECT_EQ(warnings_of({.set = {"still.controller=walk", "still.command=[0.2, 0, 0]"}}), "");
  EXPECT_TRUE(says(warnings_of({.set = {"still.controller=walk", "still.command=[0.5, 0, 0]"}}),
                   {"still: the command [0.5, 0, 0]", "more than 'walk' can do", "[0.25, 0, 0]"}));
  EXPECT_TRUE(says(warnings_of({.set = {"still.controller=walk"}, .at = {"0.01:still.command=[0, 0.3, 0]"}}),
                   {"[0, 0.1, 0]", "--at"}));
  EXPECT_TRUE(says(warnings_of({.set = {"still.command=[0.1, 0, 0]"}}), {"controller 'none' has no 'command'"}));
}

TEST(UnusedKeys, ASceneInWhichNothingMovesSaysSo) {
  EXPECT_TRUE(says(warnings_of({.text = "duration = 1\n"}), {"nothing moves in this scene"}));
  EXPECT_EQ(warnings_of({.text = "[ball]\nposition = [0, 0]\n"}), "");
  const std::string box = "[[bodies]]\nname = 'box'\nshape = 'box'\nsize = [0.1, 0.1, 0.1]\n";
  EXPECT_EQ(warnings_of({.text = box + "mass = 1\n"}), "") << "a body moves";
  EXPECT_TRUE(says(warnings_of({.text = box + "static = true\n"}), {"nothing moves in this scene"}));
}

TEST(UnusedMaterials, AreRefusedIfNobodyKnowsThem) {
  const auto with = [](const std::string& pairs) { return What{.text = pair_scene + pairs}; };
  EXPECT_EQ(warnings_of(with("[[materials]]\npair = ['rubber', 'carpet']\n")), "");
  EXPECT_TRUE(says(refusal_of(with("[[materials]]\npair = ['rubber', 'carpt']\n")),
                   {".toml:12:", "unknown material 'carpt'; did you mean 'carpet'?"}));
  EXPECT_TRUE(says(warnings_of(with("[[materials]]\npair = ['rubber', 'grass']\n")), {"nothing here is of 'grass'"}));
  EXPECT_TRUE(says(refusal_of(with("[[materials]]\npair = ['rubber', 'carpet']\n[[materials]]\npair = ['carpet', "
                                   "'rubber']\n")),
                   {".toml:14:", "is set twice, first at", ".toml:12:"}));
  EXPECT_TRUE(says(refusal_of(with("[[materials]]\npair = ['', 'carpet']\n")), {"empty name"}));
}

TEST(UnusedMaterials, APileThatNothingFeelsIsNamed) {
  EXPECT_TRUE(says(warnings_of({.set = {"field.friction_direction=[1, 0]"}}),
                   {"pile of 'carpet'", "'friction_direction' changes nothing"}));
  EXPECT_EQ(warnings_of({.set = {"field.friction_direction=[1, 0]", "field.surface=grass"}}), "");
  EXPECT_EQ(warnings_of({.set = {"field.friction_direction=[1, 0]", "materials.rolling_anisotropy=0.1"}}), "");
}

TEST(UnusedMaterials, OfARobotsOwnFileAreKnown) {
  const std::string ball = "[ball]\nmaterial = 'foam'\n[[materials]]\npair = ['foam', 'carpet']\n";
  EXPECT_EQ(warnings_of({.text = ball}), "");
}

TEST(NoContact, NamesObjectsOfTheModel) {
  EXPECT_TRUE(says(refusal_of({.set = {"real.no_contact=[['l_fot', 'r_foot']]"}}),
                   {"--set", "unknown object 'l_fot'; did you mean 'l_foot'?"}));
  EXPECT_TRUE(says(warnings_of({.set = {"real.no_contact=[['l_foot', 'r_foot']]"}}), {"without 'self_collision"}));
  EXPECT_EQ(warnings_of({.set = {"real.no_contact=[['l_foot', 'r_foot']]", "real.self_collision=true"}}), "");
}

TEST(Errors, InEmptyNamesAndNumbersAreRefused) {
  EXPECT_TRUE(says(refusal_of({.set = {"field.surface=''"}}), {"'surface' is empty"}));
  EXPECT_TRUE(says(refusal_of({.set = {"ball.material=''"}}), {"'material' is empty"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.integrator=''"}}), {"unknown integrator ''"}));
  EXPECT_TRUE(says(refusal_of({.set = {"gravity=[0, 0]"}}), {"'gravity' must be three numbers"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.position=[9007199254740993, 0, 0]"}}), {"too many digits"}));
  EXPECT_TRUE(says(refusal_of({.set = {"rate=9007199254740993"}}), {"--set 'rate=", "too many digits"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.sensors.gaze.type=gyroscope", "real.sensors.gaze.position={}"}}),
                   {"'position' is an empty table"}));
}

TEST(Seeds, AreExact) {
  const scene::Scene scene(fixtures::write_scene(pair_scene), {.overrides = {"seed=9007199254740993"}});
  EXPECT_EQ(make_report(scene).seed, 9007199254740993U);
}

TEST(PropertySettings, ThatWouldBeOverwrittenAreRefused) {
  EXPECT_TRUE(says(refusal_of({.set = {"real.pelvis.falls=-3"}}), {"'falls' is a result that odometer writes"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.j_l_shin.joint_torque=5"}}), {"that articulated_dynamics writes"}));
  EXPECT_TRUE(says(refusal_of({.at = {"0.01:real.j_l_shin.joint_torque=5"}}), {"--at", "articulated_dynamics writes"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.l_shin.position=[0, 0, 1]"}}), {"is for the base 'pelvis' only"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.pelvis.joint_target=1"}}), {"'pelvis'", "is no joint"}));
  EXPECT_EQ(warnings_of({.set = {"real.j_l_shin.joint_position=0.3", "real.pelvis.position=[0, 1, 0.5]"}}), "");
}

TEST(PropertySettings, ThatChangeNothingAreNamed) {
  const std::string push = "still.pelvis.applied_force=[0, 0, 0, 5, 0, 0]";
  EXPECT_TRUE(says(warnings_of({.set = {push}}), {"still: kinematic_walking does not use 'applied_force'", "--set"}));
  EXPECT_TRUE(says(warnings_of({.at = {"0.01:" + push}}), {"does not use 'applied_force'", "--at"}));
  EXPECT_EQ(warnings_of({.at = {"0.005:still.level=full_dynamics", "0.01:" + push}}), "");
  EXPECT_EQ(warnings_of({.set = {push}, .at = {"0.01:still.level=full_dynamics"}}), "") << "it acts later";
}

TEST(PropertySettings, OfAFixedBaseAreNamed) {
  for (const char* setting :
       {"linear_velocity=[1, 0, 0]", "angular_velocity=[1, 0, 0]", "applied_force=[0, 0, 0, 1, 0, 0]"}) {
    EXPECT_TRUE(says(warnings_of({.set = {"real.fixed_base=true", std::string("real.pelvis.") + setting}}),
                     {"real: its base is fixed; it changes nothing"}));
  }
}

TEST(PropertySettings, OfServosNeedAServoThatUsesThem) {
  EXPECT_TRUE(says(refusal_of({.set = {"real.j_l_shin.supply_voltage=-1"}}), {"must not be negative"}));
  EXPECT_TRUE(says(refusal_of({.set = {"real.j_l_shin.torque_enabled=2"}}), {"must be 0 or 1"}));
  EXPECT_TRUE(says(warnings_of({.set = {"real.servo_law=ideal_pd", "real.j_l_shin.supply_voltage=11"}}),
                   {"the law of this servo has no motor"}));
  EXPECT_TRUE(says(refusal_of({.set = {"still.j_l_shin.supply_voltage=11"}}),
                   {"'supply_voltage' is not used here", "kinematic_walking"}));
}

TEST(PropertySettings, OfTargetsThatAControllerWritesAreNamed) {
  scene::Scene scene(fixtures::write_scene(pair_scene),
                     {.overrides = {"still.controller=walk", "still.j_l_shin.joint_target=0.4",
                                    "real.j_l_shin.joint_target=0.4", "still.j_head.joint_target=0.1"}});
  scene.simulation().run(100ms);
  const auto warnings = make_report(scene).warnings;
  ASSERT_EQ(warnings.size(), 1U) << fmt::format("{}", fmt::join(warnings, "\n"));
  EXPECT_TRUE(says(warnings[0], {"still.j_l_shin.joint_target: what was set is gone", "walk_engine"}));
}

TEST(EventsToCome, AreCheckedBeforeTheRun) {
  EXPECT_TRUE(says(refusal_of({.at = {"9:real.pelvis.nosuch=1"}}), {"--at", "unknown property 'nosuch'"}));
  EXPECT_TRUE(says(refusal_of({.at = {"9:real.pelvis.applied_force=1"}}), {"takes 6 numbers, not 1"}));
  EXPECT_TRUE(says(refusal_of({.at = {"9:real.pelvis.applied_force=[0, 0, 0, inf, 0, 0]"}}), {"cannot be inf"}));
  EXPECT_TRUE(says(refusal_of({.at = {"9:ball.ball.nosuch=1"}, .text = pair_scene + "[ball]\nposition = [0, 1]\n"}),
                   {"unknown property 'nosuch'"}));
  EXPECT_EQ(warnings_of({.at = {"0.01:still.level=articulated_dynamics", "0.015:still.j_l_shin.torque_enabled=0"}}), "")
      << "a level brings it";
}

TEST(EventsToCome, ThatTheRunDoesNotReachAreNamed) {
  EXPECT_TRUE(
      says(warnings_of({.at = {"0.01:real.contact=paper", "3:real.level=full_dynamics", "5:real.contact=paper"}}),
           {"the run ended at 0.020 s: 2 of 3 events did not come, the first at 3.000 s (--at '3:real.level"}));
  EXPECT_EQ(warnings_of({.at = {"0.019:real.level=full_dynamics"}}), "") << "the last step makes it";
  EXPECT_TRUE(says(warnings_of({.at = {"0.020:real.level=full_dynamics"}}), {"1 of 1 events"}));
}

TEST(EventsOfTheReport, HaveEverySettingAndEveryEvent) {
  scene::Scene scene(fixtures::write_scene(pair_scene),
                     {.overrides = {"real.j_l_shin.joint_position=0.25"},
                      .events = {"0.01:real.pelvis.applied_force=[0, 0, 0, 5, 0, 0]",
                                 "0.01:real.level=articulated_dynamics", "0.01:real.contact=paper"}});
  scene.simulation().run(20ms);
  std::vector<std::string> texts;
  for (const Event& event : make_report(scene).events) texts.push_back(event.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"real.j_l_shin.joint_position = 0.25",
                                             "real.pelvis.applied_force = [0, 0, 0, 5, 0, 0]",
                                             "real: articulated_dynamics, as before", "real: contact paper"}));
}

}  // namespace
}  // namespace murosimf::scene_file
