/// command_messages.h - messages of ROS 2 nodes that command a robot, decoded. What is damaged, or too long, is nothing.
///
/// Fields: interface packages trajectory_msgs, std_msgs, sensor_msgs, geometry_msgs, control_msgs, action_msgs of ROS 2.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/dds/cdr.h"
#include "murosimf/math/vec3.h"

namespace murosimf::dds::ros2 {

using Encoded = std::span<const std::uint8_t>;

struct TrajectoryPoint {
  std::vector<double> positions, velocities;  ///< [rad | m], [rad/s | m/s] by joint; velocities may be empty
  double time = 0;                            ///< [s] from the start
};
/// trajectory_msgs/JointTrajectory
struct TrajectoryMessage {
  std::vector<std::string> joints;
  std::vector<TrajectoryPoint> points;
};
[[nodiscard]] std::optional<TrajectoryMessage> read_trajectory(Encoded message);

/// sensor_msgs/JointState; arrays may be empty.
struct JointStateMessage {
  std::vector<std::string> joints;
  std::vector<double> positions, velocities;
};
[[nodiscard]] std::optional<JointStateMessage> read_joint_state(Encoded message);

/// std_msgs/Float64MultiArray: its data.
[[nodiscard]] std::optional<std::vector<double>> read_numbers(Encoded message);

/// geometry_msgs/Twist, TwistStamped: forward, left [m/s], turn [rad/s].
[[nodiscard]] std::optional<Vec3d> read_twist(Encoded message);
[[nodiscard]] std::optional<Vec3d> read_stamped_twist(Encoded message);

using GoalId = std::array<std::uint8_t, 16>;
/// control_msgs/action/FollowJointTrajectory, SendGoal; tolerances are not read.
struct GoalMessage {
  GoalId id{};
  TrajectoryMessage trajectory;
};
[[nodiscard]] std::optional<GoalMessage> read_goal(Encoded message);
/// GetResult, and action_msgs/CancelGoal; all zeros: all goals.
[[nodiscard]] std::optional<GoalId> read_goal_id(Encoded message);

}  // namespace murosimf::dds::ros2
