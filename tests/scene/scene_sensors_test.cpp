/// scene_sensors_test - robots of a scene carry the sensors of their files, as the scene changes them.
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/sensors/reading.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;
using sensors::find_reading;
using sensors::Reading;

const std::string start = "duration = 1.0\n[defaults]\nmodel = 'kid21'\ncontroller = 'walk'\n";
const std::string two = "[[robots]]\nname = 'one'\n[[robots]]\nname = 'two'\nposition = [0, 1]\n";

Entity& robot(Scene& scene, const std::string& name) { return scene.simulation().world().entity(name); }

const Reading& reading(Scene& scene, const std::string& name, const std::string& sensor) {
  const Reading* found = sensors::find_reading(robot(scene, name), sensor);
  if (!found) throw std::out_of_range(name + " has no " + sensor);
  return *found;
}

double rate_of(const Reading& reading) { return 1 / seconds(reading.info->period); }

TEST(SceneSensors, RobotsCarryThoseOfTheirFiles) {
  Scene scene(fixtures::write_scene(start + two));
  scene.simulation().run(100ms);
  for (const char* name : {"one", "two"}) {
    for (const char* sensor : {"imu", "encoders", "left_foot", "right_foot"}) {
      EXPECT_GT(reading(scene, name, sensor).samples, 0u) << sensor;
    }
    EXPECT_NEAR(reading(scene, name, "imu").output("accelerometer")[2], 9.81, 1.5);
    EXPECT_EQ(reading(scene, name, "encoders").values.size(), 21u);
  }
}

/// Mean of what an accelerometer on the torso of a kinematic walker feels in 20 s: in its axes, and in those of the world.
std::pair<Vec3d, Vec3d> mean_felt(double rate) {
  Scene scene(fixtures::write_scene(start + "[[robots]]\nname = 'one'\ncommand = [0.2, 0, 0]\n[robots.sensors.felt]\n" +
                                    "type = 'accelerometer'\nframe = 'torso'\nrate = " + std::to_string(rate) + "\n"));
  scene.simulation().run(2s);
  const Reading& felt = reading(scene, "one", "felt");
  const ObjectAccess torso = robot(scene, "one").object("torso");
  Vec3d own, world;
  const auto count = static_cast<std::uint64_t>(20 * rate), first = felt.samples;
  for (std::uint64_t seen = first; seen < first + count;) {
    const Mat3d orientation = torso.get(properties::orientation);
    scene.simulation().step();
    if (felt.samples == seen) continue;
    seen = felt.samples;
    const Vec3d f{felt.values[0], felt.values[1], felt.values[2]};
    own += f;
    world += orientation * f;
  }
  const double share = 1 / static_cast<double>(count);
  return {share * own, share * world};
}

// Over many steps nothing is accelerated. What is left: 0.3 m/s in 20 s, and the torso turns during a sample by up to
// 0.8 rad/s times 5 ms. In its own axes, which rock with the steps, the mean is what it is, but the same at every rate.
TEST(SceneSensors, AnAccelerometerOfAKinematicWalkerShowsGravityInTheMean) {
  const Vec3d own_of_steps = mean_felt(1000).first;
  for (const double rate : {100.0, 200.0, 500.0, 1000.0}) {
    const auto [own, world] = mean_felt(rate);
    EXPECT_LT(fixtures::difference(world, {0, 0, 9.81}), 0.05) << rate << " Hz";
    EXPECT_LT(fixtures::difference(own, own_of_steps), 0.005) << rate << " Hz";
  }
}

TEST(SceneSensors, ASceneAddsChangesAndRemoves) {
  Scene scene(fixtures::write_scene(
      start +
      "[defaults.sensors.gyro]\ntype = 'gyroscope'\nrate = 250\n[[robots]]\nname = 'one'\n"
      "[robots.sensors]\nencoders = false\n[robots.sensors.imu]\nrate = 500\n[robots.sensors.gyro]\nrate = 125\n"
      "[[robots]]\nname = 'two'\nposition = [0, 1]\n[[robots]]\nname = 'blind'\nposition = [1, 0]\nsensors = false\n"));
  EXPECT_EQ(rate_of(reading(scene, "one", "imu")), 500);
  EXPECT_EQ(reading(scene, "one", "imu").info->frame, "torso") << "what the scene does not say stays";
  EXPECT_EQ(rate_of(reading(scene, "one", "gyro")), 125);
  EXPECT_FALSE(sensors::find_reading(robot(scene, "one"), "encoders"));
  EXPECT_EQ(rate_of(reading(scene, "two", "gyro")), 250);
  EXPECT_TRUE(sensors::find_reading(robot(scene, "two"), "encoders"));
  EXPECT_TRUE(sensors::readings_of(robot(scene, "blind")).empty());
}

