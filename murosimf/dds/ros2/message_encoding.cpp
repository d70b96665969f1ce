#include "murosimf/dds/ros2/message_encoding.h"

#include <cmath>

namespace murosimf::dds::ros2 {
namespace {

constexpr int matrix = 9, pose_covariance = 36;

std::uint32_t count_of(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// All zeros: unknown; the first one -1: the quantity is not measured (sensor_msgs/Imu).
void put_covariance(RosWriter& out, double first, int size) {
  out.f64(first);
  for (int i = 1; i < size; ++i) out.f64(0);
}

void put(RosWriter& out, const Stamp& stamp) { out.header(stamp.time, stamp.frame); }

void put(RosWriter& out, std::span<const double> numbers, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.f64(i < numbers.size() ? numbers[i] : 0);
}

void put_joints(RosWriter& out, std::span<const JointSample> joints, double JointSample::*number, bool known) {
  for (const JointSample& joint : joints) known = known && !std::isnan(joint.*number);
  out.u32(known ? count_of(joints.size()) : 0);
  if (!known) return;
  for (const JointSample& joint : joints) out.f64(joint.*number);
}

}  // namespace

void write_joint_state(RosWriter& out, const Stamp& stamp, std::span<const JointSample> joints, bool measured) {
  put(out, stamp);
  out.u32(count_of(joints.size()));
  for (const JointSample& joint : joints) out.text(joint.name);
  put_joints(out, joints, &JointSample::position, true);
  put_joints(out, joints, &JointSample::velocity, measured);
  put_joints(out, joints, &JointSample::effort, measured);
}

void write_transforms(RosWriter& out, std::span<const FramePose> all) {
  out.u32(count_of(all.size()));
  for (const FramePose& one : all) {
    out.header(one.time, one.parent);
    out.text(one.child);
    out.vector(one.position);
    out.quaternion(one.orientation);
  }
}

void write_imu(RosWriter& out, const Stamp& stamp, const ImuSample& sample) {
  put(out, stamp);
  out.quaternion(sample.orientation.value_or(Quaterniond{1, 0, 0, 0}));
  put_covariance(out, sample.orientation ? 0 : -1, matrix);
  out.vector(sample.gyroscope);
  put_covariance(out, 0, matrix);
  out.vector(sample.accelerometer);
  put_covariance(out, 0, matrix);
}

void write_wrench(RosWriter& out, const Stamp& stamp, const Vec3d& force, const Vec3d& torque) {
  put(out, stamp);
  out.vector(force);
  out.vector(torque);
}

void write_scan(RosWriter& out, const Stamp& stamp, const LaserScan& scan) {
  put(out, stamp);
  const std::size_t rays = scan.ranges.size();
  out.f32(scan.first_angle);
  out.f32(scan.first_angle + scan.fov);
  out.f32(rays > 1 ? scan.fov / static_cast<double>(rays - 1) : 0);
  out.f32(0);
  out.f32(scan.period);
  out.f32(scan.range_min);
  out.f32(scan.range_max);
  out.u32(count_of(rays));
  for (const double range : scan.ranges) out.f32(range);
  out.u32(0);  // no intensities
}

void write_numbers(RosWriter& out, std::span<const std::string> names, std::span<const double> values) {
  out.u32(count_of(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    out.text(names[i]);
    out.u32(1);
    out.u32(count_of(names.size() - i));
  }
  out.u32(0);
  out.u32(count_of(values.size()));
  for (const double value : values) out.f64(value);
}

void write_image(RosWriter& out, const Stamp& stamp, const PictureBytes& picture) {
  put(out, stamp);
  out.u32(picture.height);
  out.u32(picture.width);
  out.text(picture.encoding);
  out.u8(0);  // little endian
  out.u32(picture.step);
  out.bytes(picture.bytes);
}

void write_compressed_image(RosWriter& out, const Stamp& stamp, std::string_view format, std::string_view bytes) {
  put(out, stamp);
  out.text(format);
  out.bytes(bytes);
}

void write_camera_info(RosWriter& out, const Stamp& stamp, const CameraCalibration& calibration) {
  constexpr std::size_t square = 9, projection = 12;
  put(out, stamp);
  out.u32(calibration.height);
  out.u32(calibration.width);
  out.text(calibration.model == "kannala_brandt" ? "equidistant" : calibration.model);
  out.u32(count_of(calibration.d.size()));
  put(out, calibration.d, calibration.d.size());
  put(out, calibration.k, square);
  put(out, calibration.r, square);
  put(out, calibration.p, projection);
  for (int i = 0; i < 6; ++i) out.u32(0);
  out.boolean(false);
}

void write_odometry(RosWriter& out, const Stamp& stamp, std::string_view child, const BodyMotion& motion) {
  put(out, stamp);
  out.text(child);
  out.vector(motion.pose.position);
  out.quaternion(from_matrix(motion.pose.orientation));
  put_covariance(out, 0, pose_covariance);
  out.vector(motion.linear);
  out.vector(motion.angular);
  put_covariance(out, 0, pose_covariance);
}

void write_log(RosWriter& out, Duration time, bool warning, std::string_view name, std::string_view text) {
  constexpr std::uint8_t info = 20, warn = 30;  // rcl_interfaces/Log
  out.time(time);
  out.u8(warning ? warn : info);
  out.text(name);
  out.text(text);
  out.text("");
  out.text("");
  out.u32(0);
}

void write_clock(RosWriter& out, Duration time) { out.time(time); }

void write_string(RosWriter& out, std::string_view text) { out.text(text); }

}  // namespace murosimf::dds::ros2
