/// urdf_sensor.h - sensors in `gazebo` blocks of a URDF file.
///
/// Of cameras the size of the picture, its fov or the focal lengths, the noise of pixels, and the distortion, from the
/// camera (k1 ... p2) or its plugin (distortionK1 ... distortionT2). They look along x with z up. Of others: place, update_rate, of
/// scanners the rays and ranges, of force_torque the frame and the direction, and noise (urdf_noise.h).
/// Source: SDFormat documentation, "sensor".
#pragma once

#include <optional>
#include <string>

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"

namespace murosimf::robot_formats::urdf {

/// The number of `<kp>0.9</kp>` or `<kp value="0.9"/>`.
[[nodiscard]] double text_number(const files::XmlElement& element);

/// Place of a sensor.
struct SensorPlace {
  std::string frame;  ///< link or joint
  std::string parent,
      child;  ///< links on both sides of the joint, or of the one above the link; parent empty: none
  /// In that frame, if the reader has computed it and has checked the element's words (SDF); nothing: as in `pose`.
  std::optional<Transformd> place{};
};

/// A sensor on a link or joint. Throws SetupError with file:line for numbers and words that are impossible.
[[nodiscard]] robot_formats::SensorDescription read_sensor(const files::XmlElement& sensor, const SensorPlace& at,
                                                           UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
