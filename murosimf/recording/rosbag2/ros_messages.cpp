#include "murosimf/recording/rosbag2/ros_messages.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/transform.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "murosimf/recording/rosbag2/cdr_writer.h"
#include "murosimf/recording/rosbag2/ros_markers.h"

namespace murosimf::recording {
namespace {

/// 3 by 3 numbers; all zeros: unknown, the first one -1: the quantity is not measured (sensor_msgs/Imu).
void put_covariance(CdrWriter& out, double first) {
  out.f64(first);
  for (int i = 1; i < 9; ++i) out.f64(0);
}

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

RosMessage transforms(std::string_view data) {
  std::uint32_t count = 0;
  CdrWriter out;
  out.u32(count);
  for (ProtobufReader all(data); all.next();) {
    if (all.field() != 1) continue;
    Duration time{};
    std::string_view parent, child;
    Vec3d place;
    Quaterniond turn{1, 0, 0, 0};
    for (ProtobufReader in = all.message(); in.next();) {
      if (in.field() == 1) time = read_time(in.message());
      if (in.field() == 2) parent = in.bytes();
      if (in.field() == 3) child = in.bytes();
      if (in.field() == 4) place = read_vector(in.message());
      if (in.field() == 5) turn = from_matrix(read_rotation(in.message()));
    }
    out.header(time, parent);
    out.text(child);
    out.vector(place);
    out.quaternion(turn);
    ++count;
  }
  return {"/tf", "tf2_msgs/TFMessage", out.with_count(count)};
}

struct JointSample {
  std::string_view name;
  double position = 0, velocity = 0, effort = std::nan("");
};

/// A message for each robot. Arrays are as long as the names, or empty where a number of one joint is missing.
std::vector<RosMessage> joints(std::string_view data, const std::string& name, bool measured) {
  std::map<std::string_view, std::vector<JointSample>> robots;
  std::vector<std::string_view> order;
  Duration time{};
  for (ProtobufReader all(data); all.next();) {
    if (all.field() == 1) time = read_time(all.message());
    if (all.field() != 2) continue;
    JointSample joint{.name = {}, .position = std::nan("")};
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
    const std::vector<JointSample>& all = robots[robot];
    CdrWriter out;
    out.header(time, "");
    out.u32(static_cast<std::uint32_t>(all.size()));
    for (const JointSample& joint : all) out.text(joint.name);
    const auto put = [&](double JointSample::*number, bool known) {
      for (const JointSample& joint : all) known = known && !std::isnan(joint.*number);
      out.u32(known ? static_cast<std::uint32_t>(all.size()) : 0);
      if (!known) return;
      for (const JointSample& joint : all) out.f64(joint.*number);
    };
    put(&JointSample::position, true);
    put(&JointSample::velocity, measured);
    put(&JointSample::effort, measured);
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
};

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
  CdrWriter out;
  const double *gyroscope = sample.vector("gyroscope"), *accelerometer = sample.vector("accelerometer");
  if (gyroscope && accelerometer) {
    out.header(sample.time, frame);
    out.quaternion({1, 0, 0, 0});
    put_covariance(out, -1);
    out.vector(vector_at(gyroscope));
    put_covariance(out, 0);
    out.vector(vector_at(accelerometer));
    put_covariance(out, 0);
    return {topic, "sensor_msgs/Imu", out.message()};
  }
  const double *force = sample.vector("force"), *torque = sample.vector("torque");
  if (force && torque) {
    out.header(sample.time, frame);
    out.vector(vector_at(force));
    out.vector(vector_at(torque));
    return {topic, "geometry_msgs/WrenchStamped", out.message()};
  }
  out.u32(static_cast<std::uint32_t>(sample.names.size()));
  for (std::size_t i = 0; i < sample.names.size(); ++i) {
    out.text(sample.names[i]);
    out.u32(1);
    out.u32(static_cast<std::uint32_t>(sample.names.size() - i));
  }
  out.u32(0);
  out.u32(static_cast<std::uint32_t>(sample.values.size()));
  for (const double value : sample.values) out.f64(value);
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
  CdrWriter out;
  out.header(time, frame);
  out.text(format);
  out.bytes(bytes);
  return {topic, "sensor_msgs/CompressedImage", out.message()};
}

RosMessage image(const std::string& topic, std::string_view data) {
  Duration time{};
  std::string_view frame, encoding, bytes;
  std::uint32_t width = 0, height = 0, step = 0;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) width = in.fixed32();
    if (in.field() == 3) height = in.fixed32();
    if (in.field() == 4) encoding = in.bytes();
    if (in.field() == 5) step = in.fixed32();
    if (in.field() == 6) bytes = in.bytes();
    if (in.field() == 7) frame = in.bytes();
  }
  CdrWriter out;
  out.header(time, frame);
  out.u32(height);
  out.u32(width);
  out.text(encoding);
  out.u8(0);  // little endian
  out.u32(step);
  out.bytes(bytes);
  return {topic, "sensor_msgs/Image", out.message()};
}

