// One sample of every kind of sensor, on the middle robot of 22 at kick-off: what a sensor costs.
#include <benchmark/benchmark.h>

#include "murosimf/collision/queries.h"
#include "murosimf/collision/scan.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"

namespace murosimf::benchmarks {
namespace {

/// The robot whose sensors are measured stands beside the ball, with others on all sides of it.
struct Match {
  Match() : scene("eleven_a_side"), simulation(scene.simulation()), robot(simulation.world().entity("blue11")) {
    for (const auto& entity : simulation.world().entities()) {
      if (entity->level.empty()) continue;
      moving_entities.push_back(entity.get());
    }
  }
  sensors::Sensor& attach(const std::string& type, double tilt = 0) {
    sensors::SensorSpec spec;
    spec.name = "measured";  // no sensor of the robot's own is called so
    spec.type = type;
    spec.orientation = rotation_y(tilt);
    return component_files::attach_sensor(simulation, robot, spec, {1, moving_entities}, 1000);
  }

  scene::Scene scene;
  Simulation& simulation;
  Entity& robot;
  std::vector<Entity*> moving_entities;
};

/// Counts the numbers of a sample that are finite.
void count(benchmark::State& bench, const sensors::Reading& reading) {
  double found = 0;
  for (const double value : reading.values) found += std::isfinite(value) ? 1 : 0;
  bench.counters["numbers"] = static_cast<double>(reading.values.size());
  bench.counters["finite"] = found;
}

/// A sample of the sensor; bounding volumes are worked out again for each one.
void sample(benchmark::State& bench, const char* type, double tilt = 0) {
  Match match;
  sensors::Sensor& sensor = match.attach(type, tilt);
  match.simulation.initialize();
  const Instant instant{Duration{}, from_seconds(0.001)};
  for (auto _ : bench) sensor.step(instant);
  count(bench, sensor.reading());
}

/// The laser's scan, ray by ray.
void ray_by_ray(benchmark::State& bench, double tilt) {
  Match match;
  match.simulation.initialize();
  collision::QueryScene scene(match.simulation.world());
  const collision::Fan fan(1081, -0.75 * pi, 1.5 * pi);
  const auto& robot = match.robot;
  const Transformd at{robot.find(properties::position)->values[0],
                      robot.find(properties::orientation)->values[0] * rotation_y(tilt)};
  for (auto _ : bench) {
    scene.refresh();
    for (std::size_t i = 0; i < fan.size(); ++i) {
      benchmark::DoNotOptimize(scene.cast(fan.ray(i, at), {.range = 30, .without = &robot}));
    }
  }
}

BENCHMARK_CAPTURE(sample, gyroscope, "gyroscope");
BENCHMARK_CAPTURE(sample, imu, "imu");
BENCHMARK_CAPTURE(sample, laser, "laser")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(sample, laser_tilted, "laser", 0.1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ray_by_ray, laser, 0.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ray_by_ray, laser_tilted, 0.1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(sample, sonar, "sonar")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(sample, rangefinder, "rangefinder");
BENCHMARK_CAPTURE(sample, detector, "detector")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace murosimf::benchmarks
