/// gazebo_schema.h - the elements and attributes of `gazebo` blocks of URDF, and of the sensors and collisions in them.
///
/// Elements that it lacks are warnings, not errors: blocks have many elements that only plugins use.
/// Sources: SDFormat documentation, "URDF in Gazebo" and "sensor".
#pragma once

#include "murosimf/files/xml_schema.h"

namespace murosimf::robot_formats::urdf {

/// Rules by tag. Of blocks themselves "gazebo" only; their contents are read by urdf_gazebo.h.
[[nodiscard]] const files::XmlVocabulary& gazebo_schema();

/// For printing: the words of URDF (urdf_schema.h), and those of gazebo blocks as "gazebo//imu".
[[nodiscard]] const files::XmlVocabulary& urdf_words();

}  // namespace murosimf::robot_formats::urdf
