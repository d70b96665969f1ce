// A scene that changes while it runs: its timeline, --at, refusals, and one clear line for every error.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

const std::string game = R"(duration = 3.0
[ball]
position = [0.16, -0.03]
[[teams]]
name = "blue"
[defaults]
model = "kid21"
team = "blue"
[[robots]]
name = "blue1"
controller = "ball_chaser"
[[robots]]
name = "blue2"
controller = "walk"
level = "articulated_dynamics"
position = [-1.0, 1.0]
)";

std::vector<std::string> texts(const Scene& scene) {
  std::vector<std::string> all;
  for (const Event& event : make_report(scene).events) all.push_back(event.text);
  return all;
}

TEST(Timeline, ChangesLevelsLawsCommandsAndProperties) {
  const std::string events = R"([[events]]
time = 0.5
set = ["blue2.level = full_dynamics", "blue2.contact = kelvin_voigt"]
[[events]]
time = 0.2
set = "blue2.command = [0.1, 0, 0]"
)";
  Scene scene(fixtures::write_scene(game + events),
              {.events = {"0.5:ball.contact=paper", "0.7:blue2.pelvis.applied_force=[0,1,0,0,0,0]",
                          "0.6:blue2.servo_law=ideal_pd"}});
  Entity& robot = scene.simulation().world().entity("blue2");
  scene.simulation().run(201ms);
  EXPECT_EQ(robot.base().get(properties::walk_command).x, 0.1);
  EXPECT_EQ(robot.level, "articulated_dynamics");
  scene.simulation().run(400ms);
  EXPECT_EQ(robot.level, "full_dynamics");
  EXPECT_EQ(robot.contact, "kelvin_voigt");
  EXPECT_EQ(scene.simulation().world().entity("ball").contact, "paper");
  EXPECT_EQ(robot.base().get(properties::applied_force).f.y, 0);
  scene.simulation().run(101ms);
  EXPECT_EQ(robot.base().get(properties::applied_force).f.y, 1);
  EXPECT_EQ(texts(scene),
            (std::vector<std::string>{"blue2.pelvis.walk_command = [0.1, 0, 0]",
                                      "blue2: articulated_dynamics -> full_dynamics", "blue2: contact kelvin_voigt",
                                      "ball: contact paper", "blue2: servo law ideal_pd",
                                      "blue2.pelvis.applied_force = [0, 1, 0, 0, 0, 0]"}));
  EXPECT_EQ(make_report(scene).events[1].time, Duration(500ms));
}

TEST(Timeline, ARefusalIsAWarningAndTheOthersChange) {
  Scene scene(fixtures::write_scene(game + "[[robots]]\nname = 'blue3'\nlevel = 'simplified_dynamics'\npitch_deg = 90\n"
                                           "controller = 'none'\nposition = [1, -1]\n"),
              {.overrides = {"*.sensors=false"}, .events = {"0.1:blue*.level=kinematic_walking"}});
  scene.simulation().run(300ms);
  EXPECT_EQ(scene.simulation().world().entity("blue3").level, "simplified_dynamics");
  EXPECT_EQ(scene.simulation().world().entity("blue2").level, "kinematic_walking");
  const auto warnings = make_report(scene).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(says(warnings[0], {"at 0.100 s", "'blue3' stays at simplified_dynamics", "leans 9"}));
}

TEST(Timeline, HasRobotsPlayMotions) {
  Scene scene("kick",
              {.overrides = {"robot.controller=motions"}, .events = {"0.5:robot.play=kick_right"}, .cameras = false});
  scene.simulation().run(4s);
  EXPECT_GT(scene.simulation().world().entity("ball").base().get(properties::position).x, 1.0);
  EXPECT_TRUE(says(error_of([] {
                     const Scene wrong("kick", {.overrides = {"robot.controller=motions"},
                                                .events = {"0.5:robot.play=kick_rigt"},
                                                .cameras = false});
                   }),
                   {"--at", "unknown motion 'kick_rigt'", "'kick_right'"}));
}

