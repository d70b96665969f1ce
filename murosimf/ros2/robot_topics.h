/// robot_topics.h - what ROS 2 nodes are told of one robot.
///
///     /NAME/joint_states             sensor_msgs/JointState, 100 Hz: all joints, as they are
///     /NAME/odom                     nav_msgs/Odometry, 50 Hz: the robot's own estimate, if it walks by the motion engine
///     /NAME/ground_truth             nav_msgs/Odometry, 50 Hz, frame `world`
///     /NAME/SENSOR                   sensor_msgs/Imu, sensor_msgs/LaserScan, geometry_msgs/WrenchStamped, by its outputs, or else
///                                    std_msgs/Float64MultiArray, one label each; at the sensor's rate
///     /NAME/CAMERA/image_raw, depth  sensor_msgs/Image: rgb8 or a Bayer mosaic; 32FC1 (REP 118)
///     /NAME/CAMERA/camera_info       sensor_msgs/CameraInfo, with each picture
///     /NAME/robot_description        std_msgs/String, kept: the robot as URDF
///
/// Rates are of simulated time. Frames are NAME/LINK, as the description names links, NAME/SENSOR, NAME/CAMERA/optical and NAME/odom (REP 105).
#pragma once

#include <string>
#include <vector>

#include "murosimf/dds/ros2/message_encoding.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/ros2/sensor_topics.h"
#include "murosimf/ros2/timer.h"
#include "murosimf/ros2/topic_outlets.h"

namespace murosimf::ros2 {

/// A robot's own estimate of its pose, and how that changes.
class OwnOdometry {
 public:
  explicit OwnOdometry(const Entity& robot);
  [[nodiscard]] bool is_there() const { return column_ != nullptr; }
  /// Of the base `truth`, whose height, roll and pitch are true: feet and IMU tell these.
  void follow(Duration now, const Transformd& truth);
  [[nodiscard]] const dds::ros2::BodyMotion& motion() const { return motion_; }

 private:
  const Column<Vec3d>* column_;
  Duration last_{-1};
  Vec3d before_;  // [m, m, rad]
  dds::ros2::BodyMotion motion_;
};

class RobotTopics {
 public:
  /// `description`: the robot as URDF; empty: there is none. Throws SetupError.
  RobotTopics(Topics topics, Entity& robot, const std::string& description);

  /// After each step. Adds its moving frames to `frames` if these are due.
  void publish(Duration now, bool frames_are_due, std::vector<dds::ros2::FramePose>& frames);
  /// Frames that do not move, of sensors and cameras.
  void add_fixed_frames(std::vector<dds::ros2::FramePose>& frames) const;

 private:
  void publish_joints(Duration now);
  void publish_motion(Duration now);
  [[nodiscard]] Transformd pose_of(const recording::RecordedEntity::Link& link) const;
  void add_frames(Duration now, std::vector<dds::ros2::FramePose>& frames) const;

  const Entity& robot_;
  std::string name_, odometry_frame_;
  std::vector<recording::RecordedEntity> recorded_;  // one
  std::vector<std::string> joint_names_;
  Timer joint_timer_, motion_timer_;
  OwnOdometry odometry_;
  TopicWriter &joints_, &truth_;
  TopicWriter* odom_ = nullptr;  // null: it has no odometry
  std::vector<SensorTopic> sensors_;
  std::vector<CameraTopic> cameras_;
  std::vector<dds::ros2::JointSample> samples_;
  Outlet outlet_;
};

}  // namespace murosimf::ros2
