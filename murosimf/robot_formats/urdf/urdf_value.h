/// urdf_value.h - values of URDF elements and attributes. Each error has file, line, and what to do.
///
/// SI units and radians. `rpy` are those of math/roll_pitch_yaw.h. Source: URDF XML specification, "joint" and "link".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/xml_element.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::urdf {

/// The element of that name inside; nothing if there is none. A second one is an error.
[[nodiscard]] std::optional<files::XmlElement> only_child(const files::XmlElement& parent, const char* tag);
/// The same; required.
[[nodiscard]] files::XmlElement needed_child(const files::XmlElement& parent, const char* tag);

/// A required attribute that is not empty.
[[nodiscard]] std::string needed_text(const files::XmlElement& element, const char* attribute);
/// Throws SetupError unless `text` is a list of exactly `count` finite numbers; `what` names them.
[[nodiscard]] std::vector<double> needed_numbers(const files::XmlElement& element, const std::string& text,
                                                 std::size_t count, const std::string& what);

[[nodiscard]] double needed_number(const files::XmlElement& element, const char* attribute);
[[nodiscard]] double number_or(const files::XmlElement& element, const char* attribute, double fallback);
[[nodiscard]] double at_least_zero(const files::XmlElement& element, const char* attribute);
/// A size: required and more than zero.
[[nodiscard]] double positive(const files::XmlElement& element, const char* attribute);
[[nodiscard]] Vec3d needed_vector(const files::XmlElement& element, const char* attribute);
[[nodiscard]] Vec3d vector_or(const files::XmlElement& element, const char* attribute, const Vec3d& fallback);

/// The place that the `origin` of an element gives; the identity if it has none.
[[nodiscard]] Transformd read_origin(const files::XmlElement& owner);

/// Throws SetupError if a value still holds "${...}" or "$(...)" of the macro language xacro.
void refuse_macro(const files::XmlElement& element, const std::string& value);

}  // namespace murosimf::robot_formats::urdf
