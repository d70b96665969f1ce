// What a servo measures, as its registers show it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "murosimf/connect/dynamixel/servo_counts.h"
#include "murosimf/connect/dynamixel/servo_device.h"

namespace murosimf::connect::dynamixel {

void ServoDevice::show_position(Item item, double pulses) {
  std::int32_t shown = rounded(pulses) + offset();
  constexpr auto turn = static_cast<std::int32_t>(pulses_per_turn);
  if (old() && mode() != Mode::extended) shown = (shown % turn + turn) % turn;
  memory().set(item, shown);
}

std::int32_t ServoDevice::with_direction(double counts) const {
  const std::int32_t value = rounded(counts);
  if (!old()) return value;
  return std::min(std::abs(value), largest_size) | (value < 0 ? clockwise_bit : 0);
}

void ServoDevice::show_motion(double velocity) {
  const double counts = velocity / registers().table().units.velocity;
  memory().set(Item::present_velocity, with_direction(counts));
  const bool on_its_way = torque() && mode() != Mode::velocity && trajectory_ != goal_;
  const double threshold = registers().has(Item::moving_threshold) ? registers().get(Item::moving_threshold) : 5;
  const bool fast = std::abs(rounded(counts)) > threshold;
  memory().set(Item::moving, fast || (old() && on_its_way) ? 1 : 0);
  constexpr double at_goal = 20;  // [pulses]
  const bool arrived = std::abs(goal_ - present_) <= at_goal;
  memory().set(Item::moving_status, (arrived ? 1 : 0) | (on_its_way ? 2 : 0));
}

void ServoDevice::show_load(double torque) {
  const ServoUnits& units = registers().table().units;
  const double stall_torque = options_.stall_torque > 0 ? options_.stall_torque : units.stall_torque;
  const double share = std::isfinite(torque) ? torque / stall_torque : 0;
  memory().set(Item::present_load, with_direction(std::clamp(1000 * share, -1000.0, 1000.0)));
  if (units.current <= 0) return;
  constexpr std::int32_t zero_current = 2048;  // of 1.0
  const double current = std::isfinite(torque) ? torque * units.stall_current / units.stall_torque : 0;
  memory().set(Item::present_current, rounded(current / units.current) + (old() ? zero_current : 0));
}

/// Those of 1.0 last as long as their cause, those of 2.0 until the servo starts again.
void ServoDevice::look_for_errors() {
  const Registers& at = registers();
  const std::int32_t voltage = at.get(Item::present_voltage);
  std::uint8_t errors = 0;
  if (voltage < at.get(Item::lowest_voltage) || voltage > at.get(Item::highest_voltage)) errors |= error_v1::voltage;
  if (at.get(Item::present_temperature) > at.get(Item::temperature_limit)) errors |= error_v1::overheating;
  errors_ = old() ? errors : errors_ | errors;
  memory().set(Item::hardware_error, errors_);
  if ((errors_ & at.get(Item::shutdown)) != 0) memory().set(Item::torque_enable, 0);
}

std::uint8_t ServoDevice::alarm() const {
  if (old()) return errors_;
  return errors_ != 0 ? error_v2::alert : 0;
}

void ServoDevice::sense(const ServoSense& sense, double now) {
  constexpr double nominal_voltage = 12, room = 25;
  present_ = pulses_of(sense.angle);
  show_position(Item::present_position, present_);
  show_motion(sense.velocity);
  show_load(sense.torque);
  memory().set(Item::present_voltage, rounded(10 * (std::isfinite(sense.voltage) ? sense.voltage : nominal_voltage)));
  memory().set(Item::present_temperature, rounded(std::isfinite(sense.temperature) ? sense.temperature : room));
  memory().set(Item::realtime_tick, static_cast<std::int32_t>(std::llround(1000 * now) % 32768));
  look_for_errors();
  if (!std::exchange(sensed_, true)) stay();  // its torque may be on from the start
  was_on_ = torque();
}

}  // namespace murosimf::connect::dynamixel
