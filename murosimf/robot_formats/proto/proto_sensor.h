/// proto_sensor.h - devices of a PROTO file that measure.
///
///     Gyro, Accelerometer, InertialUnit      gyroscope, accelerometer, orientation
///     GPS, PositionSensor                    position, joint_position
///     Camera (width, height, fieldOfView)    camera
///     TouchSensor, DistanceSensor            contact_force, rangefinder
///
/// Their output is in SI units: lookup tables are not used. Other devices are notes.
/// Source: Webots reference manual, nodes of these names; a camera looks along x with z up, before R2022a along -z with y up.
#pragma once

#include <optional>
#include <string>

#include "murosimf/robot_formats/proto/proto_log.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::proto {

/// The sensor of a device that is a Solid, with the name `body`; nothing if it measures nothing that is simulated. `old`: before R2022a.
[[nodiscard]] std::optional<robot_formats::SensorDescription> read_sensor(const Node& device, const std::string& body,
                                                                          bool old, ProtoLog& log);
/// The sensor of the PositionSensor of a joint.
[[nodiscard]] robot_formats::SensorDescription read_position_sensor(const Node& sensor, const std::string& joint);

}  // namespace murosimf::robot_formats::proto
