/// trajectory_action.h - the action control_msgs/FollowJointTrajectory of one robot, as action clients of ROS 2 see it: goals, their status and results.
///
/// One goal at a time: a new one ends the one before as canceled. A goal succeeds when its last point is reached by the targets; tolerances are not
/// watched. Source: rcl_action, action_msgs (GoalStatus, CancelGoal).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "murosimf/dds/ros2/command_messages.h"
#include "murosimf/dds/ros2/joint_motion.h"
#include "murosimf/dds/ros2/ros_writer.h"
#include "murosimf/dds/ros2/service.h"

namespace murosimf::dds::ros2 {

/// action_msgs/GoalStatus
enum class GoalStatus : std::int8_t { executing = 2, succeeded = 4, canceled = 5, aborted = 6 };

class TrajectoryAction {
 public:
  explicit TrajectoryAction(JointMotion& joints) : joints_(joints) {}

  struct Goal {
    GoalId id{};
    Duration accepted{}, end{};
    GoalStatus status = GoalStatus::executing;
    std::vector<std::size_t> places;
    void state(StateArchive& archive) { archive(id, accepted, end, status, places); }
  };

  /// False: it is refused, because a joint is unknown or there are no points.
  [[nodiscard]] bool accept(const GoalMessage& goal, Duration now);
  /// All zeros: every goal. Returns those that it has canceled.
  std::vector<Goal> cancel(const GoalId& id);
  /// Other commands of the same joints end a goal, too.
  void preempt(const std::vector<std::size_t>& places);
  /// In every cycle. True: the status of a goal has changed since the last call.
  [[nodiscard]] bool advance(Duration now);
  /// Null: unknown, or forgotten.
  [[nodiscard]] const Goal* find(const GoalId& id) const;
  /// That is followed; null: none.
  [[nodiscard]] const Goal* active() const;
  [[nodiscard]] const std::vector<Goal>& goals() const { return goals_; }

  void restart() {
    goals_.clear();
    changed_ = true;
  }
  template <class Archive>
  void state(Archive& archive) {
    archive(goals_);
    changed_ = true;
  }

 private:
  static constexpr std::size_t most_goals = 20;  // that are remembered

  JointMotion& joints_;
  std::vector<Goal> goals_;  // the oldest first
  bool changed_ = true;
};

/// Topics and services of the action.
class TrajectoryActionLink {
 public:
  /// Marks of its requests in the inbox.
  static constexpr char send_goal_mark = 'g', cancel_mark = 'x', result_mark = 'r';

  /// `name`: "/blue1/joint_trajectory_controller/follow_joint_trajectory". Throws SetupError.
  TrajectoryActionLink(Participant& participant, const std::string& name, Inbox& inbox);

  void answer_goal(const ServiceCall& call, bool accepted, Duration now);
  void answer_cancel(const ServiceCall& call, const std::vector<TrajectoryAction::Goal>& canceled);
  /// At once if the goal has ended, else when it does.
  void answer_result(const ServiceCall& call, const GoalId& id, const TrajectoryAction& action);
  void send_results(const TrajectoryAction& action);
  void send_status(const TrajectoryAction& action);

  struct FeedbackOf {
    const TrajectoryAction::Goal& goal;
    std::vector<std::string> joints;
    std::vector<double> desired, actual;
  };
  void send_feedback(const FeedbackOf& feedback, Duration now);
  [[nodiscard]] bool wants_feedback() const { return feedback_.has_readers(); }

 private:
  struct Waiting {
    ServiceCall call;
    GoalId id{};
  };
  void send_result(const ServiceCall& call, const TrajectoryAction::Goal* goal);

  Service send_goal_, cancel_, result_;
  TopicWriter &feedback_, &status_;
  std::vector<Waiting> waiting_;
  RosWriter out_;
};

}  // namespace murosimf::dds::ros2