TEST(Timeline, RefusesMistakesBeforeTheRun) {
  const auto error = [](const std::string& option) {
    return error_of([&] { Scene scene(fixtures::write_scene(game), {.events = {option}}); });
  };
  EXPECT_TRUE(says(error("1:blu1.level=full_dynamics"), {"--at", "unknown entity 'blu1'", "'blue1'"}));
  EXPECT_TRUE(says(error("1:blue1.level=full"), {"unknown level 'full'", "full_dynamics"}));
  EXPECT_TRUE(says(error("1:blue1.contact=stick"), {"unknown contact law 'stick'"}));
  EXPECT_TRUE(says(error("1:blue1.servo_law=dc"), {"unknown servo law 'dc'"}));
  EXPECT_TRUE(says(error("1:blue1.model=car"), {"unknown setting 'model'", "known: level, contact"}));
  EXPECT_TRUE(says(error("1:blue1"), {"write PATH=VALUE"}));
  EXPECT_TRUE(says(error("blue1.level=full_dynamics"), {"write TIME:PATH=VALUE"}));
  EXPECT_TRUE(says(error("nan:blue1.level=full_dynamics"), {"the time must be"}));
  EXPECT_TRUE(says(error("-1:blue1.level=full_dynamics"), {"the time must be"}));
  EXPECT_TRUE(says(error("1:blue1.pelvs.applied_force=[0,0,1,0,0,0]"), {"unknown object 'pelvs'", "pelvis"}));
  EXPECT_TRUE(says(error("1:blue1.command=fast"), {"must be a number"}));
  EXPECT_TRUE(says(error("1:blue1.play=kick_left"), {"'blue1' has no motion engine", "\"motions\""}));

  const auto event = [](const std::string& text) {
    return error_of([&] { Scene scene(fixtures::write_scene(game + "[[events]]\n" + text)); });
  };
  EXPECT_TRUE(says(event("set = 'blue1.level = full_dynamics'\n"), {".toml", "the time must be"}));
  EXPECT_TRUE(says(event("time = 1\n"), {".toml", "'set' of the event is missing"}));
  EXPECT_TRUE(says(event("time = 1\nset = 3\n"), {".toml:", "must be a text"}));
  EXPECT_TRUE(says(event("tme = 1\n"), {"'tme'", "time"}));
}

TEST(SceneExchange, KeepsAGameGoingWithTheBallAtTheFoot) {
  // twelve switches while the robot dribbles: no fall, no jump of robot or ball
  const std::vector<std::string> chain{"simplified_dynamics",  "full_dynamics",       "articulated_dynamics",
                                       "kinematic_walking",    "full_dynamics",       "simplified_dynamics",
                                       "articulated_dynamics", "full_dynamics",       "kinematic_walking",
                                       "articulated_dynamics", "simplified_dynamics", "kinematic_walking"};
  Scene scene(fixtures::write_scene(game));
  World& world = scene.simulation().world();
  Entity &robot = world.entity("blue1"), &ball = world.entity("ball");
  const auto place = [](Entity& entity) { return entity.base().get(properties::position); };
  scene.simulation().run(1s);
  for (const std::string& level : chain) {
    const Vec3d robot_before = place(robot), ball_before = place(ball);
    scene.exchange_level("blue1", level);
    EXPECT_LT(norm(place(robot) - robot_before), 1e-12) << level;
    scene.simulation().run(1ms);
    EXPECT_LT(norm(place(robot) - robot_before), 0.5e-3) << level;
    EXPECT_LT(norm(place(ball) - ball_before), 2e-3) << level;
    for (int i = 0; i < 20; ++i) {
      scene.simulation().run(100ms);
      EXPECT_LT(norm(ball.base().get(properties::linear_velocity)), 3.0) << level;
    }
  }
  EXPECT_EQ(robot.base().get(properties::falls), 0);
  EXPECT_FALSE(robot.frozen());
  EXPECT_GT(ball.base().get(properties::distance_walked), 0.5) << "the ball was played";
  EXPECT_EQ(make_report(scene).events.size(), chain.size());
}

TEST(SceneExchange, GivesTheSameHashForAnyNumberOfThreads) {
  const auto hash = [&](int threads) {
    Scene scene(fixtures::write_scene(game),
                {.threads = threads,
                 .events = {"0.3:blue1.level=articulated_dynamics", "0.6:blue*.level=full_dynamics",
                            "0.9:blue1.level=kinematic_walking"}});
    scene.simulation().run(1200ms);
    return scene.simulation().state_hash();
  };
  const std::uint64_t one = hash(1);
  EXPECT_EQ(hash(2), one);
  EXPECT_EQ(hash(3), one);
}

TEST(SceneExchange, TakesWhatNobodyUsesAnyMoreAway) {
  Scene scene(fixtures::write_scene(game));
  Entity& robot = scene.simulation().world().entity("blue2");
  scene.simulation().run(10ms);
  EXPECT_NE(robot.find(properties::joint_torque), nullptr);
  scene.exchange_level("blue2", "kinematic_walking");
  EXPECT_EQ(robot.find(properties::joint_torque), nullptr) << "its numbers would be old";
  EXPECT_TRUE(says(error_of([&] { (void)robot.base().get(properties::joint_torque); }), {"no attached algorithm"}));
  scene.exchange_level("blue2", "articulated_dynamics");
  EXPECT_NE(robot.find(properties::joint_torque), nullptr);
}

}  // namespace
}  // namespace murosimf::scene
