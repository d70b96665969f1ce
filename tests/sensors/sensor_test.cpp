// Common behavior of sensors: instants of samples, delay, names, and noise that is independent of other sensors.
#include "murosimf/sensors/sensor.h"

#include <cmath>

#include "murosimf/component_files/sensor_types.h"
#include "murosimf/sensors/frame_sensors.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"
#include "tests/sensors/puppet.h"

namespace murosimf::sensors {
namespace {

/// Its place is the time.
test::BodyMotion clockwork(double t) { return {.position = {t, 0, 0}, .velocity = {1, 0, 0}}; }

using Clock = test::SensorRig<Position>;

TEST(Sensor, SamplesAtItsOwnInstants) {
  Clock clock(clockwork, {.name = "clock", .rate = 100});
  clock.run_until(0.019);
  EXPECT_EQ(clock.reading().samples, 2u);
  EXPECT_EQ(clock.reading().time, from_seconds(0.010));
  EXPECT_NEAR(clock.reading().values[0], 0.010, 1e-15);
  clock.run_until(0.020);
  EXPECT_EQ(clock.reading().time, from_seconds(0.020));
}

TEST(Sensor, ADelayedSampleKeepsTheInstantAtWhichItWasTaken) {
  Clock clock(clockwork, {.name = "clock", .rate = 100, .delay = 0.025});
  clock.run_until(0.024);
  EXPECT_EQ(clock.reading().samples, 0u) << "nothing has come yet";
  clock.run_until(0.025);
  EXPECT_EQ(clock.reading().samples, 1u);
  EXPECT_EQ(clock.reading().time, Duration{});
  clock.run_until(0.055);
  EXPECT_EQ(clock.reading().time, from_seconds(0.030));
  EXPECT_NEAR(clock.reading().values[0], 0.030, 1e-15);
  clock.run_until(0.064);
  EXPECT_EQ(clock.reading().time, from_seconds(0.030));
}

TEST(Sensor, InitializeForgetsWhatWas) {
  Clock clock(clockwork, {.name = "clock", .rate = 100, .delay = 0.025});
  clock.run_until(0.055);
  EXPECT_EQ(clock.reading().samples, 4u);
  clock.sensor.initialize();
  EXPECT_EQ(clock.reading().samples, 0u);
  EXPECT_EQ(clock.reading().time, Duration{});
  for (const double value : clock.reading().values) EXPECT_EQ(value, 0);
}

// Instant n of 30 Hz is 33.33 n ms, of which the nearest millisecond is taken; half a period later with phase 0.5.
TEST(Sensor, SamplesAreTakenAtTheNearestExecution) {
  Clock clock(clockwork, {.name = "clock", .rate = 30});
  std::vector<Duration> times;
  for (int ms = 0; ms < 134; ++ms) {
    clock.run_until(1e-3 * ms);
    if (times.empty() || clock.reading().time != times.back()) times.push_back(clock.reading().time);
  }
  using namespace std::chrono_literals;
  EXPECT_EQ(times, (std::vector<Duration>{0ms, 33ms, 67ms, 100ms, 133ms}));
  Clock shifted(clockwork, {.name = "clock", .rate = 100, .phase = 0.5});
  shifted.run_until(0.004);
  EXPECT_EQ(shifted.reading().samples, 0U);
  shifted.run_until(0.024);
  EXPECT_EQ(shifted.reading().samples, 2U);
  EXPECT_EQ(shifted.reading().time, 15ms);
}

TEST(Sensor, SamplesFitIntoItsExecutions) {
  EXPECT_EQ(fixtures::error_of([] { Clock(clockwork, {.name = "clock", .rate = 1200}); }),
            "sensor 'clock' with 1200 Hz is executed at 1000 Hz only");
  EXPECT_EQ(fixtures::error_of([] { Clock(clockwork, {.name = "clock", .rate = 250}); }), "no error");
}

// A ramp behind a first-order low-pass comes late by h / (2 tan(pi f h)), with h of the executions and not of the samples.
TEST(Sensor, ALowPassWorksInEveryExecution) {
  Clock clock(clockwork, {.name = "clock", .rate = 100, .signals = {{"", {.low_pass = 20}}}});
  clock.run_until(0.5);
  EXPECT_NEAR(clock.reading().values[0], 0.5 - 1e-3 / (2 * std::tan(pi * 20 * 1e-3)), 1e-9);
}

TEST(Sensor, IsFoundByName) {
  Clock clock(clockwork, {.name = "clock"});
  ASSERT_NE(find_reading(clock.body, "clock"), nullptr);
  EXPECT_EQ(find_reading(clock.body, "clock")->output("position").size(), 3u);
  EXPECT_EQ(find_reading(clock.body, "watch"), nullptr);
  EXPECT_EQ(fixtures::error_of([&] { (void)clock.reading().output("positon"); }),
            "sensor 'clock': unknown output 'positon'; did you mean 'position'?");
  EXPECT_EQ(readings_of(clock.body).size(), 1u);
}

/// Reads one output, as control software does.
class Reader final : public Algorithm {
 public:
  Reader(Setup& setup, const std::string& path) : numbers_(read_output(setup, path)) {}
  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void step(const Instant&) noexcept override { seen.push_back(numbers_[0]); }
  std::vector<double> seen;