TEST(SceneSensors, SoDoesTheCommandLine) {
  Scene scene(fixtures::write_scene(start + two),
              {.overrides = {"*.sensors.imu.rate=100", "one.sensors.left_foot=false", "two.sensors=false",
                             "one.sensors.imu.gyroscope.bias=0"}});
  EXPECT_EQ(rate_of(reading(scene, "one", "imu")), 100);
  EXPECT_FALSE(sensors::find_reading(robot(scene, "one"), "left_foot"));
  EXPECT_TRUE(sensors::find_reading(robot(scene, "one"), "right_foot"));
}

TEST(SceneSensors, DefaultsMayChangeFromTheCommandLineToo) {
  Scene scene(fixtures::write_scene(start + two), {.overrides = {"defaults.sensors.imu.rate=125"}});
  EXPECT_EQ(rate_of(reading(scene, "two", "imu")), 125);
}

TEST(SceneSensors, PartsMayStandBesideTheScene) {
  std::ofstream(fixtures::temp_folder().string() + "/" + "part_of_scene.toml") << "type = 'gyroscope'\nrate = 40\n";
  Scene scene(fixtures::write_scene(start + "[[robots]]\nname = 'one'\n[robots.sensors.x]\npart = 'part_of_scene'\n"));
  EXPECT_EQ(rate_of(reading(scene, "one", "x")), 40);
}

std::vector<double> noisy_values(Scene& scene) {
  scene.simulation().run(50ms);
  return reading(scene, "one", "imu").values;
}

TEST(SceneSensors, NoiseFollowsTheSeedAndNothingElse) {
  const auto values = [](const std::string& robots, SceneOptions options) {
    Scene scene(fixtures::write_scene(start + robots), options);
    return noisy_values(scene);
  };
  const auto alone = values("[[robots]]\nname = 'one'\n", {});
  EXPECT_EQ(values(two, {}), alone) << "another robot";
  EXPECT_EQ(values(two, {.threads = 3}), alone) << "three threads";
  EXPECT_EQ(values(two, {.overrides = {"one.sensors.more.type=gyroscope", "one.sensors.more.bias=3"}}), alone);
  EXPECT_NE(values(two, {.seed = 7}), alone);
}

TEST(SceneSensors, LookingChangesNoMotion) {
  const auto hash = [](const std::vector<std::string>& overrides) {
    Scene scene(fixtures::write_scene(start + two), {.overrides = overrides});
    scene.simulation().run(300ms);
    return make_report(scene).state_hash;
  };
  EXPECT_EQ(hash({}), hash({"*.sensors.imu=false", "*.sensors.encoders=false"}));
}

int count_lines(const Scene& scene, const std::string& part) {
  int lines = 0;
  for (const std::string& note : make_report(scene).notes) lines += note.find(part) != std::string::npos ? 1 : 0;
  return lines;
}

// Rule: all sensors with rays share one algorithm that comes in a wave before them; without such sensors there is none.
TEST(SceneSensors, SensorsWithRaysAskOneScene) {
  const std::string eyes =
      "[robots.sensors]\nscan={type='laser', rays=30}\nsound={type='sonar'}\nsight={type='detector'}\n";
  const auto robot_with = [&](const std::string& name, double y) {
    return "[[robots]]\nname = '" + name + "'\nposition = [0, " + std::to_string(y) + "]\nheading_deg = -90\n" + eyes;
  };
  const std::string text = start + robot_with("one", 0) + robot_with("two", 1.5);
  Scene scene(fixtures::write_scene(text));
  std::size_t shared = 0, wave = 0, askers = 0;
  for (const PlannedAlgorithm& one : scene.simulation().order_of_tick()) {
    if (one.name == "world_queries") {
      ++shared;
      wave = one.wave;
      EXPECT_EQ(one.entity, "world");
    }
    if (one.name == "laser" || one.name == "sonar" || one.name == "detector") {
      ++askers;
      EXPECT_GT(one.wave, wave) << one.name;
    }
  }
  EXPECT_EQ(shared, 1U);
  EXPECT_EQ(askers, 6U);
  scene.simulation().run(50ms);
  EXPECT_NEAR(reading(scene, "two", "sight").output("one")[0], 1.5, 0.02);

  Scene blind(fixtures::write_scene(start + two));
  for (const PlannedAlgorithm& one : blind.simulation().order_of_tick()) EXPECT_NE(one.name, "world_queries");
}

