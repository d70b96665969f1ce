/// topic_outlets.h - topics of ROS 2 that are written, by name and type, in a participant.
///
/// Quality of service as nodes expect it: reliable, the last ten messages (rmw_qos_profile_default); what is said once is kept for nodes that come later
/// (transient local, 1); pictures are reliable, too, with fewer kept, since single fragments of them are lost otherwise.
#pragma once

#include <string>

#include "murosimf/dds/participant.h"
#include "murosimf/dds/ros2/ros_names.h"
#include "murosimf/dds/ros2/ros_writer.h"

namespace murosimf::ros2 {

using dds::TopicWriter;

class Topics {
 public:
  explicit Topics(dds::Participant& participant) : participant_(participant) {}

  // Of "/blue1/imu", "sensor_msgs/Imu". Throw SetupError.
  [[nodiscard]] TopicWriter& stream(const std::string& topic, const std::string& type) {
    return participant_.writer(
        {.name = dds::ros2::topic_name(topic), .type = dds::ros2::type_name(type), .reliable = true, .depth = 10});
  }
  [[nodiscard]] TopicWriter& pictures(const std::string& topic, const std::string& type) {
    return participant_.writer({.name = dds::ros2::topic_name(topic),
                                .type = dds::ros2::type_name(type),
                                .reliable = true,
                                .large = true,
                                .depth = 2});
  }
  [[nodiscard]] TopicWriter& latched(const std::string& topic, const std::string& type) {
    return participant_.writer({.name = dds::ros2::topic_name(topic),
                                .type = dds::ros2::type_name(type),
                                .reliable = true,
                                .kept = true,
                                .large = true,
                                .depth = 1});
  }

 private:
  dds::Participant& participant_;
};

/// Encodes by `fill(RosWriter&)` and sends, if anyone reads it.
class Outlet {
 public:
  template <class Fill>
  void send(TopicWriter& topic, const Fill& fill) {
    if (!topic.has_readers()) return;
    send_always(topic, fill);
  }
  template <class Fill>
  void send_always(TopicWriter& topic, const Fill& fill) {
    message_.clear();
    fill(message_);
    topic.write(message_.encoded());
  }

 private:
  dds::ros2::RosWriter message_;  // memory
};

}  // namespace murosimf::ros2
