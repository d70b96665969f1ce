#include "murosimf/ros2/sensor_topics.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "murosimf/model/model.h"

namespace murosimf::ros2 {

using dds::ros2::FramePose;
using dds::ros2::ros_name;
using dds::ros2::RosWriter;
using dds::ros2::Stamp;

namespace {

/// Numbers of an output; null: the sensor has none of that name and size.
const double* numbers_of(const sensors::Reading& reading, std::string_view name, std::size_t size) {
  const double* numbers = reading.values.data();
  for (const sensors::Output& output : reading.info->outputs) {
    if (output.name == name && output.size() == size) return numbers;
    numbers += output.size();
  }
  return nullptr;
}

Vec3d vector_at(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

std::vector<std::string> names_of(const sensors::Reading& reading) {
  std::vector<std::string> names;
  for (const sensors::Output& output : reading.info->outputs) {
    if (output.labels.empty()) names.push_back(output.name);
    for (const std::string& label : output.labels) names.push_back(fmt::format("{}.{}", output.name, label));
  }
  return names;
}

template <class Pixel>
std::string_view bytes_of(const imaging::Image<Pixel>& image) {
  return {reinterpret_cast<const char*>(image.pixels().data()), image.pixels().size_bytes()};
}

template <class Pixel>
dds::ros2::PictureBytes picture_of(const imaging::Image<Pixel>& image, std::string_view encoding) {
  const auto width = static_cast<std::uint32_t>(image.width());
  return {.width = width,
          .height = static_cast<std::uint32_t>(image.height()),
          .encoding = encoding,
          .step = static_cast<std::uint32_t>(width * sizeof(Pixel)),
          .bytes = bytes_of(image)};
}

std::string topic_of(const recording::RecordedCamera& camera, std::string_view what) {
  std::string topic;
  std::string_view left = std::string_view(camera.topic).substr(std::string_view("/cameras").size());
  while (!left.empty()) {
    left.remove_prefix(1);
    const std::size_t end = std::min(left.find('/'), left.size());
    topic += "/" + ros_name(left.substr(0, end));
    left.remove_prefix(end);
  }
  return fmt::format("{}/{}", topic, what);
}

}  // namespace

SensorTopic::SensorTopic(Topics topics, const recording::RecordedEntity& robot, const sensors::Reading& reading)
    : reading_(&reading), frame_(fmt::format("{}/{}", robot.name, reading.info->name)) {
  if (std::ranges::find(robot.links, frame_, &recording::RecordedEntity::Link::frame) != robot.links.end())
    frame_ += "_sensor";  // a link is called so
  const Model& model = robot.entity->model();
  const sensors::SensorInfo& info = *reading.info;
  const FixedObject mounted = model.placement(model.find_object(info.frame).value_or(0));
  link_ = robot.links[static_cast<std::size_t>(mounted.link)].frame;
  pose_ = Transformd{mounted.offset, mounted.turn} * Transformd{info.position, info.orientation};
  choose_message();
  topic_ = &topics.stream(fmt::format("/{}/{}", ros_name(robot.name), ros_name(info.name)), type_);
}

void SensorTopic::choose_message() {
  const sensors::Reading& reading = *reading_;
  const double *gyroscope = numbers_of(reading, "gyroscope", 3),
               *accelerometer = numbers_of(reading, "accelerometer", 3);
  const double *force = numbers_of(reading, "force", 3), *torque = numbers_of(reading, "torque", 3);
  const sensors::Output& first = reading.info->outputs.front();
  if (gyroscope && accelerometer) {
    type_ = "sensor_msgs/Imu";
    const double* const turn = numbers_of(reading, "orientation", 4);
    fill_ = [=](RosWriter& out, const Stamp& stamp) {
      dds::ros2::ImuSample sample{vector_at(gyroscope), vector_at(accelerometer)};
      if (turn) sample.orientation = Quaterniond{turn[0], turn[1], turn[2], turn[3]};
      write_imu(out, stamp, sample);
    };
  } else if (force && torque) {
    type_ = "geometry_msgs/WrenchStamped";
    fill_ = [=](RosWriter& out, const Stamp& stamp) { write_wrench(out, stamp, vector_at(force), vector_at(torque)); };
  } else if (first.constants.contains("fov")) {
    type_ = "sensor_msgs/LaserScan";
    const dds::ros2::LaserScan scan{.first_angle = first.constants.at("first_angle"),
                                    .fov = first.constants.at("fov"),
                                    .period = seconds(reading.info->period),
                                    .range_min = first.constants.at("range_min"),
                                    .range_max = first.constants.at("range_max"),
                                    .ranges = reading.values};
    fill_ = [scan](RosWriter& out, const Stamp& stamp) { write_scan(out, stamp, scan); };
  } else {
    type_ = "std_msgs/Float64MultiArray";
    fill_ = [names = names_of(reading), &reading](RosWriter& out, const Stamp&) {
      write_numbers(out, names, reading.values);
    };
  }
}

void SensorTopic::publish(Outlet& outlet) {
  if (reading_->samples == sent_) return;
  sent_ = reading_->samples;
  if (sent_ > 0) outlet.send(*topic_, [&](RosWriter& out) { fill_(out, {reading_->time, frame_}); });
}

FramePose SensorTopic::frame() const {
  return {.parent = link_, .child = frame_, .position = pose_.position, .orientation = from_matrix(pose_.orientation)};
}

CameraTopic::CameraTopic(Topics topics, Entity& robot, const recording::RecordedCamera& camera)
    : camera_(camera),
      frame_(sensors::offer_frames(robot, camera.shown->info->name)),
      reading_(*sensors::find_reading(robot, camera.shown->info->name)),
      calibration_(recording::distortion_of(camera.shown->info->lens)),
      info_(topics.stream(topic_of(camera, "camera_info"), "sensor_msgs/CameraInfo")),
      picture_(topics.pictures(topic_of(camera, "image_raw"), "sensor_msgs/Image")) {
  if (camera.shown->info->has_depth) depth_ = &topics.pictures(topic_of(camera, "depth"), "sensor_msgs/Image");
}

void CameraTopic::publish(Outlet& outlet) {
  frame_.asked = picture_.has_readers() || (depth_ && depth_->has_readers());
  publish_info(outlet);
  if (frame_.number == camera_.number) return;
  camera_.number = frame_.number;
  if (frame_.number == 0) return;
  const Stamp stamp{frame_.time, camera_.frame};
  if (!frame_.color.empty()) {
    outlet.send(picture_, [&](RosWriter& out) { write_image(out, stamp, picture_of(frame_.color, "rgb8")); });
  } else if (!frame_.mosaic.empty()) {
    const std::string encoding = fmt::format("bayer_{}8", frame_.info->mosaic);
    outlet.send(picture_, [&](RosWriter& out) { write_image(out, stamp, picture_of(frame_.mosaic, encoding)); });
  }
  if (depth_ && !frame_.depth.empty())
    outlet.send(*depth_, [&](RosWriter& out) { write_image(out, stamp, picture_of(frame_.depth, "32FC1")); });
}

/// With the stamp of the picture of this sample, if that is drawn.
void CameraTopic::publish_info(Outlet& outlet) {
  if (reading_.samples == sent_) return;
  sent_ = reading_.samples;
  if (sent_ == 0) return;
  const imaging::LensSpec& lens = calibration_.lens;
  outlet.send(info_, [&](RosWriter& out) {
    const std::array k{lens.fx, lens.skew, lens.cx, 0.0, lens.fy, lens.cy, 0.0, 0.0, 1.0};
    const std::array r{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    const std::array p{lens.fx, lens.skew, lens.cx, 0.0, 0.0, lens.fy, lens.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
    write_camera_info(out, {reading_.time, camera_.frame},
                      {.width = static_cast<std::uint32_t>(lens.width),
                       .height = static_cast<std::uint32_t>(lens.height),
                       .model = calibration_.model,
                       .d = calibration_.coefficients,
                       .k = k,
                       .r = r,
                       .p = p});
  });
}

FramePose CameraTopic::frame() const {
  const sensors::CameraInfo& info = *camera_.shown->info;
  return {.parent = camera_.link,
          .child = camera_.frame,
          .position = info.position,
          .orientation = from_matrix(info.orientation)};
}

}  // namespace murosimf::ros2
