#include "murosimf/recording/rosbag2/ros_messages.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/dds/ros2/message_encoding.h"
#include "murosimf/math/transform.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/rosbag2/ros_markers.h"

namespace murosimf::recording {
namespace {

using dds::ros2::FramePose;
using dds::ros2::JointSample;
using dds::ros2::LaserScan;
using dds::ros2::RosWriter;
using dds::ros2::Stamp;

/// The parts of a topic behind a prefix: "/cameras/blue1/camera/image" without "/cameras/" are "blue1", "camera" and "image".
std::vector<std::string> parts_of(std::string_view topic, std::string_view prefix) {
  std::vector<std::string> parts;
  for (std::string_view left = topic.substr(prefix.size()); !left.empty();) {
    const std::size_t end = std::min(left.find('/'), left.size());
    parts.push_back(ros_name(left.substr(0, end)));
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return parts;
}

std::string_view named(std::string_view frame, const FrameNames& names) {
  const auto found = names.find(frame);
  return found == names.end() ? frame : std::string_view(found->second);
}

RosMessage transforms(std::string_view data, const FrameNames& names) {
  std::vector<FramePose> poses;
  for (ProtobufReader all(data); all.next();) {
    if (all.field() != 1) continue;
    FramePose pose;
    for (ProtobufReader in = all.message(); in.next();) {
      if (in.field() == 1) pose.time = read_time(in.message());
      if (in.field() == 2) pose.parent = named(in.bytes(), names);
      if (in.field() == 3) pose.child = named(in.bytes(), names);
      if (in.field() == 4) pose.position = read_vector(in.message());
      if (in.field() == 5) pose.orientation = from_matrix(read_rotation(in.message()));
    }
    poses.push_back(pose);
  }
  RosWriter out;
  write_transforms(out, poses);
  return {"/tf", "tf2_msgs/TFMessage", out.message()};
}

/// A message for each robot. Arrays are as long as the names, or empty where a number of one joint is missing.
std::vector<RosMessage> joints(std::string_view data, const std::string& name, bool measured) {
  std::map<std::string_view, std::vector<JointSample>> robots;
  std::vector<std::string_view> order;
  Duration time{};
  for (ProtobufReader all(data); all.next();) {
    if (all.field() == 1) time = read_time(all.message());
    if (all.field() != 2) continue;
    JointSample joint{.name = {}, .position = std::nan(""), .effort = std::nan("")};
    for (ProtobufReader in = all.message(); in.next();) {
      if (in.field() == 1) joint.name = in.bytes();
      if (in.field() == 2) joint.position = in.number();
      if (in.field() == 3) joint.velocity = in.number();
      if (in.field() == 5) joint.effort = in.number();
    }
    const std::size_t slash = joint.name.find('/');
    if (slash == std::string_view::npos) continue;
    const std::string_view robot = joint.name.substr(0, slash);
    joint.name.remove_prefix(slash + 1);
    if (!robots.contains(robot)) order.push_back(robot);
    robots[robot].push_back(joint);
  }
  std::vector<RosMessage> messages;
  for (const std::string_view robot : order) {
    RosWriter out;
    write_joint_state(out, {time, ""}, robots[robot], measured);
    messages.push_back({fmt::format("/{}/{}", ros_name(robot), name), "sensor_msgs/JointState", out.message()});
  }
  return messages;
}

/// Numbers of a sensor by their names in logs, "gyroscope.x [rad/s]", in the order of the message.
struct SensorNumbers {
  Duration time{};
  std::vector<std::string> names;
  std::vector<double> values;

  /// Null: there is no such output with x, y and z.
  [[nodiscard]] const double* vector(std::string_view output) const {
    for (std::size_t i = 0; i + 2 < names.size(); ++i) {
      if (names[i].starts_with(fmt::format("{}.x", output)) && names[i + 1].starts_with(fmt::format("{}.y", output)) &&
          names[i + 2].starts_with(fmt::format("{}.z", output)))
        return &values[i];
    }
    return nullptr;
  }
  /// w, x, y, z
  [[nodiscard]] std::optional<Quaterniond> orientation() const {
    for (std::size_t i = 0; i + 3 < names.size(); ++i) {
      if (names[i].starts_with("orientation.w"))
        return Quaterniond{values[i], values[i + 1], values[i + 2], values[i + 3]};
    }
    return std::nullopt;
  }
};

/// Of channels of lasers (sensors/reading.h, Output::constants).
std::optional<LaserScan> scan_of(const Channel& channel, const SensorNumbers& sample) {
  const auto constant = [&](const std::string& name) {
    const auto found = channel.metadata.find(name);
    return found == channel.metadata.end() ? std::nan("") : std::strtod(found->second.c_str(), nullptr);
  };
  const LaserScan scan{.first_angle = constant("ranges.first_angle"),
                       .fov = constant("ranges.fov"),
                       .period = constant("period"),
                       .range_min = constant("ranges.range_min"),
                       .range_max = constant("ranges.range_max"),
                       .ranges = sample.values};
  if (std::isnan(scan.first_angle) || std::isnan(scan.fov)) return std::nullopt;
  return scan;
}

/// Fields of zeros are not in the message: there are as many numbers as names.
SensorNumbers sensor_numbers(const Channel& channel, std::string_view data) {
  std::map<int, std::vector<double>> fields;
  SensorNumbers sample;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) {
      sample.time = read_time(in.message());
    } else if (const auto name = channel.metadata.find(std::to_string(in.field()));
               name != channel.metadata.end() && name->second.find('\n') != std::string::npos) {
      const std::string_view packed = in.bytes();
      std::vector<double>& numbers = fields[in.field()];
      numbers.resize(packed.size() / sizeof(double));
      std::memcpy(numbers.data(), packed.data(), numbers.size() * sizeof(double));
    } else {
      fields[in.field()] = {in.number()};
    }
  }
  constexpr int first = 2;
  for (int field = first; channel.metadata.contains(std::to_string(field)); ++field) {
    const std::string& all = channel.metadata.at(std::to_string(field));
    const std::vector<double>& numbers = fields[field];
    std::size_t k = 0;
    for (std::string_view left = all; k == 0 || !left.empty(); ++k) {
      const std::size_t end = std::min(left.find('\n'), left.size());
      sample.names.emplace_back(left.substr(0, end));
      sample.values.push_back(k < numbers.size() ? numbers[k] : 0);
      left.remove_prefix(std::min(end + 1, left.size()));
    }
  }
  return sample;
}

Vec3d vector_at(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

RosMessage sensor(const Channel& channel, std::string_view data) {
  constexpr std::string_view prefix = "/sensors/";
  const SensorNumbers sample = sensor_numbers(channel, data);
  const std::string topic = fmt::format("/{}", fmt::join(parts_of(channel.topic, prefix), "/"));
  const std::string frame = channel.topic.substr(prefix.size());
  RosWriter out;
  const Stamp stamp{sample.time, frame};
  const double *gyroscope = sample.vector("gyroscope"), *accelerometer = sample.vector("accelerometer");
  if (gyroscope && accelerometer) {
    write_imu(out, stamp, {vector_at(gyroscope), vector_at(accelerometer), sample.orientation()});
    return {topic, "sensor_msgs/Imu", out.message()};
  }
  const double *force = sample.vector("force"), *torque = sample.vector("torque");
  if (force && torque) {
    write_wrench(out, stamp, vector_at(force), vector_at(torque));
    return {topic, "geometry_msgs/WrenchStamped", out.message()};
  }
  if (const auto scan = scan_of(channel, sample)) {
    write_scan(out, stamp, *scan);
    return {topic, "sensor_msgs/LaserScan", out.message()};
  }
  write_numbers(out, sample.names, sample.values);
  return {topic, "std_msgs/Float64MultiArray", out.message()};
}

RosMessage compressed_image(const std::string& topic, std::string_view data) {
  Duration time{};
  std::string_view frame, format, bytes;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) bytes = in.bytes();
    if (in.field() == 3) format = in.bytes();
    if (in.field() == 4) frame = in.bytes();
  }
  RosWriter out;
  write_compressed_image(out, {time, frame}, format, bytes);
  return {topic, "sensor_msgs/CompressedImage", out.message()};
}

