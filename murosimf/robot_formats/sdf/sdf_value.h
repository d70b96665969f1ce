/// sdf_value.h - values of SDF elements, which are their texts. Each error has file, line, and what to do.
#pragma once

#include <string>

#include "murosimf/files/xml_element.h"
#include "murosimf/math/vec3.h"

namespace murosimf::robot_formats::sdf {

/// The text of an element inside; `fallback` if it is missing or empty.
[[nodiscard]] std::string child_text(const files::XmlElement& parent, const char* tag, const std::string& fallback);
/// true, false, 1 or 0. Throws SetupError for another word.
[[nodiscard]] bool flag(const files::XmlElement& parent, const char* tag, bool fallback);
/// A number; infinite ones are allowed. Throws SetupError for other texts.
[[nodiscard]] double number(const files::XmlElement& parent, const char* tag, double fallback);
[[nodiscard]] double at_least_zero(const files::XmlElement& parent, const char* tag, double fallback);
/// A size: required, finite and more than zero.
[[nodiscard]] double positive(const files::XmlElement& parent, const char* tag);
[[nodiscard]] Vec3d vector(const files::XmlElement& parent, const char* tag, const Vec3d& fallback);

}  // namespace murosimf::robot_formats::sdf
