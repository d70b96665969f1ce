#include "murosimf/robot_formats/urdf/urdf_value.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/roll_pitch_yaw.h"

#include <fmt/format.h>

namespace murosimf::robot_formats::urdf {
namespace {

std::string name_of(const files::XmlElement& element, const char* attribute) {
  return fmt::format("{} of <{}>", attribute, element.tag());
}

}  // namespace

std::optional<files::XmlElement> only_child(const files::XmlElement& parent, const char* tag) {
  const auto found = parent.children(tag);
  if (found.size() > 1) found[1].fail(fmt::format("second <{}> in <{}>; keep one", tag, parent.tag()));
  return found.empty() ? std::nullopt : std::optional(found[0]);
}

files::XmlElement needed_child(const files::XmlElement& parent, const char* tag) {
  const auto child = only_child(parent, tag);
  if (!child) parent.fail(fmt::format("<{}> without <{}>; add it", parent.tag(), tag));
  return *child;
}

void refuse_macro(const files::XmlElement& element, const std::string& value) {
  if (value.find("${") == std::string::npos && value.find("$(") == std::string::npos) return;
  element.fail(fmt::format(
      "'{}' is a macro of xacro; end the file's name in .xacro, or expand it first: xacro robot.xacro > robot.urdf",
      value));
}

std::string needed_text(const files::XmlElement& element, const char* attribute) {
  const auto text = element.attribute(attribute);
  if (!text || text->empty()) element.fail(fmt::format("<{}> without {}; add it", element.tag(), attribute));
  refuse_macro(element, *text);
  return *text;
}

std::vector<double> needed_numbers(const files::XmlElement& element, const std::string& text, std::size_t count,
                                   const std::string& what) {
  refuse_macro(element, text);
  auto numbers = files::parse_numbers(text);
  if (!numbers || numbers->size() != count) {
    const std::string wanted = count == 1 ? "one finite number" : fmt::format("{} finite numbers", count);
    element.fail(fmt::format("{} is '{}'; write {}", what, text, wanted));
  }
  MUROSIMF_ASSERT(numbers->size() == count);
  return *numbers;
}

double needed_number(const files::XmlElement& element, const char* attribute) {
  return needed_numbers(element, needed_text(element, attribute), 1, name_of(element, attribute))[0];
}

double number_or(const files::XmlElement& element, const char* attribute, double fallback) {
  return element.attribute(attribute) ? needed_number(element, attribute) : fallback;
}

double at_least_zero(const files::XmlElement& element, const char* attribute) {
  const double number = number_or(element, attribute, 0);
  if (number < 0) element.fail(fmt::format("{} is negative; it must be at least 0", name_of(element, attribute)));
  return number;
}

double positive(const files::XmlElement& element, const char* attribute) {
  const double number = needed_number(element, attribute);
  if (!(number > 0)) element.fail(fmt::format("{} is {}; it must be more than 0", name_of(element, attribute), number));
  return number;
}

Vec3d needed_vector(const files::XmlElement& element, const char* attribute) {
  const auto v = needed_numbers(element, needed_text(element, attribute), 3, name_of(element, attribute));
  return {v[0], v[1], v[2]};
}

Vec3d vector_or(const files::XmlElement& element, const char* attribute, const Vec3d& fallback) {
  return element.attribute(attribute) ? needed_vector(element, attribute) : fallback;
}

Transformd read_origin(const files::XmlElement& owner) {
  const auto origin = only_child(owner, "origin");
  if (!origin) return {};
  return {vector_or(*origin, "xyz", {}), from_roll_pitch_yaw(vector_or(*origin, "rpy", {}))};
}

}  // namespace murosimf::robot_formats::urdf
