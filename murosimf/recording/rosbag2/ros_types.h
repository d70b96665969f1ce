/// ros_types.h - definitions of the ROS 2 messages that bags contain, as rosbag2 and its readers expect them in MCAP files ("ros2msg").
#pragma once

#include <string>
#include <string_view>

namespace murosimf::recording {

/// The fields of a type, and of all types that it contains, each below a line "MSG: package/Type".
/// `type` is "package/Type", one of those in ros_types.cpp; field names and order are those of ROS 2 Humble and Jazzy, which agree.
[[nodiscard]] std::string ros_definition(std::string_view type);

}  // namespace murosimf::recording
