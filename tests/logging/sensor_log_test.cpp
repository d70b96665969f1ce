// Logs of a run: every sample once, under its own instant; patterns; tables that other programs read.
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "murosimf/component_files/sensor_types.h"
#include "murosimf/logging/log_catalog.h"
#include "murosimf/logging/log_csv.h"
#include "murosimf/logging/log_paths.h"
#include "murosimf/logging/run_log.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::logging {
namespace {

using namespace std::chrono_literals;
using sensors::SensorSpec;
using sensors::SignalSpec;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A robot that walks, with two sensors of different rate and delay.
struct Walk {
  Walk() : scene("walk", {.overrides = {"walker.level=simplified_dynamics", "walker.sensors=false"}}) {
    add({.name = "imu",
         .type = "imu",
         .where = "test",
         .frame = "torso",
         .rate = 200,
         .delay = 0.003,
         .signals = {{"gyroscope", SignalSpec{.noise_density = 1e-3}}}});
    add({.name = "tilt", .type = "orientation", .where = "test", .rate = 50});
  }
  void add(const SensorSpec& spec) {
    component_files::attach_sensor(simulation(), walker(), spec, {.seed = 1, .moving_entities = {&walker()}},
                                   scene.spec().rate);
  }
  Simulation& simulation() { return scene.simulation(); }
  Entity& walker() { return simulation().world().entity("walker"); }

  scene::Scene scene;
};

std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string::npos; begin = end + 1) {
      end = line.find(',', begin);
      rows.back().push_back(line.substr(begin, end - begin));
    }
  }
  return rows;
}

std::vector<std::string> names(const World& world, const std::vector<std::string>& patterns) {
  std::vector<std::string> result;
  for (const LoggedNumber& number : find_logged(world, patterns)) result.push_back(number.name());
  return result;
}

