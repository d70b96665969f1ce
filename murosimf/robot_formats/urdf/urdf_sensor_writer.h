/// urdf_sensor_writer.h - sensors of a description as gazebo blocks of a URDF file.
#pragma once

#include "murosimf/files/xml_text.h"
#include "murosimf/math/transform.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::urdf {

/// Writes a `gazebo` element with the sensor; is_urdf_sensor (urdf_writer.h) must hold. `link`: carries it; `place`: of the
/// sensor there.
void write_sensor(files::XmlText& xml, const robot_formats::SensorDescription& sensor, const std::string& link,
                  const Transformd& place);

}  // namespace murosimf::robot_formats::urdf
