/// scene_topics.h - topics of ROS 2 of a running scene, without ROS: those of its robots (robot_topics.h), and
///
///     /clock        rosgraph_msgs/Clock, 100 Hz of simulated time
///     /tf           tf2_msgs/TFMessage, 50 Hz: all links of all robots, ball and bodies; bases in NAME/odom (REP 105), or else in `world`
///     /tf_static    the same of sensors and cameras, kept for nodes that come later
///
/// Messages are encoded between two steps, if any program reads them, and sent by threads of DDS. They change no result.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/dds/participant.h"
#include "murosimf/ros2/robot_topics.h"
#include "murosimf/scene/scene.h"

namespace murosimf::ros2 {

class SceneTopics {
 public:
  /// Before the scene is initialized, which it outlives as the participant does: from its first step on. Cameras draw while their pictures are read. `say`: of
  /// robots without a description. Throws SetupError.
  SceneTopics(scene::Scene& scene, dds::Participant& participant, std::function<void(const std::string&)> say);
  SceneTopics(const SceneTopics&) = delete;  // the simulation calls back
  SceneTopics& operator=(const SceneTopics&) = delete;

 private:
  void begin();
  void look();
  void add_entities();
  [[nodiscard]] std::string description_of(const Entity& robot) const;
  void send_fixed_frames();

  scene::Scene& scene_;
  Topics topics_;
  std::function<void(const std::string&)> say_;
  std::vector<std::unique_ptr<RobotTopics>> robots_;  // by robot of the scene
  std::vector<recording::RecordedEntity> others_;     // ball and bodies
  std::size_t known_ = 0;                             // moving entities
  TopicWriter &clock_, &frames_, &fixed_frames_;
  Timer clock_timer_, frame_timer_;
  std::vector<dds::ros2::FramePose> poses_;
  Outlet outlet_;
};

}  // namespace murosimf::ros2