std::string refusal(const World& world, const std::string& pattern) {
  try {
    (void)find_logged(world, {pattern});
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(LogSeries, BecomeOneTableByTime) {
  const LogSeries slow{{"a [m]", "b"}, {0ns, 20ms}, {1, nan, -inf, 0.1}};
  const LogSeries fast{{"c, \"d\""}, {0ns, 10ms, 20ms, 21ms}, {1e-300, 2, 1.0 / 3, -0.0}};
  EXPECT_EQ(to_csv({&slow, &fast}),
            "time [s],a [m],b,\"c, \"\"d\"\"\"\n"
            "0,1,nan,1e-300\n"
            "0.01,,,2\n"
            "0.02,-inf,0.1,0.3333333333333333\n"
            "0.021,,,-0\n");
}

TEST(LogSeries, WithoutRowsIsAHeader) {
  const LogSeries nothing{{"a"}, {}, {}};
  EXPECT_EQ(to_csv({&nothing}), "time [s],a\n");
}

TEST(RunLog, HasEverySampleOnceUnderItsInstant) {
  Walk walk;
  RunLog log(walk.simulation(), {"walker.imu.gyroscope"});
  std::vector<std::string> expected;
  for (int step = 0; step < 100; ++step) {
    walk.simulation().step();
    const sensors::Reading& reading = *sensors::find_reading(walk.walker(), "imu");
    if (reading.samples == expected.size()) continue;
    const auto w = reading.output("gyroscope");
    expected.push_back(fmt::format("{},{},{},{}", static_cast<double>(reading.time.count()) / 1e9, w[0], w[1], w[2]));
  }
  ASSERT_EQ(expected.size(), 19U) << "5 to 95 ms at 200 Hz, the last one 3 ms later";
  const auto rows = cells_of(log.csv());
  ASSERT_EQ(rows.size(), 20U);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(fmt::format("{}", fmt::join(rows[i + 1], ",")), expected[i]);
  EXPECT_EQ(rows[19][0], "0.095");
}

TEST(RunLog, LeavesCellsEmptyBetweenSamples) {
  Walk walk;
  RunLog log(walk.simulation(), {"walker.tilt", "walker.imu.accelerometer.z"});
  walk.simulation().run(50ms);
  const auto rows = cells_of(log.csv());
  EXPECT_EQ(rows[0], (std::vector<std::string>{"time [s]", "walker.tilt.orientation.w [1]",
                                               "walker.tilt.orientation.x [1]", "walker.tilt.orientation.y [1]",
                                               "walker.tilt.orientation.z [1]", "walker.imu.accelerometer.z [m/s^2]"}));
  ASSERT_EQ(rows.size(), 11U);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    EXPECT_EQ(rows[row].size(), 6U);
    EXPECT_EQ(rows[row][1].empty(), (row - 1) % 4 != 0) << "50 of 200 Hz: row " << row;
    EXPECT_EQ(rows[row][5].empty(), row == 1) << "an accelerometer begins with a first period";
  }
}

TEST(RunLog, ChangesNothing) {
  Walk silent, watched;
  RunLog log(watched.simulation(), {"walker", "walker.torso.*"});
  silent.simulation().run(500ms);
  watched.simulation().run(500ms);
  EXPECT_EQ(silent.simulation().state_hash(), watched.simulation().state_hash());
  EXPECT_GT(log.csv().size(), 10'000U);
}

TEST(RunLog, IsTheSameAtManyThreads) {
  const auto csv = [](int threads) {
    scene::Scene scene("three_on_three", {.threads = threads, .overrides = {"*.sensors=false"}});
    Simulation& simulation = scene.simulation();
    for (const char* name : {"blue1", "red2"}) {
      Entity& robot = simulation.world().entity(name);
      component_files::attach_sensor(simulation, robot, {.name = "imu", .type = "imu", .where = "test", .rate = 100},
                                     {.moving_entities = {&robot}}, scene.spec().rate);
    }
    RunLog log(simulation, {"*.imu", "ball.ball.position"});
    simulation.run(200ms);
    return log.csv();
  };
  const std::string one = csv(1);
  EXPECT_EQ(one, csv(3));
  EXPECT_EQ(cells_of(one)[0].size(), 1 + 2 * 10 + 3U);
}

TEST(RunLog, NotesPropertiesAtItsOwnRate) {
  Walk walk;
  RunLog log(walk.simulation(), {"walker.l_foot.position.z"}, {.property_rate = 300});
  std::vector<double> height{nan};
  walk.simulation().initialize();
  for (int step = 0; step < 100; ++step) {
    height.push_back(walk.walker().object("l_foot").get(properties::position).z);
    walk.simulation().step();
  }
  const auto rows = cells_of(log.csv());
  ASSERT_EQ(rows.size(), 31U);
  for (std::size_t i = 0; i < 30; ++i) {
    const auto step =
        static_cast<std::size_t>(std::ceil(static_cast<double>(i) / 0.3 - 1e-9));  // the first one not before
    EXPECT_EQ(rows[i + 1][0], fmt::format("{}", static_cast<double>(step) / 1e3));
    EXPECT_EQ(rows[i + 1][1], fmt::format("{}", height[step + 1]));
  }
}

TEST(RunLog, LeavesOutPropertiesThatTheLevelHasNoLonger) {
  scene::Scene scene("walk", {.overrides = {"walker.level=articulated_dynamics"}});
  Simulation& simulation = scene.simulation();
  RunLog log(simulation, {"walker.j_l_shin.joint_torque", "walker.pelvis.position.x"});
  simulation.run(100ms);
  scene.exchange_level("walker", "kinematic_walking");
  simulation.run(100ms);
  const auto rows = cells_of(log.csv());
  ASSERT_EQ(rows.size(), 21U);
  EXPECT_FALSE(rows[10][1].empty());
  EXPECT_TRUE(rows[11][1].empty());
  EXPECT_FALSE(rows[20][2].empty());
}

scene_file::RobotSpec newcomer(const std::string& name) {
  return {.name = name,
          .model = "kid21",
          .where = "test",
          .level = "kinematic_walking",
          .controller = "none",
          .position = {1, 1, 0}};
}

// Who comes has columns from then on, behind those of the others of its kind; empty cells before, in every row.
TEST(RunLog, HasColumnsOfWhoComes) {
  Walk walk;
  RunLog log(walk.simulation(), {"w*.tilt.orientation.w", "*.imu.gyroscope.x", "*.pelvis.position.x"});
  walk.simulation().run(100ms);
  (void)walk.scene.add(newcomer("guest"));
  (void)walk.scene.add(newcomer("wanderer"));
  walk.simulation().run(100ms);
  const auto rows = cells_of(log.csv());
  const std::vector<std::string> names{"time [s]",
                                       "walker.tilt.orientation.w [1]",
                                       "walker.imu.gyroscope.x [rad/s]",
                                       "guest.imu.gyroscope.x [rad/s]",
                                       "wanderer.imu.gyroscope.x [rad/s]",
                                       "walker.pelvis.position.x [m]",
                                       "guest.pelvis.position.x [m]",
                                       "wanderer.pelvis.position.x [m]"};
  ASSERT_EQ(rows[0], names);
  std::size_t samples = 0, notes = 0;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    ASSERT_EQ(rows[row].size(), names.size());
    const double time = std::stod(rows[row][0]);
    EXPECT_EQ(rows[row][6].empty(), rows[row][5].empty() || time < 0.1) << "at the instants of the others: " << time;
    EXPECT_EQ(rows[row][6].empty(), rows[row][7].empty());
    EXPECT_TRUE(time >= 0.1 || rows[row][3].empty()) << time;
    samples += rows[row][3].empty() ? 0 : 1;
    notes += rows[row][6].empty() ? 0 : 1;
  }
  EXPECT_GT(samples, 5U);
  EXPECT_EQ(notes, 10U) << "from 0.10 to 0.19 s";
}

TEST(RunLog, HasOnlyColumnsOfWhoComes) {
  Walk walk;
  EXPECT_THROW(RunLog(walk.simulation(), {"guest.pelvis.position.x"}), SetupError) << "unless others may come";
  RunLog log(walk.simulation(), {"guest.pelvis.position.x"}, {.others_come = true});
  ASSERT_EQ(walk.simulation().warnings().size(), 1U);
  EXPECT_NE(walk.simulation().warnings()[0].find("'guest.pelvis.position.x': nobody is called so yet"),
            std::string::npos);
  walk.simulation().run(55ms);
  (void)walk.scene.add(newcomer("guest"));
  walk.simulation().run(50ms);
  const auto rows = cells_of(log.csv());
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[1][0], "0.06") << "at the instants that all have";
  EXPECT_EQ(rows[5][0], "0.1");
  EXPECT_NEAR(std::stod(rows[5][1]), 1, 1e-6);
}

