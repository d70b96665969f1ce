#include "murosimf/ros2/step_action.h"

#include <utility>

#include "murosimf/dds/ros2/ros_names.h"

namespace murosimf::ros2 {

using namespace std::chrono_literals;

namespace {

constexpr std::uint64_t longest_goal = 1'000'000'000;  // as of a supervisor
constexpr std::size_t most_waiting = 100;
const std::string step_name = "/simulate_steps/_action/", step_type = "simulation_interfaces/action/SimulateSteps";

void put_id(dds::ros2::RosWriter& out, const dds::ros2::GoalId& id) {
  for (const std::uint8_t byte : id) out.u8(byte);
}

}  // namespace

StepAction::StepAction(session::Session& session, dds::Participant& participant, dds::Inbox& inbox)
    : session_(session),
      tick_(session.scene().simulation().tick()),
      send_goal_(participant, step_name + "send_goal", step_type + "_SendGoal", inbox, send_goal_mark),
      cancel_(participant, step_name + "cancel_goal", "action_msgs/srv/CancelGoal", inbox, cancel_mark),
      result_(participant, step_name + "get_result", step_type + "_GetResult", inbox, result_mark),
      feedback_(participant.writer({.name = dds::ros2::topic_name(step_name + "feedback"),
                                    .type = "simulation_interfaces::action::dds_::SimulateSteps_FeedbackMessage_",
                                    .reliable = true,
                                    .depth = 10})),
      status_(participant.writer({.name = dds::ros2::topic_name(step_name + "status"),
                                  .type = dds::ros2::type_name("action_msgs/GoalStatusArray"),
                                  .reliable = true,
                                  .kept = true,
                                  .depth = 1})) {}

bool StepAction::take(char mark, const dds::ros2::ServiceCall& call) {
  if (mark == send_goal_mark) return accept(call);
  const auto id = dds::ros2::read_goal_id(call.request);
  if (!id) return false;
  if (mark == cancel_mark) {
    cancel(call, *id);
  } else if (is_busy() && *id == goal_.id) {
    if (waiting_.size() < most_waiting) waiting_.push_back(call);
  } else if (*id == goal_.id) {
    answer_result(call);
  } else {
    const Goal known = std::exchange(goal_, {});
    goal_.result = {ResultCode::not_found, "there is no such goal"};
    answer_result(call);
    goal_ = known;
  }
  return true;
}

/// A run that is not paused refuses it by the result, as the package wants it.
bool StepAction::accept(const dds::ros2::ServiceCall& call) {
  dds::CdrReader in(call.request);
  Goal goal;
  for (std::uint8_t& byte : goal.id) byte = in.number<std::uint8_t>();
  goal.steps = in.number<std::uint64_t>();
  if (!in.good()) return false;
  const session::SessionStatus status = session_.status();
  const bool accepted = !is_busy() && goal.steps <= longest_goal;
  out_.clear();
  out_.boolean(accepted);
  out_.time(status.time);
  send_goal_.answer(call, out_.encoded());
  if (!accepted) return true;
  goal.accepted = goal.begin = status.time;
  goal.jumps = status.jumps;
  goal.status = executing;
  goal_ = goal;
  send_status();
  if (!status.paused) {
    end(aborted, {ResultCode::operation_failed, "the simulation is not paused"});
  } else if (goal.steps > 0) {
    session_.step(static_cast<std::int64_t>(goal.steps));
  }
  return true;
}

void StepAction::cancel(const dds::ros2::ServiceCall& call, const dds::ros2::GoalId& id) {
  constexpr std::uint8_t good = 0, rejected = 1;  // action_msgs/CancelGoal
  const bool meant = is_busy() && (id == goal_.id || id == dds::ros2::GoalId{});
  out_.clear();
  out_.u8(meant ? good : rejected);
  out_.u32(meant ? 1 : 0);
  if (meant) {
    put_id(out_, goal_.id);
    out_.time(goal_.accepted);
  }
  cancel_.answer(call, out_.encoded());
  if (!meant) return;
  session_.pause();
  end(canceled, {ResultCode::operation_failed, "canceled"});
}

void StepAction::advance() {
  if (!is_busy()) return;
  const session::SessionStatus now = session_.status();
  if (now.jumps != goal_.jumps)
    return end(aborted, {ResultCode::operation_failed, "another command has taken the run to another time"});
  const auto completed = static_cast<std::uint64_t>((now.time - goal_.begin) / tick_);
  const auto wall = std::chrono::steady_clock::now();
  if (wall - told_ > 50ms || completed >= goal_.steps) {
    send_feedback(std::min(completed, goal_.steps));
    told_ = wall;
  }
  if (completed >= goal_.steps) end(succeeded, {});
}

void StepAction::end(Status status, Result result) {
  goal_.status = status;
  goal_.result = std::move(result);
  send_status();
  for (const dds::ros2::ServiceCall& call : std::exchange(waiting_, {})) answer_result(call);
}

void StepAction::answer_result(const dds::ros2::ServiceCall& call) {
  out_.clear();
  out_.u8(goal_.status);
  put(out_, goal_.result);
  result_.answer(call, out_.encoded());
}

/// action_msgs/GoalStatusArray
void StepAction::send_status() {
  out_.clear();
  out_.u32(1);
  put_id(out_, goal_.id);
  out_.time(goal_.accepted);
  out_.u8(goal_.status);
  status_.write(out_.encoded());
}

void StepAction::send_feedback(std::uint64_t completed) {
  if (!feedback_.has_readers()) return;
  out_.clear();
  put_id(out_, goal_.id);
  out_.u64(completed);
  out_.u64(goal_.steps - completed);
  feedback_.write(out_.encoded());
}

}  // namespace murosimf::ros2
