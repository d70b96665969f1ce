/// ros_names.h - names that ROS 2 allows, and what topics and types are called in DDS.
///
/// Source: ROS 2 design, "Topic and Service name mapping to DDS" (prefixes rt, rq, rr) and "Mapping between ROS interface types and DDS IDL types".
#pragma once

#include <string>
#include <string_view>

namespace murosimf::dds::ros2 {

/// '_' for other characters, and before a digit: "blue-1" is "blue_1", "1" is "_1".
[[nodiscard]] std::string ros_name(std::string_view name);

/// "/blue1/imu" is "rt/blue1/imu".
[[nodiscard]] std::string topic_name(std::string_view topic);
/// "sensor_msgs/Imu" is "sensor_msgs::msg::dds_::Imu_".
[[nodiscard]] std::string type_name(std::string_view type);

}  // namespace murosimf::dds::ros2
