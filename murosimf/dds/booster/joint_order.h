/// joint_order.h - the order in which Booster robots list their joints, and where these are among the joints of a model.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::dds::booster {

struct JointOrder {
  std::string_view model;                   ///< "K1"
  std::span<const std::string_view> names;  ///< "left_hip_pitch"
};

/// Of the K1 with 22 joints and the T1 with 23. Source: enums JointIndexK1 and JointIndex of the vendor's SDK 1.6.3.
[[nodiscard]] std::span<const JointOrder> joint_orders();

/// For each joint of the order its place among `joints`, names of the model's joints: the robot's files write them "ALeft_Shoulder_Pitch" or
/// "Left_Hip_Pitch_Joint".
struct PlacedJoints {
  const JointOrder* order = nullptr;
  std::vector<std::size_t> places;
};
/// Throws SetupError: the model is none of these robots.
[[nodiscard]] PlacedJoints place_joints(std::span<const std::string> joints);

}  // namespace murosimf::dds::booster
