#include "murosimf/ros2/scene_topics.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_picture.h"
#include "murosimf/recording/robot_urdf.h"

namespace murosimf::ros2 {

using dds::ros2::RosWriter;

namespace {

constexpr double clock_rate = 100, frame_rate = 50;  // [Hz]

}  // namespace

SceneTopics::SceneTopics(scene::Scene& scene, dds::Participant& participant,
                         std::function<void(const std::string&)> say)
    : scene_(scene),
      topics_(participant),
      say_(std::move(say)),
      clock_(topics_.stream("/clock", "rosgraph_msgs/Clock")),
      frames_(topics_.stream("/tf", "tf2_msgs/TFMessage")),
      fixed_frames_(topics_.latched("/tf_static", "tf2_msgs/TFMessage")),
      clock_timer_(clock_rate),
      frame_timer_(frame_rate) {
  recording::offer_pictures(scene.simulation().world());
  // as of a recorder: a state that is loaded knows nothing of it
  scene.simulation().after_start([this] { scene_.simulation().at(Duration{}, [this] { begin(); }); });
}

void SceneTopics::begin() {
  add_entities();
  look();
}

/// All that can move, also what has come later.
void SceneTopics::add_entities() {
  const std::vector<Entity*>& moving = scene_.moving_entities();
  for (; known_ < moving.size(); ++known_) {
    Entity& entity = *moving[known_];
    const auto& robots = scene_.parts().robots;
    if (std::ranges::find(robots, &entity) != robots.end()) {
      robots_.push_back(std::make_unique<RobotTopics>(topics_, entity, description_of(entity)));
    } else {
      others_.push_back(recording::recorded_entity(entity));
    }
  }
  send_fixed_frames();
}

std::string SceneTopics::description_of(const Entity& robot) const {
  try {
    return recording::urdf_of(scene_, robot);
  } catch (const SetupError& error) {
    say_(fmt::format("{} has no robot_description: {}", robot.name(), error.what()));
    return {};
  }
}

void SceneTopics::send_fixed_frames() {
  poses_.clear();
  for (const auto& robot : robots_) robot->add_fixed_frames(poses_);
  outlet_.send_always(fixed_frames_, [&](RosWriter& out) { write_transforms(out, poses_); });
}

/// Between two steps.
void SceneTopics::look() {
  Simulation& simulation = scene_.simulation();
  const Duration now = simulation.now();
  if (known_ < scene_.moving_entities().size()) add_entities();
  if (clock_timer_.is_due(now)) outlet_.send(clock_, [&](RosWriter& out) { write_clock(out, now); });
  const bool frames_are_due = frame_timer_.is_due(now);
  poses_.clear();
  for (const auto& robot : robots_) robot->publish(now, frames_are_due && frames_.has_readers(), poses_);
  if (frames_are_due && frames_.has_readers()) {
    for (recording::RecordedEntity& other : others_) {
      other.columns.follow(*other.entity);
      const recording::RecordedEntity::Link& base = other.links.front();
      const auto i = static_cast<std::size_t>(base.object);
      if (!other.entity->present() || !other.columns.position || !other.columns.orientation) continue;
      poses_.push_back({now, "world", base.frame, other.columns.position->values[i],
                        from_matrix(other.columns.orientation->values[i])});
    }
    outlet_.send(frames_, [&](RosWriter& out) { write_transforms(out, poses_); });
  }
  simulation.at(now + simulation.tick(), [this] { look(); });
}

}  // namespace murosimf::ros2
