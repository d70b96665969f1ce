// Measured values of a servo, as shown in its registers.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "murosimf/serial/dynamixel/servo_device.h"

namespace murosimf::serial::dynamixel {
namespace {

/// Rounds for a register; 0 if not finite.
std::int32_t rounded(double value) {
  constexpr double most = 1 << 30;
  return std::isfinite(value) ? static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most))) : 0;
}

}  // namespace

void ServoDevice::show_position(Item item, double pulses) {
  std::int64_t shown = std::int64_t{rounded(pulses)} + offset();
  const auto turn = static_cast<std::int64_t>(table().pulses_per_turn);
  const bool within_a_turn = old() && registers().has(Item::position_offset) && !table().feetech;
  if (within_a_turn && mode() != Mode::extended) shown = (shown % turn + turn) % turn;
  constexpr std::int64_t most = INT32_MAX;
  memory().set(item, static_cast<std::int32_t>(std::clamp(shown, -most, most)));
}

void ServoDevice::show_motion(double velocity) {
  const std::int32_t counts = rounded(velocity / units().velocity);
  memory().set(Item::present_velocity, counts);
  const bool on_its_way = torque() && !turns() && !pushes() && trajectory_ != goal_;
  const double threshold = registers().has(Item::moving_threshold) ? registers().get(Item::moving_threshold) : 5;
  const bool fast = std::abs(counts) > threshold;
  memory().set(Item::moving, fast || (old() && on_its_way) ? 1 : 0);
  constexpr double at_goal = 20;  // [pulses]
  const bool arrived = std::abs(goal_ - present_) <= at_goal;
  memory().set(Item::moving_status, (arrived ? 1 : 0) | (on_its_way ? 2 : 0));
}

/// The duty cycle that a motor needs for its torque and its speed: u = M / M_stall + w / w_no_load.
void ServoDevice::show_load(double torque, double velocity) {
  const double stall_torque = options_.stall_torque > 0 ? options_.stall_torque : units().stall_torque;
  const double no_load_speed = options_.no_load_speed > 0 ? options_.no_load_speed : units().no_load_speed;
  const bool known = std::isfinite(torque);
  const double share = known ? torque / stall_torque : 0;
  load_ = driven_ && options_.stall_torque > 0 ? std::abs(share) : 0;  // only if simulated
  memory().set(Item::present_load, rounded(std::clamp(1000 * share, -1000.0, 1000.0)));
  const double duty = known && this->torque() ? share + (no_load_speed > 0 ? velocity / no_load_speed : 0) : 0;
  memory().set(Item::present_pwm, rounded(units().full_torque * std::clamp(duty, -1.0, 1.0)));
  if (units().current <= 0) return;
  constexpr std::int32_t zero_current = 2048;  // of Dynamixel 1.0
  const double current = known ? torque * units().stall_current / units().stall_torque : 0;
  const bool about_zero = old() && !table().feetech;
  memory().set(Item::present_current, rounded(current / units().current) + (about_zero ? zero_current : 0));
}

/// Updates the error bits: in 1.0 they last as long as their cause, in 2.0 until the servo restarts.
void ServoDevice::look_for_errors() {
  const Registers& at = registers();
  const std::int32_t voltage = at.get(Item::present_voltage);
  std::uint8_t errors = overloaded_ ? error_v1::overload : 0;
  if (voltage < at.get(Item::lowest_voltage) || voltage > at.get(Item::highest_voltage)) errors |= error_v1::voltage;
  if (at.get(Item::present_temperature) > at.get(Item::temperature_limit)) errors |= error_v1::overheating;
  errors_ = old() ? errors : errors_ | errors;
  memory().set(Item::hardware_error, errors_);
  if ((errors_ & at.get(Item::shutdown)) == 0) return;
  memory().set(Item::torque_enable, 0);
  was_on_ = false;
}

std::uint8_t ServoDevice::alarm() const {
  if (old()) return errors_;
  return errors_ != 0 ? error_v2::alert : 0;
}

void ServoDevice::sense(const ServoSense& sense, double now) {
  constexpr double room = 25;
  const double way = direction();
  driven_ = sense.driven;
  present_ = table().pulses_of(way * sense.angle) - turns_;
  if (!sensed_) count_turns();
  show_position(Item::present_position, present_);
  show_motion(way * sense.velocity);
  show_load(way * sense.torque, way * sense.velocity);
  const Field* voltage = table().find(Item::present_voltage);
  const double nominal = voltage ? 0.1 * voltage->initial : 0;
  memory().set(Item::present_voltage, rounded(10 * (std::isfinite(sense.voltage) ? sense.voltage : nominal)));
  memory().set(Item::present_temperature, rounded(std::isfinite(sense.temperature) ? sense.temperature : room));
  memory().set(Item::realtime_tick, static_cast<std::int32_t>(std::llround(1000 * now) % 32768));
  look_for_errors();
  if (!std::exchange(sensed_, true)) stay();  // the torque may be enabled from the start
  // remembered here, since looking for errors may have switched it off
  was_on_ = torque();
}

}  // namespace murosimf::serial::dynamixel
