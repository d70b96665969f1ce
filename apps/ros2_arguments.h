/// ros2_arguments.h - the options of a run that nodes of ROS 2 take part in (ros2/scene_topics.h).
#pragma once

#include <memory>
#include <string>

#include "apps/command.h"
#include "murosimf/ros2/scene_topics.h"
#include "murosimf/ros2/simulation_services.h"

namespace murosimf::app {

struct Ros2Arguments {
  std::string domain;  ///< of DDS; empty: no ROS 2
};

void add_ros2(const Command& command, Ros2Arguments& arguments);
/// Throws SetupError.
void check(const Ros2Arguments& arguments);

/// A domain of DDS as `option` has it. Throws SetupError.
[[nodiscard]] int read_domain(const std::string& option, const std::string& text);

/// What the run is in ROS 2.
struct Ros2 {
  int domain = 0;
  std::unique_ptr<dds::Participant> participant;
  std::unique_ptr<ros2::SceneTopics> topics;
};
/// Before the scene is initialized. Null without ROS 2. Throws SetupError, with the option.
[[nodiscard]] std::unique_ptr<Ros2> join_ros2(scene::Scene& scene, const Ros2Arguments& arguments);

class Steering;
/// Services that steer the session while they are there, and may want other scenes of `steering`. Null without ROS 2. Throws SetupError.
[[nodiscard]] std::unique_ptr<ros2::SimulationServices> services_of(session::Session& session, Ros2* joined,
                                                                    Steering& steering);

}  // namespace murosimf::app
