#include "murosimf/robot_formats/sdf/sdf_value.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::sdf {
namespace {

constexpr double endless = 1e15;  // the format writes 1e16 for infinity

}  // namespace

std::string child_text(const files::XmlElement& parent, const char* tag, const std::string& fallback) {
  const auto child = urdf::only_child(parent, tag);
  return child && !child->text().empty() ? child->text() : fallback;
}

bool flag(const files::XmlElement& parent, const char* tag, bool fallback) {
  const auto child = urdf::only_child(parent, tag);
  if (!child || child->text().empty()) return fallback;
  const std::string text = files::lower_case(child->text());
  if (text != "true" && text != "false" && text != "1" && text != "0") {
    child->fail(fmt::format("<{}> is '{}'; write true or false", tag, child->text()));
  }
  return text == "true" || text == "1";
}

double number(const files::XmlElement& parent, const char* tag, double fallback) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto child = urdf::only_child(parent, tag);
  if (!child || child->text().empty()) return fallback;
  const std::string text = files::lower_case(child->text());
  if (text == "inf" || text == "+inf" || text == "infinity") return infinity;
  if (text == "-inf" || text == "-infinity") return -infinity;
  const double value = urdf::needed_numbers(*child, child->text(), 1, fmt::format("<{}>", tag))[0];
  return std::abs(value) >= endless ? std::copysign(infinity, value) : value;
}

double at_least_zero(const files::XmlElement& parent, const char* tag, double fallback) {
  const double value = number(parent, tag, fallback);
  if (value >= 0 && std::isfinite(value)) return value;
  parent.fail(fmt::format("<{}> of {} is {}; it must be at least 0, and finite", tag, parent.tag(), value));
}

double positive(const files::XmlElement& parent, const char* tag) {
  const double value = number(parent, tag, 0);
  if (value > 0 && std::isfinite(value)) return value;
  parent.fail(fmt::format("{} needs a <{}> of more than 0", parent.tag(), tag));
}

Vec3d vector(const files::XmlElement& parent, const char* tag, const Vec3d& fallback) {
  const auto child = urdf::only_child(parent, tag);
  if (!child || child->text().empty()) return fallback;
  const auto values = urdf::needed_numbers(*child, child->text(), 3, fmt::format("<{}>", tag));
  return {values[0], values[1], values[2]};
}

}  // namespace murosimf::robot_formats::sdf
