#include "murosimf/dynamics/servo/servo_condition.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

/// An input whose rows have different start values.
template <class Start>
std::span<const double> input_of_servos(Setup& setup, const Property<double>& property, const Start& start) {
  const bool fresh = setup.entity().find(property) == nullptr;
  const auto values = setup.input(property, 0.0);
  Column<double>& column = setup.entity().column(property);
  for (const int i : setup.model().having(properties::servo)) {
    const bool only_observed = std::isnan(column.values[i]);
    if (fresh || only_observed) column.values[i] = start(*setup.model().find(properties::servo, i));
  }
  return values;
}

}  // namespace

ServoCondition::ServoCondition(Setup& setup, std::string_view law)
    : motors_(static_cast<std::size_t>(setup.model().size())) {
  const Model& model = setup.model();
  if (model.having(properties::servo).empty()) return;
  supply_ = input_of_servos(setup, properties::supply_voltage, [](const Servo& servo) { return servo.voltage; });
  enabled_ = input_of_servos(setup, properties::torque_enabled, [](const Servo&) { return 1.0; });
  find_tuning(setup);
  bool heat = false;
  for (const int i : model.having(properties::servo)) {
    const Servo& servo = *model.find(properties::servo, i);
    if (servo.voltage > 0) motors_[i].per_volt = 1 / servo.voltage;
    if (servo.heat.heat_capacity <= 0 || with_law(servo, law).law != "dc_motor") continue;
    if (servo.voltage <= 0) {
      throw SetupError(fmt::format("servo '{}' needs voltage, because of heat_capacity", servo.type));
    }
    motors_[i].heats = heat = true;
    motors_[i].numbers = multibody::ServoMotor(servo);
  }
  if (!heat) return;
  const bool known = setup.entity().find(properties::servo_temperature) != nullptr;
  temperature_ = setup.write(properties::servo_temperature);
  const auto heats = std::ranges::find_if(motors_, [](const Motor& motor) { return motor.heats; });
  fresh_ = !known || std::isnan(temperature_[heats - motors_.begin()]);  // NaN: only observed so far
}

void ServoCondition::find_tuning(Setup& setup) {
  const auto wanted = [&](const Property<double>& property) {
    const bool any = setup.entity().find(property) != nullptr;
    tunes_ = tunes_ || any;
    return any ? setup.observe(property) : std::span<const double>{};
  };
  position_gain_ = wanted(properties::servo_position_gain);
  velocity_gain_ = wanted(properties::servo_velocity_gain);
  torque_limit_ = wanted(properties::servo_torque_limit);
  feed_forward_ = wanted(properties::servo_feed_forward);
  target_rate_ = wanted(properties::joint_velocity_target);
  for (const int i : setup.model().having(properties::servo)) {
    const Servo& servo = *setup.model().find(properties::servo, i);
    motors_[i].position_gain = servo.position_gain;
    motors_[i].velocity_gain = servo.law == "ideal_pd" ? servo.velocity_gain : 0;
    motors_[i].stall_torque = servo.stall_torque;
  }
}

void ServoCondition::cool_down() noexcept {
  for (std::size_t i = 0; i < temperature_.size(); ++i) {
    temperature_[i] = motors_[i].numbers.heat.ambient_temperature;
  }
}

void ServoCondition::take_over() noexcept {
  if (fresh_) cool_down();
}

void ServoCondition::fill(int i, MotorInput& input) const noexcept {
  const Motor& motor = motors_[i];
  MUROSIMF_ASSERT(i >= 0 && static_cast<std::size_t>(i) < motors_.size());
  input.enabled = enabled_[i];
  if (tunes_) tune(i, input);
  if (motor.per_volt > 0) input.supply = supply_[i] * motor.per_volt;
  if (!motor.heats) return;
  input.conductance = multibody::winding_conductance(temperature_[i]);
  input.allowed = multibody::allowed_share(motor.numbers.heat, temperature_[i]);
}

/// NaN: software has set nothing. A limit of the stall torque or more is none: braking may take more than the stall torque.
void ServoCondition::tune(int i, MotorInput& input) const noexcept {
  const Motor& motor = motors_[i];
  MUROSIMF_ASSERT(i >= 0 && static_cast<std::size_t>(i) < motors_.size());
  if (!position_gain_.empty() && motor.position_gain > 0 && position_gain_[i] >= 0) {
    input.gain = position_gain_[i] / motor.position_gain;
  }
  if (!velocity_gain_.empty() && velocity_gain_[i] >= 0) input.damping = velocity_gain_[i] - motor.velocity_gain;
  if (!target_rate_.empty() && std::isfinite(target_rate_[i])) input.target_rate = target_rate_[i];
  if (!feed_forward_.empty() && std::isfinite(feed_forward_[i])) input.feed_forward = feed_forward_[i];
  if (torque_limit_.empty() || !(torque_limit_[i] >= 0)) return;
  if (motor.stall_torque <= 0 || torque_limit_[i] < motor.stall_torque) input.limit = torque_limit_[i];
}

void ServoCondition::warm(int i, double torque, double dt) noexcept {
  MUROSIMF_ASSERT(heats(i) && dt > 0);
  temperature_[i] = multibody::next_temperature(motors_[i].numbers, temperature_[i], torque, dt);
}

}  // namespace murosimf::dynamics
