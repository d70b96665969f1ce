// Small experiments of which it is known beforehand which level they need: each has the reason in its last column.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "murosimf/studies/compare_verdict.h"
#include "tests/written_scene.h"

namespace murosimf::studies {
namespace {

const std::string robot = "[[robots]]\nname = \"robot\"\nmodel = \"kid21\"\nlevel = \"articulated_dynamics\"\n";
const std::string still = robot + "controller = \"none\"\n";
const std::string kick = robot + "controller = \"keyframes\"\nmotion = \"kick\"\n";
const std::string arm_swing = robot + "controller = \"keyframes\"\nmotion = \"arm_swing_on_one_leg\"\n";
const std::string get_up = robot + "controller = \"keyframes\"\nmotion = \"get_up_back\"\npitch_deg = -90\n";
const std::string heavy_ball = "[ball]\nposition = [0.2, -0.056]\nmass = 0.3\nradius = 0.065\n";
const std::string ice = "[[materials]]\npair = [\"rubber\", \"carpet\"]\nfriction = 0.03\n";
const std::string sticky = "[[materials]]\npair = [\"ball\", \"carpet\"]\nrolling = 0.5\n";

std::string walk(const std::string& speed) {
  return robot + "controller = \"walk\"\ncommand = [" + speed + ", 0, 0]\n";
}

std::string push(const std::string& body, const std::string& force, const std::string& times) {
  return "[[pushes]]\non = \"robot." + body + "\"\nforce = " + force + "\n" + times + "\n";
}

struct KnownScene {
  std::string name;
  double duration;  // [s]
  std::string text;
  std::string adequate;  // kinematic, simplified, full: 1 or 0
  std::string why;
  std::vector<std::string> outcomes{};
  std::vector<std::string> overrides{};
};
void PrintTo(const KnownScene& of, std::ostream* out) { *out << of.name << ": " << of.why; }

class KnownScenes : public testing::TestWithParam<KnownScene> {};

CompareOptions experiment(const KnownScene& scene) {
  CompareOptions options;
  options.scene = fixtures::write_scene(scene.text);
  options.entity = "robot";
  options.end = scene.duration;
  options.repeat = 0;
  options.outcomes = scene.outcomes;
  options.overrides = scene.overrides;
  options.overrides.emplace_back("field.goals=false");
  return options;
}

const std::string side_push = push("torso", "[0, 60, 0]", "from = 0.5\nto = 0.65");
const std::string late_push = push("torso", "[0, 60, 0]", "from = 4.2\nto = 4.35");

const std::vector<KnownScene> scenes{
    {"Stands", 2, walk("0"), "111", "nothing happens"},
    {"WalksSlowly", 4, walk("0.05"), "111", "feet do not slip, nothing disturbs"},
    {"StepsOnTheSpot", 4, walk("0.001"), "111", "swaying is no path"},
    {"WalksUpright", 3, walk("0.15"), "111", "no level falls, wherever it goes", {"robot.falls"}},
    {"BallPasses", 3, "[ball]\nposition = [1, -1, 0]\nvelocity = [0, 2, 0]\n" + walk("0"), "111", "it is not touched"},
    {"PushedOver", 2, walk("0") + side_push, "011", "a kinematic walker feels no forces"},
    {"Nudged", 2, walk("0") + push("torso", "[10, 0, 0]", "from = 0.5\nto = 0.55"), "011", "as pushed, without a fall"},
    {"BallThrownAtIt", 2,
     "[ball]\nposition = [0.6, 0, 0.25]\nvelocity = [-3, 0, 0.8]\nradius = 0.08\nmass = 0.8\n" + walk("0"), "011",
     "a kinematic walker stands like a wall"},
    {"PulledOverIce", 2, ice + walk("0") + push("pelvis", "[6, 0, 0]", "from = 0.2\nto = 1.2"), "011",
     "limbs hardly move: it slides as one body"},
    {"Lies", 2, still + "pitch_deg = -90\n", "011", "a kinematic walker always stands"},
    {"TipsOver", 2, still + "pitch_deg = 25\n", "011", "limbs hardly move: it falls as one body"},
    {"Dropped", 1, still + "position = [0, 0, 0.3]\n", "011", "a kinematic walker does not fall down"},
    {"Floats", 2,
     "gravity = [0, 0, 0]\n" + still + "position = [0, 0, 0.5]\n" + push("torso", "[5, 0, 0]", "from = 0.2\nto = 0.3"),
     "011", "free bodies obey Newton at every level with forces"},
    {"LimbsAfloat", 3, "gravity = [0, 0, 0]\n" + arm_swing + "position = [0, 0, 0.5]\n", "001",
     "limbs turn the trunk only where each has its own inertia"},
    {"ArmSwingOnIce", 4, ice + arm_swing, "001", "as afloat: ice takes no moment"},
    {"Kick", 4, heavy_ball + kick, "000", "servos give way to a ball of 0.3 kg"},
    {"KickEndOfRobot", 4, heavy_ball + kick, "111", "the robot itself stays where it is", {"robot.end", "robot.falls"}},
    {"KickTouches", 4, heavy_ball + kick, "111", "every level touches the ball", {"ball.touched"}},
    {"KickThenFall", 5, heavy_ball + kick + late_push, "000", "the fall comes 2.7 s after the kick"},
    {"ShortPass",
     4,
     "[ball]\nposition = [0.24, -0.056]\nmass = 0.6\nradius = 0.065\n" + sticky + kick,
     "000",
     "twice as far, though 8 cm and 16 to 20 cm differ by less than a fifth of a meter",
     {"ball.way"}},
    {"GetsUp", 4, get_up, "000", "servos cannot follow the quick key frames"},
    {"WeakServos",
     3,
     walk("0.2"),
     "000",
     "no other level has servos that could be too weak",
     {},
     {"robot.servo.stall_torque=1.5"}},
    {"PushesBall", 6,
     "[ball]\nposition = [0.2, 0.04, 0]\nradius = 0.065\nmass = 0.05\nhollow = true\n"
     "[[materials]]\npair = [\"ball\", \"carpet\"]\nrolling = 1\n" +
         walk("0.1"),
     "111", "it does not roll away: the ball is where the feet are"},
};

INSTANTIATE_TEST_SUITE_P(All, KnownScenes, testing::ValuesIn(scenes),
                         [](const auto& param) { return param.param.name; });

TEST_P(KnownScenes, HaveTheirVerdict) {
  const Comparison c = compare(experiment(GetParam()));
  const Recommendation r = recommend(c, {});
  ASSERT_EQ(c.entries.size(), 4U);
  EXPECT_EQ(c.reference, 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(r.verdicts[i].adequate, GetParam().adequate[i] == '1') << c.entries[i].level << ": " << r.sentence;
  }
}

const KnownScene& scene_named(const std::string& name) { return *std::ranges::find(scenes, name, &KnownScene::name); }

// Servos of a robot that walks give all they have in half of all time: what it touches need not feel that.
TEST(KnownScenes, ServosAtTheirLimitAreARemark) {
  const Comparison c = compare(experiment(scene_named("PushesBall")));
  const Recommendation r = recommend(c, {});
  EXPECT_GT(c.entries[3].record.full_duty, 0.4);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(r.verdicts[i].diagnostics.size(), 1U);
    EXPECT_EQ(r.verdicts[i].diagnostics[0].find("has no servos; the reference's give all they have in "), 0U);
  }
}

// They show noise, and no more, at every level.
TEST(KnownScenes, SensorsOfARobotThatStandsAreRightAtEveryLevel) {
  const Recommendation r = recommend(compare(experiment(scene_named("Stands"))), {});
  for (const LevelVerdict& verdict : r.of_sensors) EXPECT_TRUE(verdict.adequate) << r.sensors;
}

// A kinematic walker does not feel the ball: nor does its accelerometer.
TEST(KnownScenes, SensorsFeelWhatTheLevelFeels) {
  const Recommendation r = recommend(compare(experiment(scene_named("BallThrownAtIt"))), {});
  EXPECT_FALSE(r.of_sensors[0].adequate);
  EXPECT_TRUE(r.of_sensors[1].adequate) << r.sensors;
  EXPECT_TRUE(r.of_sensors[2].adequate) << r.sensors;
}

}  // namespace
}  // namespace murosimf::studies
