#include "murosimf/io/sensor_types.h"

#include <array>
#include <string>

#include <fmt/format.h>

#include "murosimf/io/registry.h"
#include "murosimf/sensors/detector.h"
#include "murosimf/sensors/inertial.h"
#include "murosimf/sensors/laser.h"
#include "murosimf/sensors/sonar.h"

namespace murosimf::io {
namespace {

using sensors::Watch;

template <class S>
std::unique_ptr<sensors::Sensor> make(Setup& setup, const sensors::SensorSpec& spec,
                                      const sensors::SensorSurroundings& surroundings) {
  return std::make_unique<S>(setup, spec, surroundings);
}

constexpr std::array types{
    SensorType{"accelerometer", "specific force: +9.81 up at rest, 0 in free fall", "", "", Watch::always,
               make<sensors::Accelerometer>},
    SensorType{"detector", "places of ball and robots as vision software reports them: distance, azimuth, elevation",
               "opening_azimuth opening_elevation nearest farthest visible_share misses distance_noise azimuth_noise "
               "elevation_noise offset",
               "entities", Watch::samples, make<sensors::Detector>},
    SensorType{"gyroscope", "rate of turning, in axes of the sensor", "", "", Watch::samples, make<sensors::Gyroscope>},
    SensorType{"imu", "gyroscope, accelerometer and orientation in one part", "", "", Watch::always,
               make<sensors::Imu>},
    SensorType{"laser", "distances of what a scan of a plane meets", "rays opening first_angle nearest farthest", "",
               Watch::samples, make<sensors::Laser>},
    SensorType{"orientation", "axes of the sensor in the world, as a quaternion w x y z", "", "", Watch::samples,
               make<sensors::Orientation>},
    SensorType{"rangefinder", "distance of what one ray along z meets", "nearest farthest", "", Watch::samples,
               make<sensors::RangeFinder>},
    SensorType{"sonar", "distance of the nearest thing in a cone about x", "rays opening nearest farthest", "",
               Watch::samples, make<sensors::Sonar>},
};

}  // namespace

std::span<const SensorType> sensor_types() { return types; }

sensors::Sensor& attach_sensor(Simulation& simulation, Entity& robot, const sensors::SensorSpec& spec,
                               const sensors::SensorSurroundings& surroundings, double step_rate) {
  return at(spec.where, [&]() -> sensors::Sensor& {
    const SensorType& type = find_entry(sensor_types(), "sensor type", spec.type);
    sensors::check_rate(spec, step_rate);
    if (!(spec.delay >= 0 && spec.delay <= 10)) {
      throw SetupError(fmt::format("the delay of sensor '{}' is {} s; it must be from 0 to 10", spec.name, spec.delay));
    }
    const double rate = sensors::task_rate(spec, type.watch, step_rate);
    Algorithm& algorithm =
        simulation.attach(std::string(type.name), robot, rate, [&](Setup& setup) -> std::unique_ptr<Algorithm> {
          return murosimf::at(spec.name, [&] { return type.make(setup, spec, surroundings); });
        });
    return static_cast<sensors::Sensor&>(algorithm);
  });
}

}  // namespace murosimf::io
