/// message_encoding.h - messages of ROS 2, encoded: those of live topics, and those of bags (recording/rosbag2).
///
/// Fields and their order are those of ROS 2's interface packages (common_interfaces, geometry2, rcl_interfaces), which did not change from
/// Humble to Jazzy. Units and axes by ROS REP 103: SI, x forward, y left, z up; optical frames z forward, x right, y down.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/dds/ros2/ros_writer.h"
#include "murosimf/math/transform.h"

namespace murosimf::dds::ros2 {

/// std_msgs/Header
struct Stamp {
  Duration time{};  ///< simulated
  std::string_view frame{};
};

struct JointSample {
  std::string_view name;
  double position = 0, velocity = 0, effort = 0;  ///< [rad | m], [rad/s | m/s], [N m | N]; NaN: unknown
};
/// sensor_msgs/JointState. Arrays are as long as the names, or empty where a number of one joint is unknown. `measured`: false for targets, which
/// have positions alone.
void write_joint_state(RosWriter& out, const Stamp& stamp, std::span<const JointSample> joints, bool measured = true);

struct FramePose {
  Duration time{};
  std::string_view parent, child;
  Vec3d position;  ///< [m] of the child's origin in the parent
  Quaterniond orientation{1, 0, 0, 0};
};
/// tf2_msgs/TFMessage
void write_transforms(RosWriter& out, std::span<const FramePose> all);

/// In axes of the sensor.
struct ImuSample {
  Vec3d gyroscope, accelerometer;            ///< [rad/s], [m/s^2] with gravity
  std::optional<Quaterniond> orientation{};  ///< its axes to those of the world; nothing: not measured
};
/// sensor_msgs/Imu, by REP 145; covariances are unknown.
void write_imu(RosWriter& out, const Stamp& stamp, const ImuSample& sample);

/// geometry_msgs/WrenchStamped [N], [N m]
void write_wrench(RosWriter& out, const Stamp& stamp, const Vec3d& force, const Vec3d& torque);

struct LaserScan {
  double first_angle = 0, fov = 0;      ///< [rad] from x towards y: of the first ray, and on to the last
  double period = 0;                    ///< [s] between two scans
  double range_min = 0, range_max = 0;  ///< [m]
  std::span<const double> ranges;       ///< [m] REP 117: +infinity: nothing, -infinity: too near
};
/// sensor_msgs/LaserScan: all rays of one instant.
void write_scan(RosWriter& out, const Stamp& stamp, const LaserScan& scan);

/// std_msgs/Float64MultiArray with a dimension for each number, whose label is its name.
void write_numbers(RosWriter& out, std::span<const std::string> names, std::span<const double> values);

struct PictureBytes {
  std::uint32_t width = 0, height = 0;  ///< [px]
  std::string_view encoding;            ///< "rgb8", "16UC1" (sensor_msgs/image_encodings.hpp)
  std::uint32_t step = 0;               ///< [byte] of a row
  std::string_view bytes;               ///< little endian, rows from the top
};
/// sensor_msgs/Image
void write_image(RosWriter& out, const Stamp& stamp, const PictureBytes& picture);
/// sensor_msgs/CompressedImage
void write_compressed_image(RosWriter& out, const Stamp& stamp, std::string_view format, std::string_view bytes);

struct CameraCalibration {
  std::uint32_t width = 0, height = 0;  ///< [px]
  std::string_view model;               ///< of the distortion; "kannala_brandt" is "equidistant" in ROS
  std::span<const double> d, k, r, p;   ///< coefficients; 3 by 3, 3 by 3, 3 by 4: zeros where there are fewer numbers
};
/// sensor_msgs/CameraInfo: no binning, all of the picture.
void write_camera_info(RosWriter& out, const Stamp& stamp, const CameraCalibration& calibration);

struct BodyMotion {
  Transformd pose;        ///< of the child in the frame of the stamp
  Vec3d linear, angular;  ///< [m/s], [rad/s] in axes of the child
};
/// nav_msgs/Odometry, by REP 105; covariances are unknown.
void write_odometry(RosWriter& out, const Stamp& stamp, std::string_view child, const BodyMotion& motion);

/// rcl_interfaces/Log
void write_log(RosWriter& out, Duration time, bool warning, std::string_view name, std::string_view text);
/// rosgraph_msgs/Clock
void write_clock(RosWriter& out, Duration time);
/// std_msgs/String
void write_string(RosWriter& out, std::string_view text);

}  // namespace murosimf::dds::ros2
