// What inertial sensors show: sizes in closed form, and what the recorder sees of a robot.
#include "murosimf/studies/compare_sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "murosimf/scene/scene.h"
#include "tests/written_scene.h"

namespace murosimf::studies {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// Two seconds in which the force swings by `force` [m/s^2] and the rate is `rate` [rad/s].
InertialRecord swing(const std::string& name, double force, double rate) {
  InertialRecord record{name, true, true, {}};
  for (int i = 0; i < 10; ++i) record.samples.push_back({0.01 * i - 0.1, 100, 100});  // it settles
  for (int i = 0; i < 200; ++i) record.samples.push_back({0.01 * i, force * std::sin(2 * pi * 0.01 * i), rate});
  return record;
}

TEST(CompareSensors, MeasuresAreThoseOfASine) {
  const InertialMeasures m = measures_of(swing("imu", 3, 2), forever);
  EXPECT_NEAR(m.force_rms, 3 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(m.force_peak, 3, 1e-12);
  EXPECT_NEAR(m.rate_rms, 2, 1e-12);
  EXPECT_NEAR(measures_of(swing("imu", 3, 2), 0.1 + 1e-9).force_peak, 3 * std::sin(0.2 * pi), 1e-9)
      << "only until then";
  EXPECT_EQ(measures_of(InertialRecord{}, forever).force_rms, 0);
}

TEST(CompareSensors, DeviationsAreSharesOfTheReference) {
  Deviations d;
  compare_sensors({swing("chest", 3, 2), swing("head", 3, 5)}, {swing("chest", 2, 2), swing("head", 3, 4)}, forever, d);
  EXPECT_NEAR(d.accelerometer.value, 0.5, 1e-9);
  EXPECT_NEAR(d.accelerometer_peak.value, 0.5, 1e-9);
  EXPECT_EQ(d.accelerometer.name, "chest");
  EXPECT_NEAR(d.gyroscope.value, 0.25, 1e-9);
  EXPECT_EQ(d.gyroscope.name, "head");
  Deviations still;
  compare_sensors({swing("imu", 0.1, 0.01)}, {swing("imu", 0, 0)}, forever, still);
  EXPECT_NEAR(still.accelerometer_peak.value, 0.1 / least_force, 1e-9) << "noise";
  EXPECT_NEAR(still.gyroscope.value, 0.01 / least_sensor_rate, 1e-9);
  InertialRecord blind = swing("imu", 3, 2);
  blind.accelerometer = false;
  Deviations half;
  compare_sensors({blind}, {blind}, forever, half);
  EXPECT_EQ(half.accelerometer.name, "");
}

// A robot falls from 1 m: in free fall an accelerometer shows nothing.
TEST(InertialRecorder, TakesEverySampleAndChangesNothing) {
  const std::string file = fixtures::write_scene(R"(
[[robots]]
name = "r"
model = "kid21"
level = "simplified_dynamics"
controller = "none"
position = [0, 0, 1]
)");
  scene::Scene scene(file), unobserved(file);
  Simulation& simulation = scene.simulation();
  const auto& recorder = simulation.attach<InertialRecorder>("inertial", simulation.world().entity("r"), 1000, 0.4);
  simulation.run(from_seconds(0.4));
  unobserved.simulation().run(from_seconds(0.4));
  EXPECT_EQ(simulation.state_hash(), unobserved.simulation().state_hash());
  ASSERT_EQ(recorder.records().size(), 1U) << "encoders and cells of the feet are none";
  const InertialRecord& imu = recorder.records()[0];
  EXPECT_EQ(imu.name, "imu");
  EXPECT_TRUE(imu.accelerometer && imu.gyroscope);
  EXPECT_NEAR(static_cast<double>(imu.samples.size()), 80, 2) << "200 a second";
  for (std::size_t i = 1; i < imu.samples.size(); ++i) EXPECT_GT(imu.samples[i].time, imu.samples[i - 1].time);
  EXPECT_NEAR(imu.samples[60].force, -9.81, 0.5) << "free fall, with noise";
}

}  // namespace
}  // namespace murosimf::studies
