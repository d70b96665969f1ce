#include "murosimf/dds/ros2/ros_names.h"

#include <cctype>

#include <fmt/format.h>

namespace murosimf::dds::ros2 {

std::string ros_name(std::string_view name) {
  std::string allowed(name);
  for (char& c : allowed) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  if (allowed.empty() || std::isdigit(static_cast<unsigned char>(allowed.front())) != 0) allowed.insert(0, "_");
  return allowed;
}

std::string topic_name(std::string_view topic) { return fmt::format("rt{}", topic); }

std::string type_name(std::string_view type) {
  const std::size_t slash = type.find('/');
  return fmt::format("{}::msg::dds_::{}_", type.substr(0, slash), type.substr(slash + 1));
}

}  // namespace murosimf::dds::ros2
