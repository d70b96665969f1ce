/// mjcf_sensor.h - elements of the section `sensor` of an MJCF file.
///
/// `noise` is the deviation of every sample, `cutoff` the largest magnitude of the output; both apply to all outputs. A
/// frame sensor of an object of type "body" measures at the center of mass (those of "xbody" at the body's frame).
/// Source: XML reference of the MuJoCo documentation, "sensor".
#pragma once

#include "murosimf/files/xml_element.h"
#include "murosimf/files/xml_text.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Reads a sensor. `description`: its bodies are read already. A sensor of an actuator becomes one of the actuator's joint.
[[nodiscard]] robot_formats::SensorDescription read_mjcf_sensor(const files::XmlElement& element,
                                                                const files::XmlElement& root,
                                                                const MjcfDefaults& defaults,
                                                                const robot_formats::RobotDescription& description);

/// Writes the section `sensor`: an element for each sensor that MJCF has and that has its object in the description, a comment for
/// others. Cameras of MJCF are written in bodies (mjcf_camera.h).
void write_mjcf_sensors(files::XmlText& xml, const robot_formats::RobotDescription& description);

/// Whether MJCF has an element for the sensor, in the section `sensor` or in a body.
[[nodiscard]] bool is_mjcf_sensor(const robot_formats::SensorDescription& sensor,
                                  const robot_formats::RobotDescription& description);

}  // namespace murosimf::robot_formats::mjcf
