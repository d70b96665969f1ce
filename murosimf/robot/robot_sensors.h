/// robot_sensors.h - the sensors of a robot, from its robot file and the tables of the TOML file beside it.
///
/// Elements of robot files become sensors of these types; `mjcf_sensor.h` and `urdf_sensor.h` read them.
///
///     MJCF  gyro, accelerometer, framequat          gyroscope, accelerometer, orientation
///           jointpos, jointvel                      joint_position, joint_velocity
///           jointactuatorfrc, actuatorfrc           joint_torque
///           touch; force, torque                    contact_force; joint_wrench
///           framepos, framelinvel, frameangvel      position, linear_velocity, angular_velocity
///           velocimeter, subtreecom (of the base)   velocimeter, center_of_mass
///           rangefinder                             rangefinder
///           camera (of a body)                      camera (mjcf_camera.h)
///     URDF  imu, contact, force_torque              imu, contact_force, joint_wrench
///           ray, gpu_ray, lidar, gpu_lidar          laser
///           camera                                  camera (urdf_sensor.h)
///
/// Numbers of cameras: width and height [px]; fov [rad], from the left to the right border, or fx, fy, cx, cy [px]
/// (imaging/image.h defines their origin); k1, k2, p1, p2, k3 [1], Brown's distortion, if the file has any. They
/// look along x, with y to the left and z up. Their rate is lowered to whole milliseconds; 25 Hz if the file has none.
///
/// Others become notes, as do differences between a sensor and the simulated one. MJCF's `noise` is SignalSpec::noise, its `cutoff` the
/// range. A sensor without a name is called as its type: gyroscope, gyroscope_2, ...
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::robot {

/// The sensors of the description, changed by the tables; their parts may be in `folder`. Sensors of the file that are not
/// simulated are lines in the description's notes. Throws SetupError with the place of a sensor on a frame that the model does
/// not have; with `lenient` such sensors of the file are lines in its warnings.
[[nodiscard]] std::vector<sensors::SensorSpec> sensors_of(robot_formats::RobotDescription& description,
                                                          const RobotConfig& table, const Model& model,
                                                          const std::filesystem::path& folder, bool lenient);

}  // namespace murosimf::robot
