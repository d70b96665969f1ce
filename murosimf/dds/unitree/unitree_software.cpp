#include "murosimf/dds/unitree/unitree_software.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/dds/model_joints.h"
#include "murosimf/dds/unitree/motor_order.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::dds::unitree {
namespace {

constexpr const char* torso_imu = "torso_imu";  // sensor of the robot's file

}  // namespace

UnitreeSoftware::UnitreeSoftware(Setup& setup, control_software::RobotPort& port, control_software::SayLine say,
                                 const UnitreeOptions& options, std::optional<int> domain,
                                 const ExternalInputOptions& outside)
    : say_(std::move(say)),
      stands_first_(options.stands),
      places_(place_joints(joint_names(setup.model()))),
      objects_(joint_objects(setup.model(), places_)),
      target_(setup.input(properties::joint_target, 0.0)),
      low_level_(port, places_),
      joints_(seconds(setup.period()), port, places_),
      pelvis_(setup, port, "imu"),
      outside_("dds:" + setup.entity().name(), outside, say_,
               {"a low-level program has come", "the last program has gone; commands stay as they are"}),
      command_wait_(options.lock_step, say_),
      stands_(stands_first_),
      held_(places_.size()) {
  if (sensors::find_reading(setup.entity(), torso_imu)) torso_.emplace(setup, port, torso_imu);
  if (!domain || outside_.is_repeated()) return;
  link_ = std::make_unique<UnitreeLink>(*domain, options.suffix);
}

control_software::CallOutcome UnitreeSoftware::start() {
  stands_ = stands_first_;
  joints_.restart();
  pelvis_.restart();
  if (torso_) torso_->restart();
  commands_.clear();
  cycle_ = 0;
  return {};
}

control_software::CallOutcome UnitreeSoftware::step(Duration now) noexcept {
  joints_.follow();
  pelvis_.follow();
  if (torso_) torso_->follow();
  wait_for_command();
  for (const Arrival& arrival : outside_.at(now, link_ ? &link_->inbox() : nullptr)) take(arrival);
  if (link_ && !outside_.remembers()) send(now);
  command();
  ++cycle_;
  return {};
}

void UnitreeSoftware::wait_for_command() {
  if (!link_ || stands_ || outside_.remembers()) return;
  command_wait_.wait(link_->inbox(), low_command_mark);
}

void UnitreeSoftware::take(const Arrival& arrival) {
  if (arrival.topic == low_command_mark) {
    if (const std::optional<LowCommand> command = read_low_command(arrival.message)) return take_low_command(*command);
  } else if (const std::optional<Request> request = read_request(arrival.message)) {
    return answer(*request);
  }
  garbage_.say(say_, "a message that is none of unitree_hg or unitree_api was ignored");
}

void UnitreeSoftware::take_low_command(const LowCommand& command) {
  if (const std::uint32_t right = checksum_of(command); command.crc != right) {
    return crc_.say(say_, fmt::format("a low-level command with the CRC 0x{:08x} was ignored: it should be 0x{:08x}",
                                      command.crc, right));
  }
  if (!is_finite(command)) return numbers_.say(say_, "a low-level command with a number that is none was ignored");
  if (command.mode_pr != static_cast<std::uint8_t>(AnkleMode::pitch_roll)) {
    return cranks_.say(say_,
                       "a low-level command in mode AB was ignored: ankles and waist are serial joints here (mode PR)");
  }
  stands_ = false;
  commands_.clear();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const LowCommand::Motor& motor = command.motors[i];
    MotorCommand& taken = commands_.emplace_back();
    if (motor.mode != 0) taken = {motor.q, motor.dq, motor.tau, motor.kp, motor.kd};
    taken.weight = 1;
  }
}

void UnitreeSoftware::answer(const Request& request) {
  const bool before = stands_;
  const Answer reply = switch_motion(request, stands_);
  if (stands_ != before) commands_.clear();
  if (link_ && !request.no_reply && !outside_.remembers()) link_->answer(reply);
}

void UnitreeSoftware::command() {
  if (cycle_ == 0) {
    for (std::size_t joint = 0; joint < held_.size(); ++joint) held_[joint] = target_[objects_[joint]];
  }
  for (std::size_t joint = 0; joint < places_.size(); ++joint) command_joint(joint);
}

/// A motor without a position gain follows no target: levels without servos hold such a joint where it is.
void UnitreeSoftware::command_joint(std::size_t joint) {
  MUROSIMF_ASSERT(joint < held_.size());
  if (stands_) {
    held_[joint] = target_[objects_[joint]];
    return low_level_.leave_to_motions(joint);
  }
  const float present = joints_.motors()[joint].q;
  if (!commands_.empty()) {
    MotorCommand given = commands_[joint];
    if (given.kp == 0) given.q = present;
    return low_level_.drive(joint, given, held_[joint]);
  }
  if (stands_first_) return low_level_.hold(joint, held_[joint]);
  low_level_.drive(joint, {.q = present, .weight = 1}, held_[joint]);
}

void UnitreeSoftware::send(Duration now) {
  const std::chrono::milliseconds clock = std::chrono::duration_cast<std::chrono::milliseconds>(now);
  LowState state{.mode_machine = kind_of_robot,
                 .tick = static_cast<std::uint32_t>(clock.count()),
                 .imu = pelvis_.imu(),
                 .count = places_.size()};
  std::ranges::copy(joints_.motors(), state.motors.begin());
  message_.clear();
  write_low_state(message_, state);
  link_->low_state().write(message_.bytes());
  if (!torso_) return;
  message_.clear();
  write_imu(message_, torso_->imu());
  link_->torso_imu().write(message_.bytes());
}

void UnitreeSoftware::state(StateArchive& archive) {
  archive(stands_, joints_, pelvis_, held_, commands_, cycle_);
  if (torso_) archive(*torso_);
  if (archive.loads()) outside_.rewind();
}

}  // namespace murosimf::dds::unitree
