/// urdf_sensor.h - sensors in `gazebo` blocks of a URDF file.
#pragma once

#include <string>

#include "murosimf/io/robot_draft.h"
#include "murosimf/io/xml_element.h"

namespace murosimf::io {

/// The number of <kp>0.9</kp> or <kp value="0.9"/>.
[[nodiscard]] double text_number(const XmlElement& element);

/// A sensor on the link or joint `frame`; of a camera also the size of the picture and its distortion, which stands in
/// the camera (k1 ... p2) or in the camera's plugin (distortionK1 ... distortionT2).
[[nodiscard]] DraftSensor read_sensor(const XmlElement& sensor, const std::string& frame);

}  // namespace murosimf::io
