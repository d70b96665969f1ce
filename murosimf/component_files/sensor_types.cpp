#include "murosimf/component_files/sensor_types.h"

#include <string>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/sensors/camera.h"
#include "murosimf/sensors/contact_sensors.h"
#include "murosimf/sensors/depth_laser.h"
#include "murosimf/sensors/detector.h"
#include "murosimf/sensors/frame_sensors.h"
#include "murosimf/sensors/ground_truth.h"
#include "murosimf/sensors/inertial.h"
#include "murosimf/sensors/joint_sensors.h"
#include "murosimf/sensors/joint_wrench.h"
#include "murosimf/sensors/laser.h"
#include "murosimf/sensors/sonar.h"

namespace murosimf::component_files {
namespace {

using sensors::Watch;

template <class S>
std::unique_ptr<sensors::Sensor> make(Setup& setup, const sensors::SensorSpec& spec,
                                      const sensors::SensorSurroundings& surroundings) {
  return std::make_unique<S>(setup, spec, surroundings);
}

// Most sensors measure at their samples only; Watch::always is for those that need the steps in between.
std::vector<SensorType> built_in_types() {
  return {
      SensorType{"accelerometer", "specific force: +9.81 up at rest, 0 in free fall", "", Watch::always,
                 make<sensors::Accelerometer>},
      SensorType{"angular_velocity", "of the sensor, world axes", "", Watch::samples, make<sensors::AngularVelocity>},
      SensorType{"camera", "pictures through a lens: colors, depths, labels of what is seen", "", Watch::samples,
                 make<sensors::Camera>, sensors::camera_options().infos()},
      SensorType{"center_of_mass", "of the whole robot, and its velocity, world axes", "", Watch::samples,
                 make<sensors::CenterOfMass>},
      SensorType{"contact_force", "magnitude of all contact forces on a link", "", Watch::samples,
                 make<sensors::ContactForce>, sensors::contact_sensor_options().infos()},
      SensorType{"contact_switch", "1 while anything touches a link", "", Watch::samples, make<sensors::ContactSwitch>,
                 sensors::contact_sensor_options().infos()},
      SensorType{"depth_laser", "the same as laser, by pictures of depths: it sees what is drawn", "", Watch::samples,
                 make<sensors::DepthLaser>, sensors::laser_options().infos()},
      SensorType{"detector", "places of ball and robots as vision software reports them: distance, azimuth, elevation",
                 "entities", Watch::samples, make<sensors::Detector>, sensors::detector_options().infos()},
      SensorType{"force_torque", "contact force and moment on a link, in axes of the sensor", "", Watch::samples,
                 make<sensors::ForceTorque>, sensors::contact_sensor_options().infos()},
      SensorType{"ground_truth", "true place, heading and velocity of robots and ball (paper 6.3)", "entities",
                 Watch::samples, make<sensors::GroundTruth>},
      SensorType{"gyroscope", "rate of turning, in axes of the sensor", "", Watch::samples, make<sensors::Gyroscope>},
      SensorType{"imu", "gyroscope, accelerometer and orientation in one part", "", Watch::always, make<sensors::Imu>},
      SensorType{"joint_position", "encoders of joints", "joints", Watch::samples, make<sensors::JointPosition>},
      SensorType{"joint_velocity", "rates of joints", "joints", Watch::samples, make<sensors::JointRate>},
      SensorType{"joint_wrench", "force and moment through a joint or a weld, in axes of the sensor", "", Watch::always,
                 make<sensors::JointWrench>, sensors::joint_wrench_options().infos()},
      SensorType{"joint_torque", "torque of servo and gear", "joints", Watch::samples, make<sensors::JointTorque>},
      SensorType{"laser", "distances of what a scan of a plane meets", "", Watch::samples, make<sensors::Laser>,
                 sensors::laser_options().infos()},
      SensorType{"linear_velocity", "of the sensor, world axes", "", Watch::samples, make<sensors::LinearVelocity>},
      SensorType{"motor_current", "of servos", "joints", Watch::samples, make<sensors::MotorCurrent>},
      SensorType{"motor_temperature", "of servos' windings", "joints", Watch::samples, make<sensors::MotorTemperature>},
      SensorType{"motor_voltage", "supply of servos", "joints", Watch::samples, make<sensors::MotorVoltage>},
      SensorType{"orientation", "axes of the sensor in the world, as a quaternion w x y z", "", Watch::samples,
                 make<sensors::Orientation>},
      SensorType{"position", "of the sensor, world", "", Watch::samples, make<sensors::Position>},
      SensorType{"pressure_cells", "four cells below a foot", "", Watch::samples, make<sensors::PressureCells>,
                 sensors::pressure_cells_options().infos()},
      SensorType{"pressure_center", "where the contact force goes through a sole, and how strong it is", "",
                 Watch::samples, make<sensors::PressureCenter>, sensors::contact_sensor_options().infos()},
      SensorType{"rangefinder", "distance of what one ray along z meets", "", Watch::samples,
                 make<sensors::RangeFinder>, sensors::rangefinder_options().infos()},
      SensorType{"sonar", "distance of the nearest thing in a cone about x", "", Watch::samples, make<sensors::Sonar>,
                 sensors::sonar_options().infos()},
      SensorType{"velocimeter", "velocity of the sensor, in its axes", "", Watch::samples, make<sensors::Velocimeter>},
  };
}

}  // namespace

Registry<SensorType>& sensor_registry() {
  static Registry<SensorType> registry("sensor type", built_in_types());
  return registry;
}

const Registry<SensorType>& sensor_types() { return sensor_registry(); }

namespace {

sensors::Sensor& attach(Simulation& simulation, Entity& robot, const sensors::SensorSpec& spec,
                        const sensors::SensorSurroundings& surroundings, double step_rate) {
  MUROSIMF_ASSERT(step_rate > 0);
  const SensorType& type = sensor_types().find(spec.type);
  sensors::check_rate(spec, step_rate);
  if (!(spec.delay >= 0 && spec.delay <= 10)) {
    throw SetupError(fmt::format("the delay of sensor '{}' is {} s; it must be from 0 to 10", spec.name, spec.delay));
  }
  // Errors in the constructor get the sensor's name: specs of a robot may have no place in a file.
  const auto make = [&](Setup& setup) -> std::unique_ptr<Algorithm> {
    return murosimf::with_context(spec.name, [&] { return type.make(setup, spec, surroundings); });
  };
  const Rate rate = sensors::task_rate(spec, type.watch, step_rate);
  return static_cast<sensors::Sensor&>(simulation.attach(type.name, robot, rate, make));
}

}  // namespace

sensors::Sensor& attach_sensor(Simulation& simulation, Entity& robot, const sensors::SensorSpec& spec,
                               const sensors::SensorSurroundings& surroundings, double step_rate) {
  const auto do_it = [&]() -> sensors::Sensor& { return attach(simulation, robot, spec, surroundings, step_rate); };
  return spec.where.empty() ? do_it() : with_context(spec.where, do_it);
}

}  // namespace murosimf::component_files
