#include "murosimf/dds/ros2/ros_software.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include <fmt/format.h>

#include "murosimf/dds/model_joints.h"
#include "murosimf/model/error.h"

namespace murosimf::dds::ros2 {
namespace {

constexpr std::size_t sender_size = 24;           // [byte] before a request
constexpr std::uint64_t cycles_of_feedback = 25;  // 20 per simulated second
constexpr double fastest = 100;                   // [m/s, rad/s] as of motion.velocity

std::optional<booster::MotionRequests> motions_of(const Setup& setup, control_software::RobotPort& port, bool walks) {
  if (!walks) return std::nullopt;
  return with_context("controller 'ros2' (walk = false: joints alone)",
                      [&] { return std::optional<booster::MotionRequests>(std::in_place, setup, port); });
}

/// False: it is too short.
bool open_call(const Bytes& bytes, ServiceCall& call) {
  if (bytes.size() < sender_size) return false;
  SampleIdentity from;
  std::copy_n(bytes.begin(), from.writer.size(), from.writer.begin());
  std::memcpy(&from.number, &bytes[from.writer.size()], sizeof from.number);
  return ros2::open_call({bytes.begin() + sender_size, bytes.end()}, from, call);
}

}  // namespace

RosSoftware::RosSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                         const RosOptions& options, std::optional<int> domain, const ExternalInputOptions& outside)
    : say_(std::move(say)),
      name_(setup.entity().name()),
      options_(options),
      names_(joint_names(setup.model())),
      joints_(setup, port, options.walk),
      position_(port.signal("joint.position")),
      motions_(motions_of(setup, port, options.walk)),
      action_(joints_),
      outside_("dds:" + name_, outside, say_,
               {"a ROS 2 node has come that commands it", "the last node has gone; commands stay as they are"}) {
  if (domain && !outside_.is_repeated()) link_ = std::make_unique<RosCommandLink>(*domain, name_);
}

control_software::CallOutcome RosSoftware::start() {
  joints_.restart();
  action_.restart();
  velocity_ = {};
  walks_until_ = {};
  cycle_ = 0;
  return {};
}

control_software::CallOutcome RosSoftware::step(Duration now) noexcept {
  for (const Arrival& arrival : outside_.at(now, link_ ? &link_->inbox() : nullptr)) take(arrival, now);
  if (motions_) motions_->walk(now < walks_until_ ? velocity_ : Vec3d{});
  joints_.command(now);
  tell_of_goals(now);
  ++cycle_;
  return {};
}

void RosSoftware::take(const Arrival& arrival, Duration now) {
  if (take_command(arrival, now) || take_call(arrival, now)) return;
  garbage_.say(say_, "a message that is damaged, or does not fit the robot, was ignored");
}

bool RosSoftware::take_command(const Arrival& arrival, Duration now) {
  using Link = RosCommandLink;
  switch (arrival.topic) {
    case Link::twist_mark: return walk(read_twist(arrival.message), now);
    case Link::stamped_twist_mark: return walk(read_stamped_twist(arrival.message), now);
    case Link::trajectory_mark: return follow(read_trajectory(arrival.message), now);
    case Link::joint_state_mark: return set(read_joint_state(arrival.message));
    case Link::numbers_mark: return set(read_numbers(arrival.message));
    default: return false;
  }
}

bool RosSoftware::walk(const std::optional<Vec3d>& velocity, Duration now) {
  if (!velocity || !motions_) return false;
  const auto within = [](double x) { return std::clamp(x, -fastest, fastest); };
  velocity_ = {within(velocity->x), within(velocity->y), within(velocity->z)};
  walks_until_ = now + from_seconds(options_.timeout);
  joints_.leave_legs();
  return true;
}

/// An unknown joint is told once.
std::optional<std::vector<std::size_t>> RosSoftware::known_places(const std::vector<std::string>& names) {
  NamedPlaces joints = joints_.places_of(names);
  if (joints.unknown.empty()) return std::move(joints.places);
  unknown_joint_.say(say_, fmt::format("a command for the joint '{}' was ignored: it has none, or it is named twice",
                                       joints.unknown));
  return std::nullopt;
}

/// An empty trajectory stops all joints (joint_trajectory_controller).
bool RosSoftware::follow(const std::optional<TrajectoryMessage>& trajectory, Duration now) {
  if (!trajectory) return false;
  const auto places = known_places(trajectory->joints);
  if (!places) return true;
  action_.preempt(*places);
  trajectory->points.empty() ? joints_.halt(*places) : joints_.follow(*places, *trajectory, now);
  return true;
}

bool RosSoftware::set(const std::optional<JointStateMessage>& joints) {
  if (!joints) return false;
  const auto places = known_places(joints->joints);
  if (!places) return true;
  action_.preempt(*places);
  joints_.set(*places, joints->positions, joints->velocities);
  return true;
}

bool RosSoftware::set(const std::optional<std::vector<double>>& numbers) {
  if (!numbers || numbers->size() != joints_.size()) return false;
  std::vector<std::size_t> all(joints_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  action_.preempt(all);
  joints_.set(all, *numbers, {});
  return true;
}

bool RosSoftware::take_call(const Arrival& arrival, Duration now) {
  using Link = TrajectoryActionLink;
  ServiceCall call;
  if (!open_call(arrival.message, call)) return false;
  if (arrival.topic == Link::send_goal_mark) {
    const auto goal = read_goal(call.request);
    const bool accepted = goal && action_.accept(*goal, now);
    if (is_live()) link_->action().answer_goal(call, accepted, now);
    return goal.has_value();
  }
  const auto id = read_goal_id(call.request);
  if (!id) return false;
  if (arrival.topic == Link::cancel_mark) {
    const auto canceled = action_.cancel(*id);
    if (is_live()) link_->action().answer_cancel(call, canceled);
  } else if (is_live()) {
    link_->action().answer_result(call, *id, action_);
  }
  return true;
}

void RosSoftware::tell_of_goals(Duration now) {
  const bool changed = action_.advance(now);
  if (!is_live()) return;
  if (changed) {
    link_->action().send_status(action_);
    link_->action().send_results(action_);
  }
  const TrajectoryAction::Goal* const goal = action_.active();
  if (!goal || cycle_ % cycles_of_feedback != 0 || !link_->action().wants_feedback()) return;
  TrajectoryActionLink::FeedbackOf feedback{*goal, {}, {}, {}};
  for (const std::size_t place : goal->places) {
    feedback.joints.push_back(names_[place]);
    feedback.desired.push_back(joints_.target(place));
    feedback.actual.push_back(position_->values[place]);
  }
  link_->action().send_feedback(feedback, now);
}

void RosSoftware::state(StateArchive& archive) {
  archive(joints_, action_, velocity_, walks_until_, cycle_);
  if (archive.loads()) outside_.rewind();
}

}  // namespace murosimf::dds::ros2