TEST(RunLog, OfWhoComesChangesNothing) {
  const auto hash = [](bool logs) {
    Walk walk;
    std::optional<RunLog> log;
    if (logs) log.emplace(walk.simulation(), std::vector<std::string>{"*.imu", "*.pelvis.position"});
    walk.simulation().run(100ms);
    scene_file::RobotSpec robot = newcomer("guest");
    robot.level = "articulated_dynamics";
    (void)walk.scene.add(robot);
    walk.simulation().run(300ms);
    return walk.simulation().state_hash();
  };
  EXPECT_EQ(hash(false), hash(true));
}

TEST(RunLog, RefusesImpossibleRates) {
  for (const double rate : {0.0, -1.0, 2000.0, nan, inf}) {
    Walk walk;
    EXPECT_THROW(RunLog(walk.simulation(), {"walker.pelvis.position"}, {.property_rate = rate}), SetupError) << rate;
  }
}

TEST(RunReports, HaveTheLastSampleOfEverySensor) {
  Walk walk;
  walk.simulation().run(100ms);
  const scene::RunReport report = make_report(walk.scene, 1s);
  ASSERT_EQ(report.sensors.size(), 2U);
  EXPECT_EQ(report.sensors[1].reading.time, 80ms);
  EXPECT_NE(scene::to_text(report).find("2 sensors, 24 samples\n"), std::string::npos) << scene::to_text(report);
  scene::RunReport other;
  EXPECT_EQ(scene::to_text(other).find("sensor"), std::string::npos);
  auto info = std::make_shared<sensors::SensorInfo>();
  *info = {"eye", "sonar", "head", 10ms, {{"distance", "m", {}}, {"force", "N", {"x", "y"}}}};
  other.sensors.push_back({"r1", {15ms, 7, {nan, 0.5, inf}, info}});
  std::string text = scene::to_json(other);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  const std::string expected =
      R"("sensors":{"r1":{"eye":{"outputs":{"distance":{"labels":[],"unit":"m","values":[null]},)"
      R"("force":{"labels":["x","y"],"unit":"N","values":[0.5,null]}},"samples":7,"time_s":0.015,"type":"sonar"}}})";
  EXPECT_NE(text.find(expected), std::string::npos) << text;
}

