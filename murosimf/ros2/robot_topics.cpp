#include "murosimf/ros2/robot_topics.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/robot_urdf.h"

namespace murosimf::ros2 {

using dds::ros2::FramePose;
using dds::ros2::ros_name;
using dds::ros2::RosWriter;

namespace {

constexpr double joint_rate = 100, motion_rate = 50;  // [Hz]

Transformd seen_from(const Transformd& outer, const Transformd& inner) {
  return {transposed_times(outer.orientation, inner.position - outer.position),
          transpose(outer.orientation) * inner.orientation};
}

/// With frames named as the links of its description, so that viewers find them; without one, as the joints.
std::vector<recording::RecordedEntity> recorded(const Entity& robot, std::string_view description) {
  std::vector<recording::RecordedEntity> all;
  all.push_back(recording::recorded_entity(robot));
  const recording::FrameNames names = recording::frames_by_links(robot.name(), description);
  for (recording::RecordedEntity::Link& link : all[0].links) {
    const auto found = names.find(link.frame);
    if (found != names.end()) link.frame = found->second;
  }
  return all;
}

}  // namespace

OwnOdometry::OwnOdometry(const Entity& robot) : column_(robot.find(properties::odometry)) {}

/// Roll and pitch are what is left of the true orientation without its heading.
void OwnOdometry::follow(Duration now, const Transformd& truth) {
  const Vec3d place = column_->values.at(0);
  const double angle = place.z;
  motion_.pose.position = {place.x, place.y, truth.position.z};
  motion_.pose.orientation = rotation_z(angle - heading(truth.orientation)) * truth.orientation;
  const double span = seconds(now - last_);
  if (last_ >= Duration{} && span > 0) {
    const Vec3d way{place.x - before_.x, place.y - before_.y, 0};
    motion_.linear = (1 / span) * transposed_times(rotation_z(angle), way);
    motion_.angular = {0, 0, std::remainder(place.z - before_.z, 2 * pi) / span};
  } else {
    motion_.linear = motion_.angular = {};
  }
  last_ = now;
  before_ = place;
}

RobotTopics::RobotTopics(Topics topics, Entity& robot, const std::string& description)
    : robot_(robot),
      name_(ros_name(robot.name())),
      odometry_frame_(robot.name() + "/odom"),
      recorded_(recorded(robot, description)),
      joint_timer_(joint_rate),
      motion_timer_(motion_rate),
      odometry_(robot),
      joints_(topics.stream(fmt::format("/{}/joint_states", name_), "sensor_msgs/JointState")),
      truth_(topics.stream(fmt::format("/{}/ground_truth", name_), "nav_msgs/Odometry")) {
  for (const int joint : robot.model().joints())
    joint_names_.push_back(robot.model().objects()[static_cast<std::size_t>(joint)].name);
  if (odometry_.is_there()) odom_ = &topics.stream(fmt::format("/{}/odom", name_), "nav_msgs/Odometry");
  for (const sensors::Reading* reading : sensors::readings_of(robot)) {
    if (!reading->info->outputs.empty()) sensors_.emplace_back(topics, recorded_[0], *reading);
  }
  for (const recording::RecordedCamera& camera : recording::recorded_cameras(recorded_))
    cameras_.emplace_back(topics, robot, camera);
  if (description.empty()) return;
  outlet_.send_always(topics.latched(fmt::format("/{}/robot_description", name_), "std_msgs/String"),
                      [&](RosWriter& out) { write_string(out, description); });
}

void RobotTopics::publish(Duration now, bool frames_are_due, std::vector<FramePose>& frames) {
  recorded_[0].columns.follow(robot_);
  if (!robot_.present() || !recorded_[0].columns.position || !recorded_[0].columns.orientation) return;
  if (joint_timer_.is_due(now)) publish_joints(now);
  if (motion_timer_.is_due(now)) publish_motion(now);
  if (frames_are_due) add_frames(now, frames);
  for (SensorTopic& sensor : sensors_) sensor.publish(outlet_);
  for (CameraTopic& camera : cameras_) camera.publish(outlet_);
}

void RobotTopics::publish_joints(Duration now) {
  const recording::RecordedColumns& columns = recorded_[0].columns;
  const auto number = [](const Column<double>* column, int object) {
    return column ? column->values[static_cast<std::size_t>(object)] : std::nan("");
  };
  samples_.clear();
  for (std::size_t i = 0; i < joint_names_.size(); ++i) {
    const int object = recorded_[0].joints[i].object;
    samples_.push_back({joint_names_[i], number(columns.joint_position, object), number(columns.joint_velocity, object),
                        number(columns.joint_torque, object)});
  }
  outlet_.send(joints_, [&](RosWriter& out) { write_joint_state(out, {now, ""}, samples_); });
}

Transformd RobotTopics::pose_of(const recording::RecordedEntity::Link& link) const {
  const recording::RecordedColumns& columns = recorded_[0].columns;
  const auto i = static_cast<std::size_t>(link.object);
  return {columns.position->values[i], columns.orientation->values[i]};
}

void RobotTopics::publish_motion(Duration now) {
  const recording::RecordedEntity::Link& base = recorded_[0].links.front();
  const Transformd pose = pose_of(base);
  if (odom_) {
    odometry_.follow(now, pose);
    outlet_.send(*odom_, [&](RosWriter& out) {
      write_odometry(out, {now, odometry_frame_}, base.frame, odometry_.motion());
    });
  }
  outlet_.send(truth_, [&](RosWriter& out) {
    const auto *linear = robot_.find(properties::linear_velocity), *angular = robot_.find(properties::angular_velocity);
    dds::ros2::BodyMotion motion{.pose = pose};
    const auto i = static_cast<std::size_t>(base.object);
    if (linear) motion.linear = transposed_times(pose.orientation, linear->values[i]);
    if (angular) motion.angular = transposed_times(pose.orientation, angular->values[i]);
    write_odometry(out, {now, "world"}, base.frame, motion);
  });
}

/// The base stands in the frame of the robot's own odometry (REP 105); without one, in the world.
void RobotTopics::add_frames(Duration now, std::vector<FramePose>& frames) const {
  const auto add = [&](std::string_view parent, std::string_view child, const Transformd& pose) {
    frames.push_back({now, parent, child, pose.position, from_matrix(pose.orientation)});
  };
  const std::vector<recording::RecordedEntity::Link>& links = recorded_[0].links;
  for (const recording::RecordedEntity::Link& link : links) {
    if (link.parent >= 0) {
      const auto& parent = links[static_cast<std::size_t>(link.parent)];
      add(parent.frame, link.frame, seen_from(pose_of(parent), pose_of(link)));
    } else if (odom_) {
      add(odometry_frame_, link.frame, odometry_.motion().pose);
    } else {
      add("world", link.frame, pose_of(link));
    }
  }
}

void RobotTopics::add_fixed_frames(std::vector<FramePose>& frames) const {
  for (const SensorTopic& sensor : sensors_) frames.push_back(sensor.frame());
  for (const CameraTopic& camera : cameras_) frames.push_back(camera.frame());
}

}  // namespace murosimf::ros2