RosMessage image(const std::string& topic, std::string_view data) {
  Duration time{};
  std::string_view frame;
  dds::ros2::PictureBytes picture;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) picture.width = in.fixed32();
    if (in.field() == 3) picture.height = in.fixed32();
    if (in.field() == 4) picture.encoding = in.bytes();
    if (in.field() == 5) picture.step = in.fixed32();
    if (in.field() == 6) picture.bytes = in.bytes();
    if (in.field() == 7) frame = in.bytes();
  }
  RosWriter out;
  write_image(out, {time, frame}, picture);
  return {topic, "sensor_msgs/Image", out.message()};
}

/// Numbers of a packed field.
std::vector<double> numbers_in(std::string_view packed) {
  std::vector<double> numbers(packed.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), packed.data(), numbers.size() * sizeof(double));
  return numbers;
}

RosMessage camera_info(const std::string& topic, std::string_view data) {
  Duration time{};
  std::string_view frame;
  std::vector<double> d, k, r, p;
  dds::ros2::CameraCalibration told;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) told.width = in.fixed32();
    if (in.field() == 3) told.height = in.fixed32();
    if (in.field() == 4) told.model = in.bytes();
    if (in.field() == 5) d = numbers_in(in.bytes());
    if (in.field() == 6) k = numbers_in(in.bytes());
    if (in.field() == 7) r = numbers_in(in.bytes());
    if (in.field() == 8) p = numbers_in(in.bytes());
    if (in.field() == 9) frame = in.bytes();
  }
  told.d = d;
  told.k = k;
  told.r = r;
  told.p = p;
  RosWriter out;
  write_camera_info(out, {time, frame}, told);
  return {topic, "sensor_msgs/CameraInfo", out.message()};
}

