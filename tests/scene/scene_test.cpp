// Scene files: what they mean, what --set changes, and one clear line for every error.
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

const std::string small_scene = R"(duration = 2.0
seed = 3
[ball]
position = [0.5, 0.0]
[[teams]]
name = "blue"
[[teams]]
name = "red"
[defaults]
model = "kid21"
controller = "walk"
[[robots]]
name = "blue1"
team = "blue"
position = [-1.0, 0.5]
heading_deg = 90
[[robots]]
name = "blue2"
team = "blue"
level = "simplified_dynamics"
[[robots]]
name = "red1"
team = "red"
position = [1.0, 0.0]
)";

scene_file::SceneSpec spec_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return scene_file::read_scene(fixtures::write_scene(text), overrides);
}

/// The message of the SetupError that reading and building the scene throws; empty if it throws none.
std::string error(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    Scene scene(fixtures::write_scene(text), {.overrides = overrides});
    scene.simulation().initialize();
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

void expect_mistake(const std::string& message, const std::vector<std::string>& parts) {
  EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = small_scene;
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(SceneSpec, ReadsWhatTheFileSays) {
  const scene_file::SceneSpec spec = spec_of(small_scene);
  EXPECT_EQ(spec.duration, 2);
  EXPECT_EQ(spec.seed, 3u);
  ASSERT_TRUE(spec.ball);
  EXPECT_EQ(spec.ball->position.x, 0.5);
  ASSERT_EQ(spec.robots.size(), 3u);
  EXPECT_EQ(spec.robots[0].model, "kid21");
  EXPECT_EQ(spec.robots[0].level, "kinematic_walking");
  EXPECT_NEAR(spec.robots[0].heading, pi / 2, 1e-12);
  EXPECT_EQ(spec.robots[1].level, "simplified_dynamics");
  EXPECT_EQ(spec.teams[0].attacks, 1);
  EXPECT_EQ(spec.teams[1].attacks, -1);
}

TEST(SceneSpec, OverridesReachTheirTargets) {
  const scene_file::SceneSpec spec =
      spec_of(small_scene,
              {"duration=5", "blue.*.level=simplified_dynamics", "red1.contact=paper", "field.surface=grass",
               "blue2.position=[0.1, 0.2]", "ball.mass=0.3", "blue.1.heading_deg=0"});
  EXPECT_EQ(spec.duration, 5);
  EXPECT_EQ(spec.robots[0].level, "simplified_dynamics");
  EXPECT_EQ(spec.robots[0].heading, 0);
  EXPECT_EQ(spec.robots[1].level, "simplified_dynamics");
  EXPECT_EQ(spec.robots[1].position.y, 0.2);
  EXPECT_EQ(spec.robots[2].level, "kinematic_walking");
  EXPECT_EQ(spec.robots[2].contact, "paper");
  EXPECT_EQ(spec.ball->mass, 0.3);
  EXPECT_EQ(spec.field.surface, "grass");
}

TEST(SceneSpec, TheGroundMayLean) {
  const scene_file::SceneSpec spec = spec_of(small_scene + R"([field]
surface = "grass"
friction_direction = [0.0, -1.0]
[[materials]]
pair = ["rubber", "grass"]
friction = 0.6
friction_anisotropy = 0.25
)");
  EXPECT_EQ(spec.field.friction_direction.x, 0);
  EXPECT_EQ(spec.field.friction_direction.y, -1);
  EXPECT_EQ(spec.materials.find({.material = "rubber"}, {.material = "grass"}).friction_anisotropy, 0.25);
  EXPECT_EQ(spec_of(small_scene, {"field.friction_direction=[1, 0]"}).field.friction_direction.x, 1);
}

TEST(Scene, OverridesSetPropertiesByName) {
  Scene scene(fixtures::write_scene(small_scene),
              {.overrides = {"blue2.pelvis.applied_force=[1,2,3,0,0,0]", "*.pelvis.walk_command=[0.1,0,0]"}});
  scene.simulation().initialize();
  World& world = scene.simulation().world();
  EXPECT_EQ(world.entity("blue2").base().get(properties::applied_force).f.z, 3);
  EXPECT_EQ(world.entity("red1").base().get(properties::walk_command).x, 0.1);
}

TEST(Scene, EqualRobotsShareOneModel) {
  Scene scene(fixtures::write_scene(small_scene));
  const World& world = scene.simulation().world();
  EXPECT_EQ(world.entity("blue1").model_ptr(), world.entity("red1").model_ptr());
}

TEST(Scene, EveryValueIsReachableFromSimulationToProperty) {
  Scene scene(fixtures::write_scene(small_scene));
  scene.simulation().run(from_seconds(0.1));
  Entity& robot = scene.simulation().world().entity("blue1");
  EXPECT_EQ(robot.object("l_shin").get("joint_velocity").unit, "rad/s | m/s");
  EXPECT_EQ(robot.object("l_shin").get("mass").numbers, (std::vector<double>{0.18}));
  EXPECT_EQ(robot.object("head").get("position").numbers.size(), 3u);
}

TEST(Scene, ReportNamesEverybodyAndEveryAlgorithm) {
  Scene scene(fixtures::write_scene(small_scene));
  scene.simulation().run(from_seconds(0.5));
  const RunReport report = make_report(scene, from_seconds(0.25));
  ASSERT_EQ(report.entities.size(), 4u);
  EXPECT_EQ(report.entities[0].name, "ball");
  EXPECT_DOUBLE_EQ(report.real_time_factor, 2);
  const std::string json = to_json(report);
  for (const char* key :
       {"simulated_s", "wall_s", "real_time_factor", "threads", "state_hash", "entities", "distance_m", "falls",
        "frozen", "algorithms", "rate_hz", "calls", "us_per_call", "warnings"}) {
    EXPECT_NE(json.find("\"" + std::string(key) + "\""), std::string::npos) << key;
  }
}

TEST(SceneMistakes, AreNamedWithTheirPlace) {
  expect_mistake(error(""), {"the file is empty"});
  expect_mistake(error("duration = \n"), {".toml:1:"});
  expect_mistake(error(with("level = \"simplified_dynamics\"", "level = \"simplified\"")),
                 {".toml:20:9", "unknown level 'simplified'; did you mean 'simplified_dynamics'?"});
  expect_mistake(error(with("controller = \"walk\"", "controler = \"walk\"")),
                 {".toml:11:", "unknown key 'controler'; did you mean 'controller'?"});
  expect_mistake(error(with("model = \"kid21\"", "model = \"kid22\"")), {".toml:", "no file 'kid22'"});
  expect_mistake(error(with("name = \"red1\"", "name = \"blue1\"")), {".toml:22:", "two entities are called 'blue1'"});
  expect_mistake(error(with("name = \"red1\"", "name = \"ball\"")), {"two entities are called 'ball'"});
  expect_mistake(error(with("name = \"red1\"", "name = \"red 1\"")), {"entity name 'red 1'"});
  expect_mistake(error(with("team = \"red\"", "team = \"rad\"")), {".toml:23:", "unknown team 'rad'"});
  expect_mistake(error(with("position = [1.0, 0.0]", "position = [nan, 0.0]")),
                 {".toml:24:", "'position' must be finite"});
  expect_mistake(error(with("position = [1.0, 0.0]", "position = [1.0]")), {"two or three numbers"});
  expect_mistake(error(with("duration = 2.0", "duration = -2.0")), {".toml:1:", "'duration' must not be negative"});
  expect_mistake(error(with("duration = 2.0", "duration = nan")), {".toml:1:", "'duration' must be a finite number"});
  expect_mistake(error(with("duration = 2.0", "duration = \"long\"")), {"'duration' must be a finite number"});
  expect_mistake(error(with("seed = 3", "rate = 0")), {"'rate' must be from 0.001 to 100000 Hz"});
  expect_mistake(error(with("name = \"red\"", "name = \"blue\"")), {".toml:8:", "two teams"});
  expect_mistake(error(with("[ball]\n", "[ball]\nradius = -1\n")), {"'radius' must be positive"});
}

TEST(SceneMistakes, ThatOnlyWeakenAResultAreWarnings) {
  const auto warned = [](std::vector<std::string> overrides, const std::string& text) {
    overrides.emplace_back("*.sensors=false");  // they have warnings of their own
    Scene scene(fixtures::write_scene(small_scene), {.overrides = overrides});
    const auto warnings = make_report(scene).warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
  };
  EXPECT_FALSE(warned({}, "blue2"));
  EXPECT_TRUE(warned({"blue2.fixed_base=true"}, "blue2: simplified_dynamics has no 'fixed_base'; it changes nothing"));
  EXPECT_TRUE(warned({"red1.integrator=rk4"}, "red1: kinematic_walking has no 'integrator'"));
  EXPECT_FALSE(warned({"blue2.base_rigid=true"}, "blue2"));
  EXPECT_FALSE(warned({"blue2.contact=paper", "rate=100"}, "blue2"));
  EXPECT_TRUE(warned({"blue2.contact=paper", "blue2.contact_options.bounded=false", "rate=100"},
                     "blue2: paper under simplified_dynamics is stable with steps up "
                     "to 2 ms; these are 10 ms long"));
  EXPECT_FALSE(warned({"rate=100"}, "blue2"));
  EXPECT_FALSE(warned({"rate=100"}, "ball: "));
  EXPECT_TRUE(
      warned({"ball.contact=kelvin_voigt", "rate=100"},
             "ball: kelvin_voigt under simplified_dynamics is stable with steps up to 2 ms; these are 10 ms long"));
}

// Gaits and motions for the earth: with other gravity there should be a warning. At kinematic_walking, and where the controller asks how large
// it is, nothing has to be said.
TEST(SceneMistakes, MotionsMadeForTheEarthAreNotedElsewhere) {
  const auto notes = [](const std::vector<std::string>& overrides) {
    std::string all;
    const Scene scene(fixtures::write_scene(small_scene), {.overrides = overrides});
    for (const std::string& note : make_report(scene).notes) {
      if (note.find("was made for gravity") != std::string::npos) all += note + "\n";
    }
    return all;
  };
  const std::string moon = "gravity=[0,0,-1.62]", red = "red1.level=full_dynamics";
  EXPECT_EQ(notes({moon, red}),
            "blue2, red1: controller 'walk' was made for gravity of 9.81 m/s^2; with 1.62 a robot may end otherwise\n");
  EXPECT_EQ(notes({moon, "*.controller=balance", red}), "");
  EXPECT_EQ(notes({"gravity=[0.5,0,-9.7]", red}), "");
  EXPECT_NE(notes({moon, "blue2.controller=keyframes", "blue2.motion=kick"}).find("blue2: motion 'kick' was made"),
            std::string::npos);
}

TEST(SceneMistakes, InOverridesNameTheOverride) {
  const auto set = [](const std::string& text) { return error(small_scene, {text}); };
  expect_mistake(set("blue1.level=full"), {"--set 'blue1.level=full'", "unknown level 'full'"});
  expect_mistake(set("blue1.lvel=x"), {"--set 'blue1.lvel=x'", "did you mean 'level'?"});
  expect_mistake(set("blu1.level=x"), {"--set 'blu1.level=x'", "did you mean 'blue1'?"});
  expect_mistake(set("duraton=3"), {"did you mean 'duration'?"});
  expect_mistake(set("blue1.pelvis.joint_positon=1"),
                 {"entity 'blue1', object 'pelvis'", "did you mean 'joint_position'?"});
  expect_mistake(set("blue1.pelvs.joint_position=1"), {"unknown object 'pelvs'; did you mean 'pelvis'?"});
  expect_mistake(set("blue1.pelvis.walk_command=[1]"), {"'walk_command' takes 3 numbers, not 1"});
  expect_mistake(set("blue1.pelvis.walk_command=[nan,0,0]"), {"cannot be nan"});
  expect_mistake(set("blue1.l_shin.mass=0"), {"it must be above 0"});
  expect_mistake(set("ball.radus=1"), {"--set 'ball.radus=1'", "did you mean 'radius'?"});
  expect_mistake(set("field.friction_direction=[0, 0, 1]"),
                 {"--set 'field.friction_direction=[0, 0, 1]'", "'friction_direction' lies in the ground"});
  expect_mistake(set("red1.contact=paper_multi"), {"unknown contact law 'paper_multi'", "'paper_multipoint'"});
  expect_mistake(set("field.surface=gras"), {"unknown material 'gras'; did you mean 'grass'?"});
  expect_mistake(set("blue1.controller=ball_chser"), {"did you mean 'ball_chaser'?"});
  expect_mistake(set("blue2.integrator=rk"), {"--set 'blue2.integrator=rk'", "did you mean 'rk4'?"});
  expect_mistake(set("body_contact=carr"), {"--set 'body_contact=carr'", "did you mean 'carry'?"});
  expect_mistake(set("red1.heading_deg=1e300"), {"--set 'red1.heading_deg=1e300'", "from -3600 to 3600"});
  expect_mistake(set("red1.position=[1e9,0]"), {"'position' is more than 10000 m"});
  expect_mistake(set("start.jitter_heading_deg=1e300"), {"must be from 0 to 360"});
  expect_mistake(set("blue1.fork_1.position=[0,0,0]"), {"object 'fork_1'", "cannot be set", "follows 'pelvis'"});
  expect_mistake(set("level"), {"write PATH=VALUE"});
  expect_mistake(set("blue1..level=x"), {"empty part"});
}

}  // namespace
}  // namespace murosimf::scene
