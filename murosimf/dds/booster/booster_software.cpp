#include "murosimf/dds/booster/booster_software.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/dds/model_joints.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::dds::booster {
namespace {

constexpr std::size_t first_arm_joint = 2, end_of_arm_joints = 10;  // of K1 and T1

Mode mode_of(const std::string& name) {
  if (name == "damping") return Mode::damping;
  if (name == "walking") return Mode::walking;
  if (name == "custom") return Mode::custom;
  return name == "soccer" ? Mode::soccer : Mode::prepare;
}

}  // namespace

BoosterSoftware::BoosterSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                                 const BoosterOptions& options, std::optional<int> domain,
                                 const ExternalInputOptions& outside)
    : say_(std::move(say)),
      name_(setup.entity().name()),
      period_(seconds(setup.period())),
      first_mode_(mode_of(options.mode)),
      joints_(place_joints(joint_names(setup.model()))),
      objects_(joint_objects(setup.model(), joints_.places)),
      target_(setup.input(properties::joint_target, 0.0)),
      low_level_(port, joints_.places),
      sensing_(setup, port, joints_.places),
      frames_(setup.model(), objects_),
      motions_(setup, port),
      outside_("dds:" + name_, outside, say_,
               {"a program with the robot's SDK has come", "the last program has gone; commands stay as they are"}),
      command_wait_(options.lock_step, say_),
      modes_(first_mode_),
      held_(joints_.places.size()) {
  handle_requests();
  if (!domain || outside_.is_repeated()) return;
  link_ = std::make_unique<BoosterLink>(*domain, options.suffix);
}

control_software::CallOutcome BoosterSoftware::start() {
  modes_ = RobotModes(first_mode_);
  sensing_.restart();
  commands_.clear();
  head_ = {};
  visual_kick_ = {};
  upper_body_ = false;
  cycle_ = 0;
  return {};
}

control_software::CallOutcome BoosterSoftware::step(Duration now) noexcept {
  sensing_.follow();
  modes_.follow(sensing_.posture());
  wait_for_command();
  for (const Arrival& arrival : outside_.at(now, link_ ? &link_->inbox() : nullptr)) take(arrival);
  head_.advance(period_);
  if (link_ && !outside_.remembers()) send();
  command();
  ++cycle_;
  return {};
}

void BoosterSoftware::wait_for_command() {
  if (!link_ || modes_.mode() != Mode::custom || outside_.remembers()) return;
  command_wait_.wait(link_->inbox(), low_command_mark);
}

void BoosterSoftware::take(const Arrival& arrival) {
  if (arrival.topic == low_command_mark) {
    if (std::optional<LowCommand> command = read_low_command(arrival.message)) {
      return take_low_command(std::move(*command));
    }
  } else if (arrival.topic == kick_mark) {
    if (const std::optional<KickTarget> target = read_kick(arrival.message)) return visual_kick_.see(*target, cycle_);
  } else if (const std::optional<RpcMessage> request = read_rpc(arrival.message)) {
    return answer(*request);
  }
  garbage_.say(say_, "a message that the SDK does not send was ignored");
}

void BoosterSoftware::take_low_command(LowCommand command) {
  if (command.motors.size() == joints_.places.size()) {
    commands_ = std::move(command.motors);
    return;
  }
  size_.say(say_, fmt::format("a low-level command for {} motors was ignored: the robot has {}", command.motors.size(),
                              joints_.places.size()));
}

void BoosterSoftware::answer(const RpcMessage& request) {
  const RpcMessage reply = answer_to(request, handlers_);
  if (link_ && !outside_.remembers()) link_->answer(reply);
}

bool BoosterSoftware::follows_low_level(std::size_t joint) const {
  if (modes_.mode() == Mode::custom) return true;
  return upper_body_ && modes_.uses_motions() && !modes_.rises() && !modes_.lies() && joint >= first_arm_joint &&
         joint < end_of_arm_joints;
}

void BoosterSoftware::command() {
  motions_.walk(modes_.velocity());
  if (const auto kick = visual_kick_.request(cycle_); kick && modes_.walks()) (void)motions_.kick(*kick);
  if (cycle_ == 0) {
    for (std::size_t joint = 0; joint < held_.size(); ++joint) held_[joint] = target_[objects_[joint]];
  }
  for (std::size_t joint = 0; joint < joints_.places.size(); ++joint) command_joint(joint);
}

void BoosterSoftware::command_joint(std::size_t joint) {
  MUROSIMF_ASSERT(joint < held_.size());
  if (follows_low_level(joint)) {
    if (commands_.empty()) return low_level_.hold(joint, held_[joint]);
    return low_level_.drive(joint, commands_[joint], held_[joint]);
  }
  const bool of_head = joint < std::tuple_size_v<HeadAngles>;
  if (modes_.mode() == Mode::damping) {
    held_[joint] = sensing_.motors()[joint].q;
    return low_level_.damp(joint, held_[joint]);
  }
  held_[joint] = target_[objects_[joint]];
  if (of_head && head_.is_asked() && !modes_.rises() && !modes_.lies()) {
    return low_level_.hold(joint, head_.angles()[joint]);
  }
  low_level_.leave_to_motions(joint);
}

/// Rates but that of the joints are those that programs can expect, not the real robot's, which are not published.
void BoosterSoftware::send() {
  const auto write = [&](TopicWriter& writer, const auto& fill) {
    message_.clear();
    fill();
    writer.write(message_.bytes());
  };
  const BoosterLink::StateWriters& to = link_->states();
  write(to.low_state, [&] { write_low_state(message_, sensing_.imu(), sensing_.motors()); });
  if (cycle_ % 10 == 0) write(to.odometer, [&] { write_odometer(message_, sensing_.odometer()); });
  if (cycle_ % 50 != 0) return;
  const Posture posture = sensing_.posture();
  write(to.fall_down, [&] { write_fall_down(message_, modes_.fall_down(posture), posture.fallen && !modes_.rises()); });
  write(to.robot_states, [&] {
    write_robot_states(message_, {static_cast<std::int32_t>(modes_.mode()), modes_.body_control()});
  });
  constexpr Battery full{.charge = 100};  // none is simulated
  write(to.battery, [&] { write_battery(message_, full); });
}

void BoosterSoftware::state(StateArchive& archive) {
  archive(modes_, sensing_, head_, visual_kick_, held_, commands_, upper_body_, cycle_);
  if (archive.loads()) outside_.rewind();
}

}  // namespace murosimf::dds::booster
