/// sensor_topics.h - topics of a robot's sensors and cameras (robot_topics.h): new samples and pictures are sent once.
///
/// A camera draws only while some program reads its pictures; what it is (camera_info) is sent for every sample.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "murosimf/dds/ros2/message_encoding.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/ros2/topic_outlets.h"
#include "murosimf/sensors/reading.h"
#include "murosimf/world/entity.h"

namespace murosimf::ros2 {

class SensorTopic {
 public:
  /// `robot`: with the frames of its links, in the order of its tree.
  SensorTopic(Topics topics, const recording::RecordedEntity& robot, const sensors::Reading& reading);
  void publish(Outlet& outlet);
  [[nodiscard]] dds::ros2::FramePose frame() const;

 private:
  using Fill = std::function<void(dds::ros2::RosWriter&, const dds::ros2::Stamp&)>;
  void choose_message();

  const sensors::Reading* reading_;
  std::uint64_t sent_ = 0;  // samples
  std::string frame_, link_;
  Transformd pose_;  // on the link
  std::string type_;
  Fill fill_;
  TopicWriter* topic_ = nullptr;
};

class CameraTopic {
 public:
  CameraTopic(Topics topics, Entity& robot, const recording::RecordedCamera& camera);
  /// It draws from the next step on if its pictures or depths have readers.
  void publish(Outlet& outlet);
  [[nodiscard]] dds::ros2::FramePose frame() const;

 private:
  void publish_info(Outlet& outlet);

  recording::RecordedCamera camera_;
  sensors::CameraFrame& frame_;
  const sensors::Reading& reading_;
  std::uint64_t sent_ = 0;  // calibrations, by sample
  recording::Distortion calibration_;
  TopicWriter &info_, &picture_;
  TopicWriter* depth_ = nullptr;  // null: it sees none
};

}  // namespace murosimf::ros2
