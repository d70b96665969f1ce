/// mjcf_schema.h - the elements and attributes of MJCF that the reader uses, and the treatment of others.
///
/// Source: the XML reference of the MuJoCo documentation.
#pragma once

#include "murosimf/files/xml_schema.h"

namespace murosimf::robot_formats::mjcf {

[[nodiscard]] const files::XmlVocabulary& mjcf_schema();

/// Whether the tag is one of actuators that have no effect here except a warning.
[[nodiscard]] bool is_idle_actuator(std::string_view tag);

/// Whether the tag is one of the actuators that the reader supports.
[[nodiscard]] bool is_actuator(std::string_view tag);

}  // namespace murosimf::robot_formats::mjcf
