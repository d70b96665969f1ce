// Topics that command a robot: how they are called, and how services' senders travel with their requests.
#include <cstring>

#include <fmt/format.h>

#include "murosimf/dds/ros2/ros_names.h"
#include "murosimf/dds/ros2/ros_software.h"

namespace murosimf::dds::ros2 {
namespace {

Bytes with_sender(const Arrival& arrival) {
  Bytes bytes(arrival.from.writer.begin(), arrival.from.writer.end());
  const auto* const number = reinterpret_cast<const std::uint8_t*>(&arrival.from.number);
  bytes.insert(bytes.end(), number, number + sizeof arrival.from.number);
  bytes.insert(bytes.end(), arrival.message.begin(), arrival.message.end());
  return bytes;
}

bool is_call(char mark) {
  using Link = TrajectoryActionLink;
  return mark == Link::send_goal_mark || mark == Link::cancel_mark || mark == Link::result_mark;
}

}  // namespace

RosCommandLink::RosCommandLink(int domain, const std::string& robot) : participant_(domain) {
  const std::string name = ros_name(robot);
  const auto read = [&](const char* topic, const char* type, char mark) {
    participant_.read({.name = topic_name(fmt::format("/{}/{}", name, topic)), .type = type_name(type)}, arrived_,
                      mark);
  };
  read("cmd_vel", "geometry_msgs/Twist", twist_mark);
  read("cmd_vel_stamped", "geometry_msgs/TwistStamped", stamped_twist_mark);
  read("joint_trajectory_controller/joint_trajectory", "trajectory_msgs/JointTrajectory", trajectory_mark);
  read("forward_position_controller/commands", "std_msgs/Float64MultiArray", numbers_mark);
  read("joint_commands", "sensor_msgs/JointState", joint_state_mark);
  const std::string action = fmt::format("/{}/joint_trajectory_controller/follow_joint_trajectory", name);
  action_ = std::make_unique<TrajectoryActionLink>(participant_, action, arrived_);
}

Inbox& RosCommandLink::inbox() {
  for (const Arrival& arrival : arrived_.take()) {
    passed_on_.put(arrival.topic, is_call(arrival.topic) ? with_sender(arrival) : arrival.message);
  }
  const int writers = arrived_.writers();
  passed_on_.count_writer(writers - writers_);
  writers_ = writers;
  return passed_on_;
}

}  // namespace murosimf::dds::ros2