TEST(SceneSensors, SayWhatALevelCannotShowOncePerLevel) {
  Scene scene(fixtures::write_scene(start + "[[robots]]\nname = 'one'\nlevel = 'full_dynamics'\n"));
  EXPECT_EQ(count_lines(scene, "one: full_dynamics"), 0);
  scene.simulation().run(10ms);
  for (const char* level : {"kinematic_walking", "full_dynamics", "kinematic_walking"}) {
    scene.exchange_level("one", level);
    scene.simulation().run(10ms);
  }
  EXPECT_EQ(count_lines(scene, "one: kinematic_walking: left_foot, right_foot: there are no contact forces"), 1);
}

TEST(SceneSensors, SayOneThingOfSeveralRobotsInOneLine) {
  Scene scene(fixtures::write_scene(start + two));
  EXPECT_EQ(count_lines(scene, "one, two: kinematic_walking: left_foot, right_foot: "), 1);
  EXPECT_EQ(count_lines(scene, "kinematic_walking"), 1);
}

TEST(SceneSensors, OfARobotFileFollowLongSteps) {
  Scene scene(fixtures::write_scene("rate = 125\n" + start + two), {.overrides = {"two.sensors=false"}});
  EXPECT_NEAR(rate_of(reading(scene, "one", "imu")), 125, 1e-9);
  EXPECT_NEAR(rate_of(reading(scene, "one", "encoders")), 100, 1e-9);
  EXPECT_EQ(count_lines(scene, "one: imu: samples at 125 Hz, not 200, because steps are 8 ms long"), 1);
  EXPECT_EQ(count_lines(scene, "one: encoders"), 0) << "each in the step that begins nearest";
  scene.simulation().run(100ms);
  EXPECT_EQ(reading(scene, "one", "encoders").samples, 10u);
}

struct Error {
  const char* name;
  std::string text;  ///< behind the start of the scene
  std::vector<std::string> overrides;
  std::vector<std::string_view> parts;  ///< of the message
};

void PrintTo(const Error& error, std::ostream* stream) { *stream << error.name; }

class SceneSensorMistake : public testing::TestWithParam<Error> {};

TEST_P(SceneSensorMistake, IsOneLine) {
  const std::string file = fixtures::temp_folder().string() + "/" + "scene_sensor_mistake_" + GetParam().name + ".toml";
  std::ofstream(file) << start << GetParam().text;
  const std::string what = error_of([&] { Scene scene(file, {.overrides = GetParam().overrides}); });
  for (const std::string_view part : GetParam().parts) EXPECT_TRUE(says(what, {part}));
  EXPECT_EQ(what.find('\n'), std::string::npos);
}

std::string one(const std::string& lines) { return "[[robots]]\nname = 'one'\n" + lines; }

INSTANTIATE_TEST_SUITE_P(
    Scenes, SceneSensorMistake,
    testing::Values(
        Error{"ANumber", one("sensors = 3\n"), {}, {".toml:7:11: 'sensors' must be false (none), true"}},
        Error{
            "UnknownSensor", one("[robots.sensors]\nimo = false\n"), {}, {".toml:8:7: unknown sensor 'imo'", "'imu'"}},
        Error{"NoType",
              one("[robots.sensors.x]\nrate = 5\n"),
              {},
              {".toml:7:", "sensor 'x' needs type", "(robot 'one')"}},
        Error{"UnknownFrame",
              one("[robots.sensors.imu]\nframe = 'torsa'\n"),
              {},
              {".toml:7:", "'torso'", "(robot 'one')"}},
        Error{"RateAboveTheStepsInTheFile", one("[robots.sensors.imu]\nrate = 3000\n"), {}, {".toml:7:", "3000 Hz"}},
        Error{"RateAboveTheSteps",
              one(""),
              {"one.sensors.imu.rate=2000"},
              {"--set 'one.sensors.imu.rate=2000'", "faster than"}},
        Error{"UnknownKeyOfSet",
              one(""),
              {"one.sensors.imu.rat=5"},
              {"--set 'one.sensors.imu.rat=5'", "did you mean 'rate'?"}},
        Error{"UnknownSensorOfSet",
              one(""),
              {"one.sensors.imo.rate=5"},
              {"--set 'one.sensors.imo.rate=5'", "'imo' needs type"}},
        Error{"TooDeep", one(""), {"one.sensors.imu.a.b.c=5"}, {"--set", "write sensors.NAME.KEY"}},
        Error{"InsideNothing",
              one("sensors = false\n"),
              {"one.sensors.imu.rate=5"},
              {"--set", "'sensors' is no table there"}}),
    [](const auto& m) { return m.param.name; });

}  // namespace
}  // namespace murosimf::scene
