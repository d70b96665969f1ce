/// step_action.h - the action simulation_interfaces/SimulateSteps: a paused run makes steps, tells how far it is, and can be stopped.
///
/// Source: rcl_action, action_msgs (GoalStatus, CancelGoal); simulation_interfaces 2.0. Feedback comes 20 times per wall second, not after each step.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

#include "murosimf/dds/ros2/command_messages.h"
#include "murosimf/dds/ros2/service.h"
#include "murosimf/ros2/simulation_messages.h"
#include "murosimf/session/session.h"

namespace murosimf::ros2 {

class StepAction {
 public:
  // Marks of its requests in the inbox.
  static constexpr char send_goal_mark = 1, cancel_mark = 2, result_mark = 3;

  /// Throws SetupError.
  StepAction(session::Session& session, dds::Participant& participant, dds::Inbox& inbox);

  [[nodiscard]] static bool is_own(char mark) {
    return mark == send_goal_mark || mark == cancel_mark || mark == result_mark;
  }
  /// False: the request is damaged.
  [[nodiscard]] bool take(char mark, const dds::ros2::ServiceCall& call);
  /// Now and then while it is busy.
  void advance();
  [[nodiscard]] bool is_busy() const { return goal_.status == executing; }

 private:
  enum Status : std::uint8_t { unknown = 0, executing = 2, succeeded = 4, canceled = 5, aborted = 6 };
  struct Goal {
    dds::ros2::GoalId id{};
    Duration accepted{}, begin{};
    std::uint64_t steps = 0, jumps = 0;
    Status status = unknown;
    Result result{};
  };
  [[nodiscard]] bool accept(const dds::ros2::ServiceCall& call);
  void cancel(const dds::ros2::ServiceCall& call, const dds::ros2::GoalId& id);
  void end(Status status, Result result);
  void answer_result(const dds::ros2::ServiceCall& call);
  void send_status();
  void send_feedback(std::uint64_t completed);

  session::Session& session_;
  Duration tick_;
  dds::ros2::Service send_goal_, cancel_, result_;
  dds::TopicWriter &feedback_, &status_;
  Goal goal_;  // the last one
  std::vector<dds::ros2::ServiceCall> waiting_;
  std::chrono::steady_clock::time_point told_{};
  dds::ros2::RosWriter out_;
};

}  // namespace murosimf::ros2
