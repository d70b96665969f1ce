/// joint_motion.h - targets of joints as ROS 2 nodes command them: at once, or along a trajectory.
///
/// A trajectory begins where the target is. Between two points it is a line, or, where points have velocities, the cubic polynomial with these
/// positions and velocities: as the joint_trajectory_controller of ros2_control interpolates.
#pragma once

#include <string>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/ros2/command_messages.h"

namespace murosimf::dds::ros2 {

/// Joints of a message by their places in the port; not good: there is no joint of a name, or one twice.
struct NamedPlaces {
  std::vector<std::size_t> places;
  std::string unknown;  ///< the name; empty: all are good
};

class JointMotion {
 public:
  /// `engine`: the motion engine moves joints that are not commanded. Throws SetupError.
  JointMotion(Setup& setup, control_software::RobotPort& port, bool engine);

  [[nodiscard]] NamedPlaces places_of(const std::vector<std::string>& names) const;
  [[nodiscard]] std::size_t size() const { return joints_.size(); }

  void restart();
  /// [rad | m], and rates that wheels follow; empty: not given.
  void set(const std::vector<std::size_t>& places, const std::vector<double>& positions,
           const std::vector<double>& rates);
  void follow(const std::vector<std::size_t>& places, const TrajectoryMessage& trajectory, Duration now);
  /// They stay where they are.
  void halt(const std::vector<std::size_t>& places);
  /// The motion engine has the legs again.
  void leave_legs();
  /// In every cycle.
  void command(Duration now);
  /// [rad | m]
  [[nodiscard]] double target(std::size_t place) const { return joints_[place].target; }

  template <class Archive>
  void state(Archive& archive) {
    archive(joints_, started_);
  }

 private:
  struct Node {
    double time = 0, position = 0, velocity = 0;  // [s] since the start of the trajectory
    bool smooth = false;                          // the velocity is given
    void state(StateArchive& archive) { archive(time, position, velocity, smooth); }
  };
  struct Joint {
    bool commanded = false;
    double target = 0, rate = 0;
    Duration start{};         // of the trajectory
    std::vector<Node> nodes;  // empty: none
    void state(StateArchive& archive) { archive(commanded, target, rate, start, nodes); }
  };
  static void sample(Joint& joint, double time);

  std::vector<std::string> names_;
  std::vector<int> objects_;
  std::vector<char> is_leg_;
  std::span<const double> own_target_;          // by object
  murosimf_command *engine_, *target_, *rate_;  // the engine's null: there is none
  control_software::CommandRange target_range_, rate_range_;
  std::vector<Joint> joints_;
  bool started_ = false;
};

}  // namespace murosimf::dds::ros2