/// `count` numbers of a packed field, zeros where it has fewer.
void put_numbers(CdrWriter& out, std::string_view packed, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    double value = 0;
    if ((i + 1) * sizeof value <= packed.size()) std::memcpy(&value, packed.data() + i * sizeof value, sizeof value);
    out.f64(value);
  }
}

RosMessage camera_info(const std::string& topic, std::string_view data) {
  Duration time{};
  std::string_view frame, model, d, k, r, p;
  std::uint32_t width = 0, height = 0;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) width = in.fixed32();
    if (in.field() == 3) height = in.fixed32();
    if (in.field() == 4) model = in.bytes();
    if (in.field() == 5) d = in.bytes();
    if (in.field() == 6) k = in.bytes();
    if (in.field() == 7) r = in.bytes();
    if (in.field() == 8) p = in.bytes();
    if (in.field() == 9) frame = in.bytes();
  }
  CdrWriter out;
  out.header(time, frame);
  out.u32(height);
  out.u32(width);
  out.text(model == "kannala_brandt" ? "equidistant" : model);  // ROS's word for the same
  out.u32(static_cast<std::uint32_t>(d.size() / sizeof(double)));
  put_numbers(out, d, d.size() / sizeof(double));
  put_numbers(out, k, 9);
  put_numbers(out, r, 9);
  put_numbers(out, p, 12);
  for (int i = 0; i < 6; ++i) out.u32(0);  // no binning, all of the picture
  out.boolean(false);
  return {topic, "sensor_msgs/CameraInfo", out.message()};
}

RosMessage log_line(std::string_view data) {
  constexpr std::uint64_t foxglove_warning = 3;
  constexpr std::uint8_t info = 20, warning = 30;  // rcl_interfaces/Log
  Duration time{};
  std::uint64_t level = 0;
  std::string_view text, name;
  for (ProtobufReader in(data); in.next();) {
    if (in.field() == 1) time = read_time(in.message());
    if (in.field() == 2) level = in.varint();
    if (in.field() == 3) text = in.bytes();
    if (in.field() == 4) name = in.bytes();
  }
  CdrWriter out;
  out.time(time);
  out.u8(level >= foxglove_warning ? warning : info);
  out.text(name);
  out.text(text);
  out.text("");
  out.text("");
  out.u32(0);
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

std::string ros_name(std::string_view name) {
  std::string allowed(name);
  for (char& c : allowed) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  if (allowed.empty() || std::isdigit(static_cast<unsigned char>(allowed.front())) != 0) allowed.insert(0, "_");
  return allowed;
}

RosMessage ros_clock(Duration time) {
  CdrWriter out;
  out.time(time);
  return {"/clock", "rosgraph_msgs/Clock", out.message()};
}

bool RosMessages::converts(const Channel& channel) {
  return channel.topic == "/tf" || channel.topic == "/cameras/tf" || channel.topic == "/joints" ||
         channel.topic == "/targets" || channel.topic == "/events" || channel.topic == "/warnings" ||
         channel.topic.starts_with("/sensors/") || is_camera(channel) || is_scene(channel);
}

std::vector<RosMessage> RosMessages::of(const Channel& channel, std::string_view data, Duration time) {
  const std::string& topic = channel.topic;
  if (topic == "/tf") return {ros_clock(time), transforms(data)};
  if (topic == "/cameras/tf") return {transforms(data)};
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
  return {name, "visualization_msgs/MarkerArray", ros_markers(data, markers_[topic])};
}

}  // namespace murosimf::recording