RosMessage log_line(std::string_view data) {
  constexpr std::uint64_t foxglove_warning = 3;
  Duration time{};
  std::uint64_t level = 0;
  std::string_view text, name;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) level = in.varint();
    if (in.field() == 3) text = in.bytes();
    if (in.field() == 4) name = in.bytes();
  }
  RosWriter out;
  write_log(out, time, level >= foxglove_warning, name, text);
  return {"/rosout", "rcl_interfaces/Log", out.message()};
}

RosMessage camera(const std::string& topic, std::string_view data) {
  const std::vector<std::string> parts = parts_of(topic, "/cameras/");
  const std::string stem = fmt::format("/{}", fmt::join(parts.begin(), parts.end() - 1, "/"));
  if (parts.back() == "image") return compressed_image(stem + "/image/compressed", data);
  if (parts.back() == "calibration") return camera_info(stem + "/camera_info", data);
  return image(fmt::format("{}/{}", stem, parts.back()), data);
}

bool is_camera(const Channel& channel) {
  return channel.topic.starts_with("/cameras/") &&
         (channel.topic.ends_with("/image") || channel.topic.ends_with("/depth") ||
          channel.topic.ends_with("/labels") || channel.topic.ends_with("/calibration"));
}

bool is_scene(const Channel& channel) {
  return channel.topic == "/scene" || channel.topic == "/contact_forces" || channel.topic.starts_with("/drawings/");
}

}  // namespace

RosMessage ros_clock(Duration time) {
  RosWriter out;
  write_clock(out, time);
  return {"/clock", "rosgraph_msgs/Clock", out.message()};
}

RosMessage ros_description(const std::string& robot, const std::string& urdf) {
  RosWriter out;
  out.text(urdf);
  return {fmt::format("/{}/robot_description", ros_name(robot)), "std_msgs/String", out.message(), true};
}

bool RosMessages::converts(const Channel& channel) {
  return channel.topic == "/tf" || channel.topic == "/cameras/tf" || channel.topic == "/joints" ||
         channel.topic == "/targets" || channel.topic == "/events" || channel.topic == "/warnings" ||
         channel.topic.starts_with("/sensors/") || is_camera(channel) || is_scene(channel);
}

std::vector<RosMessage> RosMessages::of(const Channel& channel, std::string_view data, Duration time) {
  const std::string& topic = channel.topic;
  if (topic == "/tf") return {ros_clock(time), transforms(data, names_)};
  if (topic == "/cameras/tf") return {transforms(data, names_)};
  if (topic == "/joints") return joints(data, "joint_states", true);
  if (topic == "/targets") return joints(data, "joint_targets", false);
  if (topic == "/events" || topic == "/warnings") return {log_line(data)};
  if (topic.starts_with("/sensors/")) return {sensor(channel, data)};
  if (is_camera(channel)) return {camera(topic, data)};
  if (is_scene(channel)) return {markers(topic, data)};
  return {};
}

RosMessage RosMessages::markers(const std::string& topic, std::string_view data) {
  const std::string name = topic.starts_with("/drawings/")
                               ? fmt::format("/drawings/{}", fmt::join(parts_of(topic, "/drawings/"), "/"))
                               : topic;
  return {name, "visualization_msgs/MarkerArray", ros_markers(data, markers_[topic], names_)};
}

}  // namespace murosimf::recording