TEST(LogPaths, AreEntitySensorOutputLabel) {
  Walk walk;
  const World& world = walk.simulation().world();
  EXPECT_EQ(names(world, {"walker"}).size(), 3 + 3 + 4 + 4U);
  EXPECT_EQ(names(world, {"w*.imu.*scope.y"}), std::vector<std::string>{"walker.imu.gyroscope.y [rad/s]"});
  EXPECT_EQ(names(world, {"walker.imu.*.x"}).size(), 3U);
  EXPECT_EQ(names(world, {"*.t???.orientation", "walker.tilt"}).size(), 4U) << "each once";
  EXPECT_EQ(names(world, {"walker.tilt.orientation.z", "walker.imu.gyroscope.x"}),
            (std::vector<std::string>{"walker.tilt.orientation.z [1]", "walker.imu.gyroscope.x [rad/s]"}));
}

TEST(LogPaths, AreEntityObjectProperty) {
  Walk walk;
  const World& world = walk.simulation().world();
  EXPECT_EQ(names(world, {"walker.pelvis.external_force"}),
            (std::vector<std::string>{"walker.pelvis.external_force.fx [N]", "walker.pelvis.external_force.fy [N]",
                                      "walker.pelvis.external_force.fz [N]", "walker.pelvis.external_force.nx [N m]",
                                      "walker.pelvis.external_force.ny [N m]",
                                      "walker.pelvis.external_force.nz [N m]"}));
  EXPECT_EQ(names(world, {"walker.pelvis.walk_command.z"}),
            std::vector<std::string>{"walker.pelvis.walk_command.z [rad/s]"});
  EXPECT_EQ(names(world, {"walker.head.offset.position.x"}),
            std::vector<std::string>{"walker.head.offset.position.x [m]"})
      << "names of objects may have dots";
  EXPECT_EQ(names(world, {"walker.j_l_shin.joint_velocity"}),
            std::vector<std::string>{"walker.j_l_shin.joint_velocity [rad/s]"});
}

TEST(LogPaths, TakeTeamsAsOverridesDo) {
  const scene::Scene scene("three_on_three");
  const World& world = const_cast<scene::Scene&>(scene).simulation().world();
  EXPECT_EQ(names(world, {"blue.*.pelvis.position"}).size(), 9U);
  EXPECT_EQ(names(world, {"blue.2.pelvis.position.x"}), std::vector<std::string>{"blue2.pelvis.position.x [m]"});
}

TEST(LogPaths, ThatMeanNothingSayWhatThereIs) {
  Walk walk;
  const World& world = walk.simulation().world();
  const auto expect = [&](const std::string& pattern, const std::string& part) {
    const std::string message = refusal(world, pattern);
    EXPECT_NE(message.find("--log '" + pattern + "'"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  };
  expect("wolker.imu", "unknown entity 'wolker'; did you mean 'walker'?");
  expect("walker.imo.gyroscope", "unknown sensor 'imo'; did you mean 'imu'?");
  expect("walker.imu.gyroscop", "unknown output 'gyroscop'; did you mean 'gyroscope'?");
  expect("walker.imu.gyroscope.w", "unknown label 'w'");
  expect("walker.imu.gyroscope.x.y", "nothing below 'walker.imu.gyroscope.x [rad/s]'");
  expect("walker.pelvis", "say which property");
  expect("walker.pelvis.positon", "unknown property 'positon'; did you mean 'position'?");
  expect("field", "'field' has no sensors");
  expect("field.imu.gyroscope", "'field' has no sensors; unknown object 'imu'");
  expect("walker..x", "empty part");
  expect("", "empty part");
}

TEST(Units, AreOfEachNumber) {
  EXPECT_EQ(unit_of("m/s", 2, 3), "m/s");
  EXPECT_EQ(unit_of("m/s, m/s, rad/s", 2, 3), "rad/s");
  EXPECT_EQ(unit_of("N m, N", 2, 6), "N m");
  EXPECT_EQ(unit_of("N m, N", 3, 6), "N");
  EXPECT_EQ(unit_of("rad/s | m/s", 0, 1), "rad/s");
  EXPECT_EQ(unit_of("rad/s | m/s", 0, 1, true), "m/s");
  EXPECT_EQ(unit_of("a, b", 0, 3), "a, b");
}

}  // namespace
}  // namespace murosimf::logging
