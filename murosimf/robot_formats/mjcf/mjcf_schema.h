/// mjcf_schema.h - which elements and attributes of MJCF the reader knows, and what it does with the others.
///
/// Source: the XML reference of the MuJoCo documentation.
#pragma once

#include "murosimf/files/xml_schema.h"

namespace murosimf::robot_formats::mjcf {

[[nodiscard]] const files::XmlVocabulary& mjcf_schema();

/// Tags of actuators, and of what joins bodies or tendons, that have no effect here but a warning each.
[[nodiscard]] bool is_idle_relation(std::string_view tag);

/// Tags of the actuators that the reader understands.
[[nodiscard]] bool is_actuator(std::string_view tag);

}  // namespace murosimf::robot_formats::mjcf
