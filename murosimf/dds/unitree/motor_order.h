/// motor_order.h - the order in which Unitree's G1 lists its motors, and where these are among the joints of a model.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::dds::unitree {

/// "left_hip_pitch", 29 of them. Source: g1_joint_index_dds.md of github.com/unitreerobotics/unitree_ros, mode 0 (pitch and roll).
[[nodiscard]] std::span<const std::string_view> motor_order();

/// What a state says of the robot's kind: 29 joints, revision 1.0. Source: the table of robots/g1_description/README.md there.
inline constexpr std::uint8_t kind_of_robot = 5;

/// For each motor its place among `joints`, names of the model's joints, which may end with "_joint". Throws SetupError: the model is no G1.
[[nodiscard]] std::vector<std::size_t> place_joints(std::span<const std::string> joints);

}  // namespace murosimf::dds::unitree
