/// urdf_sensor.h - sensors in `gazebo` blocks of a URDF file.
///
/// Of cameras the size of the picture, its fov or the focal lengths, and its distortion are read, which stands in the
/// camera (k1 ... p2) or in its plugin (distortionK1 ... distortionT2). They look along x with z up. Of others: place, update_rate, of scanners the rays and ranges, and noise: stddev is
/// the deviation of every sample, bias_stddev that of a constant error; the largest of the three axes counts.
/// Source: SDFormat documentation, "sensor".
#pragma once

#include <string>

#include "murosimf/description/robot_description.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/formats/urdf/urdf_log.h"

namespace murosimf::formats::urdf {

/// The number of `<kp>0.9</kp>` or `<kp value="0.9"/>`.
[[nodiscard]] double text_number(const files::XmlElement& element);

/// A sensor on the link or joint `frame`. Throws SetupError with file:line for numbers that are impossible.
[[nodiscard]] description::SensorDescription read_sensor(const files::XmlElement& sensor, const std::string& frame,
                                                         UrdfLog& log);

}  // namespace murosimf::formats::urdf
