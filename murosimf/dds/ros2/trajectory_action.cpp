#include "murosimf/dds/ros2/trajectory_action.h"

#include <algorithm>

#include "murosimf/dds/ros2/ros_names.h"

namespace murosimf::dds::ros2 {
namespace {

constexpr std::size_t most_waiting = 100;
constexpr std::int32_t successful = 0, invalid_goal = -1;  // control_msgs FollowJointTrajectory
const std::string action_type = "control_msgs/action/FollowJointTrajectory";

void put_id(RosWriter& out, const GoalId& id) {
  for (const std::uint8_t byte : id) out.u8(byte);
}

/// action_msgs/GoalInfo
void put_info(RosWriter& out, const TrajectoryAction::Goal& goal) {
  put_id(out, goal.id);
  out.time(goal.accepted);
}

void put_numbers(RosWriter& out, const std::vector<double>& numbers) {
  out.u32(static_cast<std::uint32_t>(numbers.size()));
  for (const double number : numbers) out.f64(number);
}

/// trajectory_msgs/JointTrajectoryPoint
void put_point(RosWriter& out, const std::vector<double>& positions, Duration time) {
  put_numbers(out, positions);
  for (int i = 0; i < 3; ++i) out.u32(0);
  out.time(time);
}

}  // namespace

bool TrajectoryAction::accept(const GoalMessage& goal, Duration now) {
  const NamedPlaces joints = joints_.places_of(goal.trajectory.joints);
  if (!joints.unknown.empty() || joints.places.empty() || goal.trajectory.points.empty()) return false;
  if (find(goal.id)) return false;
  for (Goal& other : goals_) {
    if (other.status == GoalStatus::executing) other.status = GoalStatus::canceled;
  }
  if (goals_.size() >= most_goals) goals_.erase(goals_.begin());
  const Duration end = now + from_seconds(goal.trajectory.points.back().time);
  goals_.push_back({goal.id, now, end, GoalStatus::executing, joints.places});
  joints_.follow(joints.places, goal.trajectory, now);
  changed_ = true;
  return true;
}

std::vector<TrajectoryAction::Goal> TrajectoryAction::cancel(const GoalId& id) {
  std::vector<Goal> canceled;
  for (Goal& goal : goals_) {
    if (goal.status != GoalStatus::executing || (id != GoalId{} && goal.id != id)) continue;
    goal.status = GoalStatus::canceled;
    joints_.halt(goal.places);
    canceled.push_back(goal);
  }
  changed_ = changed_ || !canceled.empty();
  return canceled;
}

void TrajectoryAction::preempt(const std::vector<std::size_t>& places) {
  for (Goal& goal : goals_) {
    const bool shares = std::ranges::any_of(goal.places, [&](std::size_t place) {
      return std::ranges::find(places, place) != places.end();
    });
    if (goal.status != GoalStatus::executing || !shares) continue;
    goal.status = GoalStatus::aborted;
    changed_ = true;
  }
}

bool TrajectoryAction::advance(Duration now) {
  for (Goal& goal : goals_) {
    if (goal.status != GoalStatus::executing || now < goal.end) continue;
    goal.status = GoalStatus::succeeded;
    changed_ = true;
  }
  return std::exchange(changed_, false);
}

const TrajectoryAction::Goal* TrajectoryAction::find(const GoalId& id) const {
  const auto found = std::ranges::find(goals_, id, &Goal::id);
  return found == goals_.end() ? nullptr : &*found;
}

const TrajectoryAction::Goal* TrajectoryAction::active() const {
  const auto found = std::ranges::find(goals_, GoalStatus::executing, &Goal::status);
  return found == goals_.end() ? nullptr : &*found;
}

TrajectoryActionLink::TrajectoryActionLink(Participant& participant, const std::string& name, Inbox& inbox)
    : send_goal_(participant, name + "/_action/send_goal", action_type + "_SendGoal", inbox, send_goal_mark),
      cancel_(participant, name + "/_action/cancel_goal", "action_msgs/srv/CancelGoal", inbox, cancel_mark),
      result_(participant, name + "/_action/get_result", action_type + "_GetResult", inbox, result_mark),
      feedback_(participant.writer({.name = topic_name(name + "/_action/feedback"),
                                    .type = "control_msgs::action::dds_::FollowJointTrajectory_FeedbackMessage_",
                                    .reliable = true,
                                    .depth = 10})),
      status_(participant.writer({.name = topic_name(name + "/_action/status"),
                                  .type = type_name("action_msgs/GoalStatusArray"),
                                  .reliable = true,
                                  .kept = true,
                                  .depth = 1})) {}

void TrajectoryActionLink::answer_goal(const ServiceCall& call, bool accepted, Duration now) {
  out_.clear();
  out_.boolean(accepted);
  out_.time(now);
  send_goal_.answer(call, out_.encoded());
}

void TrajectoryActionLink::answer_cancel(const ServiceCall& call, const std::vector<TrajectoryAction::Goal>& canceled) {
  constexpr std::uint8_t none = 0, rejected = 1;  // action_msgs/CancelGoal
  out_.clear();
  out_.u8(canceled.empty() ? rejected : none);
  out_.u32(static_cast<std::uint32_t>(canceled.size()));
  for (const TrajectoryAction::Goal& goal : canceled) put_info(out_, goal);
  cancel_.answer(call, out_.encoded());
}

void TrajectoryActionLink::send_result(const ServiceCall& call, const TrajectoryAction::Goal* goal) {
  const bool good = goal && goal->status == GoalStatus::succeeded;
  out_.clear();
  out_.u8(goal ? static_cast<std::uint8_t>(goal->status) : 0);
  out_.i32(good ? successful : invalid_goal);
  out_.text(good ? "" : goal ? "another command has taken its place" : "there is no such goal");
  result_.answer(call, out_.encoded());
}

void TrajectoryActionLink::answer_result(const ServiceCall& call, const GoalId& id, const TrajectoryAction& action) {
  const TrajectoryAction::Goal* const goal = action.find(id);
  if (!goal || goal->status != GoalStatus::executing) return send_result(call, goal);
  if (waiting_.size() < most_waiting) waiting_.push_back({call, id});
}

void TrajectoryActionLink::send_results(const TrajectoryAction& action) {
  const auto answered = [&](const Waiting& one) {
    const TrajectoryAction::Goal* const goal = action.find(one.id);
    if (goal && goal->status == GoalStatus::executing) return false;
    send_result(one.call, goal);
    return true;
  };
  std::erase_if(waiting_, answered);
}

void TrajectoryActionLink::send_status(const TrajectoryAction& action) {
  out_.clear();
  out_.u32(static_cast<std::uint32_t>(action.goals().size()));
  for (const TrajectoryAction::Goal& goal : action.goals()) {
    put_info(out_, goal);
    out_.u8(static_cast<std::uint8_t>(goal.status));
  }
  status_.write(out_.encoded());
}

void TrajectoryActionLink::send_feedback(const FeedbackOf& feedback, Duration now) {
  std::vector<double> error = feedback.desired;
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= feedback.actual[i];
  const Duration time = now - feedback.goal.accepted;
  out_.clear();
  put_id(out_, feedback.goal.id);
  out_.header(now, "");
  out_.texts(feedback.joints);
  put_point(out_, feedback.desired, time);
  put_point(out_, feedback.actual, time);
  put_point(out_, error, time);
  out_.u32(0);  // no joints of several degrees of freedom
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) out_.u32(0);
    out_.time({});
  }
  feedback_.write(out_.encoded());
}

}  // namespace murosimf::dds::ros2