 private:
  std::span<const double> numbers_;
};

TEST(Sensor, IsReadByControlSoftwareInTheSameInstant) {
  Simulation simulation;
  Entity& body = simulation.world().add("body", Clock::model());
  simulation.attach<Position>("position", body, 100, SensorSpec{.name = "clock"}, SensorSurroundings{});
  auto& reader = simulation.attach<Reader>("reader", body, 100, "clock");
  simulation.attach<test::Puppet>("puppet", body, 100, clockwork);
  simulation.run(from_seconds(0.05));
  ASSERT_EQ(reader.seen.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(reader.seen[i], 0.01 * static_cast<double>(i), 1e-15);
}

TEST(Sensor, ControlSoftwareIsToldWhatThereIsNoneOf) {
  Clock clock(clockwork, {.name = "clock"});
  const auto error = [&](const std::string& path) {
    return fixtures::error_of([&] { clock.simulation.attach<Reader>("reader", clock.body, 100, path); });
  };
  EXPECT_TRUE(fixtures::says(error("clok"), {"'body': unknown sensor 'clok'; did you mean 'clock'?"}));
  EXPECT_TRUE(fixtures::says(error("clock.speed"), {"sensor 'clock': unknown output 'speed'", "position"}));
}

/// Attaches by name to a robot that stands.
struct Standing {
  explicit Standing(int threads = 1) : rig(0.8, 0, 1000, threads) {}
  Entity& add(const std::string& name, double y) { return rig.add(name, test::kid21(), {.position = {0, y, 0}}); }
  void attach(Entity& robot, const SensorSpec& spec) {
    component_files::attach_sensor(rig.simulation, robot, spec, {.seed = 7}, rig.rate);
  }
  void move(Entity& robot) { rig.attach_motion(robot, {.level = "kinematic_walking"}); }
  test::Rig rig;
};

SensorSpec noisy_imu() {
  return {.name = "imu",
          .type = "imu",
          .rate = 200,
          .signals = {{"", {.bias = 0.1, .bias_random_walk = 1e-3, .noise_density = 1e-2, .low_pass = 40}}}};
}

TEST(Sensor, NoiseIsChangedByNobodyElse) {
  const auto hash = [](bool others, int threads) {
    Standing standing(threads);
    Entity* before = others ? &standing.add("blue0", -2) : nullptr;
    Entity& robot = standing.add("blue1", 0);
    if (before) standing.attach(*before, noisy_imu());
    if (others) standing.attach(robot, {.name = "a_gyro", .type = "gyroscope", .signals = {{"", {.noise = 1}}}});
    standing.attach(robot, noisy_imu());
    if (before) standing.move(*before);
    standing.move(robot);
    standing.rig.run(0.5);
    return hash_of(*find_reading(robot, "imu"));
  };
  EXPECT_EQ(hash(true, 1), hash(false, 1));
  EXPECT_EQ(hash(true, 2), hash(false, 1));
  EXPECT_EQ(hash(true, 3), hash(false, 1));
}

TEST(Sensor, LookingChangesNothing) {
  const auto hash = [](bool sensor) {
    Standing standing;
    Entity& robot = standing.add("blue1", 0);
    if (sensor) standing.attach(robot, noisy_imu());
    standing.move(robot);
    standing.rig.run(0.2);
    return standing.rig.simulation.state_hash();
  };
  EXPECT_EQ(hash(true), hash(false));
}

TEST(Sensor, MistakesAreNamedInOneLine) {
  const auto error = [](const SensorSpec& spec) {
    Standing standing;
    Entity& robot = standing.add("blue1", 0);
    standing.attach(robot, {.name = "twice", .type = "imu"});
    return fixtures::error_of([&] { standing.attach(robot, spec); });
  };
  EXPECT_TRUE(fixtures::says(error({.name = "a", .type = "gyroskope", .where = "x.toml:3:1"}),
                             {"x.toml:3:1: unknown sensor type 'gyroskope'; did you mean 'gyroscope'?"}));
  EXPECT_TRUE(fixtures::says(error({.name = "a", .type = "imu", .frame = "heart"}), {"a: ", "'heart'"}));
  EXPECT_EQ(error({.name = "a", .type = "imu", .rate = 2000}),
            "sensor 'a' with 2000 Hz is faster than the simulation's 1000 steps per second");
  EXPECT_EQ(error({.name = "a", .type = "imu", .rate = -1}),
            "the rate of sensor 'a' is -1 Hz; it must be 0.001 Hz or more, or 0 for every step");
  EXPECT_EQ(error({.name = "a", .type = "imu", .delay = -1}),
            "the delay of sensor 'a' is -1 s; it must be from 0 to 10");
  EXPECT_EQ(error({.name = "a", .type = "imu", .signals = {{"gyroscope", {.noise = -1}}}}),
            "a: gyroscope: 'noise' is -1; it must be in the range from 0 unit");
  EXPECT_TRUE(fixtures::says(error({.name = "a", .type = "imu", .signals = {{"gyro", {}}}}),
                             {"a: unknown output 'gyro'", "gyroscope"}));
  EXPECT_TRUE(fixtures::says(error({.name = "b", .type = "joint_position", .objects = {"j_l_shinn"}}),
                             {"b: unknown joint 'j_l_shinn'; did you mean 'j_l_shin'?"}));
  EXPECT_EQ(error({.name = "twice", .type = "gyroscope"}), "twice: 'blue1' has two sensors called 'twice'");
}

}  // namespace
}  // namespace murosimf::sensors
