#include "murosimf/dds/low_level.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::dds {

LowLevel::LowLevel(control_software::RobotPort& port, std::vector<std::size_t> places)
    : places_(std::move(places)), engine_(port.command("motion.joints")), target_(port.command("joint.target")) {
  const auto row = [&](const char* name) { return Row{port.command(name), port.range(name)}; };
  targets_ = row("joint.target");
  rates_ = row("joint.velocity_target");
  position_gains_ = row("joint.position_gain");
  velocity_gains_ = row("joint.velocity_gain");
  torques_ = row("joint.feed_forward");
  for (const std::size_t place : places_) {
    own_kp_.push_back(position_gains_.command->values[place]);
    own_kd_.push_back(velocity_gains_.command->values[place]);
  }
}

/// Clamped: a program's numbers beyond the joint's are not refused, as by the real one's firmware.
void LowLevel::set(std::size_t joint, const Numbers& numbers, bool by_engine) {
  MUROSIMF_ASSERT(joint < places_.size());
  const std::size_t i = places_[joint];
  const auto put = [i](const Row& row, double value) {
    row.command->values[i] = std::clamp(value, row.range.lowest[i], row.range.highest[i]);
  };
  engine_->values[i] = by_engine ? 1 : 0;
  put(targets_, numbers.q);
  put(rates_, numbers.rate);
  put(position_gains_, numbers.kp);
  put(velocity_gains_, numbers.kd);
  put(torques_, numbers.torque);
}

void LowLevel::leave_to_motions(std::size_t joint) {
  set(joint, {.q = target(joint), .kp = own_kp_[joint], .kd = own_kd_[joint]}, true);
}

void LowLevel::damp(std::size_t joint, double q) { set(joint, {.q = q, .kd = own_kd_[joint]}, false); }

void LowLevel::hold(std::size_t joint, double q) {
  set(joint, {.q = q, .kp = own_kp_[joint], .kd = own_kd_[joint]}, false);
}

void LowLevel::drive(std::size_t joint, const MotorCommand& command, double held) {
  const double w = std::clamp(static_cast<double>(command.weight), 0.0, 1.0);
  const auto blend = [w](double own, double given) { return own + w * (given - own); };
  set(joint,
      {.q = blend(held, command.q),
       .rate = w * command.dq,
       .kp = blend(own_kp_[joint], command.kp),
       .kd = blend(own_kd_[joint], command.kd),
       .torque = w * command.tau},
      false);
}

}  // namespace murosimf::dds
