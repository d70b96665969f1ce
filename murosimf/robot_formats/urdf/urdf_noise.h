/// urdf_noise.h - errors of sensors in `gazebo` blocks of a URDF file.
///
///     mean, stddev                        mean, noise
///     bias_mean, bias_stddev              bias_mean, bias: a constant error to one side or the other
///     dynamic_bias_stddev, ..._correlation_time      bias_random_walk, bias_correlation_time; nothing if one of them is 0
///     precision                           resolution, where the type is gaussian_quantized
///
/// On the right are the members of sensors::SignalSpec. Nothing is used where the type is none.
/// Source: SDFormat documentation, "noise"; of Gazebo the equations of its Gaussian noise model.
#pragma once

#include <string>

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"

namespace murosimf::robot_formats::urdf {

/// Throws SetupError with file:line for a deviation that is negative.
[[nodiscard]] sensors::SignalSpec read_noise(const files::XmlElement& noise, UrdfLog& log);

/// Reads the noise of the axes x, y, z inside the element `quantity` of `parent`, for an output of the sensor: one for all, or, where
/// they differ, one for each ("accelerometer.x").
void read_axes(const files::XmlElement& parent, const char* quantity, const std::string& output,
               robot_formats::SensorDescription& description, UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
