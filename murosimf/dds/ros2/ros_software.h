/// ros_software.h - a robot whose software is ROS 2 nodes on this machine: they command its joints and its walk over DDS; ROS need not be installed.
///
///     /NAME/cmd_vel, cmd_vel_stamped                              geometry_msgs/Twist, TwistStamped: the motion engine walks so
///     /NAME/joint_trajectory_controller/joint_trajectory          trajectory_msgs/JointTrajectory
///     /NAME/joint_trajectory_controller/follow_joint_trajectory   control_msgs/FollowJointTrajectory, an action
///     /NAME/forward_position_controller/commands                  std_msgs/Float64MultiArray: all joints, in the order of joint_states
///     /NAME/joint_commands                                        sensor_msgs/JointState: positions, rates of wheels
///
/// Names as of ros2_control's controllers. Joints that were never commanded are the motion engine's; cmd_vel gives it the legs again. Messages are
/// written down with the step that takes them, so that a recorded run is repeated without the nodes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control_software/control_software.h"
#include "murosimf/dds/booster/motion_requests.h"
#include "murosimf/dds/external_messages.h"
#include "murosimf/dds/ros2/joint_motion.h"
#include "murosimf/dds/ros2/ros_options.h"
#include "murosimf/dds/ros2/trajectory_action.h"
#include "murosimf/dds/said_once.h"

namespace murosimf::dds::ros2 {

/// Topics that a robot's nodes write to.
class RosCommandLink {
 public:
  // Marks of messages.
  static constexpr char twist_mark = 't', stamped_twist_mark = 'T', trajectory_mark = 'j', numbers_mark = 'n',
                        joint_state_mark = 's';

  /// Throws SetupError.
  RosCommandLink(int domain, const std::string& robot);

  /// With all that has come. Requests of services begin with the identity of their sender (16 bytes of GUID, 8 of the number).
  [[nodiscard]] Inbox& inbox();
  [[nodiscard]] TrajectoryActionLink& action() { return *action_; }

 private:
  Inbox arrived_, passed_on_;
  int writers_ = 0;
  Participant participant_;  // ends before the inboxes
  std::unique_ptr<TrajectoryActionLink> action_;
};

class RosSoftware final : public control_software::ControlSoftware {
 public:
  /// Without `domain`, or if input is repeated, there is no DDS. Throws SetupError.
  RosSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say, const RosOptions& options,
              std::optional<int> domain, const ExternalInputOptions& outside = {});

  [[nodiscard]] control_software::CallOutcome start() override;
  [[nodiscard]] control_software::CallOutcome step(Duration now) noexcept override;
  void state(StateArchive& archive) override;
  [[nodiscard]] bool repeats_itself() const override { return true; }

  static constexpr double rate_hz = 500;

 private:
  void take(const Arrival& arrival, Duration now);
  [[nodiscard]] bool take_command(const Arrival& arrival, Duration now);
  [[nodiscard]] bool take_call(const Arrival& arrival, Duration now);
  [[nodiscard]] bool follow(const std::optional<TrajectoryMessage>& trajectory, Duration now);
  [[nodiscard]] bool set(const std::optional<JointStateMessage>& joints);
  [[nodiscard]] bool set(const std::optional<std::vector<double>>& numbers);
  [[nodiscard]] bool walk(const std::optional<Vec3d>& velocity, Duration now);
  [[nodiscard]] std::optional<std::vector<std::size_t>> known_places(const std::vector<std::string>& names);
  [[nodiscard]] bool is_live() const { return link_ && !outside_.remembers(); }
  void tell_of_goals(Duration now);

  control_software::SayLine say_;
  std::string name_;
  RosOptions options_;
  std::vector<std::string> names_;  // of joints
  JointMotion joints_;
  const murosimf_signal* position_;
  std::optional<booster::MotionRequests> motions_;  // nothing: it does not walk
  TrajectoryAction action_;
  std::unique_ptr<RosCommandLink> link_;  // null: nothing comes
  ExternalMessages outside_;
  Vec3d velocity_;  // of the last cmd_vel
  Duration walks_until_{};
  std::uint64_t cycle_ = 0;
  SaidOnce garbage_, unknown_joint_;
};

}  // namespace murosimf::dds::ros2
