/// ros_messages.h - messages of recordings, which are Foxglove's, as those of ROS 2.
///
///     /tf, /cameras/tf                  /tf                            tf2_msgs/TFMessage
///     /joints, /targets                 /ROBOT/joint_states, /ROBOT/joint_targets     sensor_msgs/JointState, names without the robot's
///     /sensors/ROBOT/SENSOR             /ROBOT/SENSOR                  sensor_msgs/Imu, LaserScan, geometry_msgs/WrenchStamped, by its outputs, or else
///                                       std_msgs/Float64MultiArray, one label each
///     /cameras/ROBOT/CAMERA/image       /ROBOT/CAMERA/image/compressed  sensor_msgs/CompressedImage
///     .../depth, .../labels             /ROBOT/CAMERA/depth, labels    sensor_msgs/Image (16UC1)
///     .../calibration                   /ROBOT/CAMERA/camera_info      sensor_msgs/CameraInfo
///     /scene, /contact_forces, /drawings/...    the same               visualization_msgs/MarkerArray
///     /events, /warnings                /rosout                        rcl_interfaces/Log
///
/// Names become those that ROS allows: '_' for other characters, and before a digit.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/dds/ros2/ros_names.h"
#include "murosimf/recording/mcap/mcap_records.h"
#include "murosimf/recording/robot_urdf.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

struct RosMessage {
  std::string topic, type;  ///< "/tf", "tf2_msgs/TFMessage"
  std::string data;         ///< CDR
  bool kept = false;        ///< transient local: for nodes that come later
};

/// A converter has memory: markers that a later message does not contain are deleted.
class RosMessages {
 public:
  /// `names`: of frames.
  explicit RosMessages(FrameNames names = {}) : names_(std::move(names)) {}
  /// Of a message of this channel. Empty: ROS has nothing like it. Throws SetupError: the message is damaged.
  [[nodiscard]] std::vector<RosMessage> of(const Channel& channel, std::string_view data, Duration time);
  /// Whether messages of this channel are converted.
  [[nodiscard]] static bool converts(const Channel& channel);

 private:
  [[nodiscard]] RosMessage markers(const std::string& topic, std::string_view data);

  std::map<std::string, std::map<std::string, int>> markers_;  // by topic and namespace: how many are shown
  FrameNames names_;
};

/// rosgraph_msgs/Clock.
[[nodiscard]] RosMessage ros_clock(Duration time);

/// std_msgs/String, kept, of the robot of this name.
[[nodiscard]] RosMessage ros_description(const std::string& robot, const std::string& urdf);

using dds::ros2::ros_name;

}  // namespace murosimf::recording
