#include "murosimf/connect/dynamixel/servo_device.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace murosimf::connect::dynamixel {
namespace {

constexpr double pulses_per_radian = pulses_per_turn / (2 * std::numbers::pi);
constexpr std::int32_t clockwise = 0x400;    // bit of velocities and loads of 1.0
constexpr std::int32_t largest = 0x3FF;      // beside it
constexpr std::int32_t zero_current = 2048;  // of 1.0
constexpr double at_goal = 20;               // [pulses]

double pulses_of(double angle) { return middle_pulse + angle * pulses_per_radian; }
double angle_of(double pulses) { return (pulses - middle_pulse) / pulses_per_radian; }

std::int32_t rounded(double value) {
  constexpr double most = 1 << 30;
  return std::isfinite(value) ? static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most))) : 0;
}

}  // namespace

ServoDevice::ServoDevice(const ControlTable& table, std::uint8_t id, const ServoOptions& options)
    : BusDevice(table, id), options_(options), present_(middle_pulse), goal_(middle_pulse), trajectory_(middle_pulse) {
  memory().set(Item::torque_enable, options.torque ? 1 : 0);
}

ServoDevice::Mode ServoDevice::mode() const {
  if (!old()) {
    const std::int32_t mode = registers().get(Item::operating_mode);
    return mode == 1 ? Mode::velocity : mode == 4 ? Mode::extended : Mode::position;
  }
  const std::int32_t low = registers().get(Item::lowest_position), high = registers().get(Item::highest_position);
  if (low == 0 && high == 0) return Mode::velocity;
  return low == 4095 && high == 4095 ? Mode::extended : Mode::position;
}

std::int32_t ServoDevice::offset() const {
  constexpr std::int32_t most_in_one_turn = 1024;
  const std::int32_t offset = registers().get(Item::position_offset);
  if (mode() == Mode::extended) return offset;
  return !old() && std::abs(offset) <= most_in_one_turn ? offset : 0;
}

bool ServoDevice::eeprom_locked() const { return registers().get(old() ? Item::lock : Item::torque_enable) != 0; }

Refusal ServoDevice::check(const Field& field, std::int32_t value) const {
  const Registers& at = registers();
  switch (field.item) {
    case Item::goal_position: {
      if (mode() != Mode::position) return Refusal::none;
      const bool inside = value >= at.get(Item::lowest_position) && value <= at.get(Item::highest_position);
      return inside ? Refusal::none : Refusal::limit;
    }
    case Item::goal_velocity:
      return old() || std::abs(value) <= at.get(Item::velocity_limit) ? Refusal::none : Refusal::limit;
    case Item::operating_mode: return value == 2 ? Refusal::range : Refusal::none;
    case Item::torque_enable:
      return value != 0 && (errors_ & at.get(Item::shutdown)) != 0 ? Refusal::failed : Refusal::none;
    default: return Refusal::none;
  }
}

/// The goal is where the shaft is.
void ServoDevice::stay() {
  goal_ = trajectory_ = present_;
  velocity_ = 0;
  show_position(Item::goal_position, present_);
}

void ServoDevice::written(const Field& field) {
  switch (field.item) {
    case Item::torque_enable:
    case Item::operating_mode: return stay();
    case Item::lowest_position:
    case Item::highest_position:
      if (old()) stay();  // the limits say the mode
      return;
    case Item::goal_position: {
      const std::int32_t goal = registers().get(Item::goal_position);
      if (old() && !torque()) {  // a goal switches the torque on
        memory().set(Item::torque_enable, 1);
        stay();
        memory().set(Item::goal_position, goal);
      }
      goal_ = goal - offset();
      return;
    }
    default: return;
  }
}

void ServoDevice::restarted() {
  errors_ = 0;
  stay();
}

Refusal ServoDevice::clear(ByteView parameters) {
  constexpr std::uint8_t turns[] = {0x01, 0x44, 0x58, 0x4C, 0x22};
  if (!std::ranges::equal(parameters, turns)) return Refusal::range;
  return registers().get(Item::moving) != 0 ? Refusal::failed
                                            : Refusal::none;  // it counts no turns that it could forget
}

double ServoDevice::wanted_velocity() const {
  const std::int32_t raw = registers().get(Item::goal_velocity);
  std::int32_t counts = raw;
  if (old()) counts = (raw & clockwise) != 0 ? -(raw & largest) : raw & largest;
  return counts * registers().table().units.velocity;
}

/// [pulses/s] on the way to a position.
double ServoDevice::fastest() const {
  const std::int32_t counts =
      registers().get(old() ? Item::goal_velocity : Item::profile_velocity) & (old() ? largest : 0x7FFF);
  if (counts == 0) return std::numeric_limits<double>::infinity();
  return counts * registers().table().units.velocity * pulses_per_radian;
}

void ServoDevice::advance(double dt) {
  const double before = trajectory_;
  if (!torque()) {
    trajectory_ = present_;
  } else if (mode() == Mode::velocity) {
    const double next = trajectory_ + wanted_velocity() * pulses_per_radian * dt;
    trajectory_ = std::clamp(next, pulses_of(options_.lowest), pulses_of(options_.highest));
  } else {
    const double most = fastest() * dt;
    trajectory_ += std::clamp(goal_ - trajectory_, -most, most);
  }
  velocity_ = torque() && trajectory_ != goal_ && dt > 0 ? (trajectory_ - before) / dt : 0;
  show_position(Item::position_trajectory, trajectory_);
  memory().set(Item::velocity_trajectory, rounded(velocity_ / pulses_per_radian / registers().table().units.velocity));
}

double ServoDevice::target() const { return std::clamp(angle_of(trajectory_), options_.lowest, options_.highest); }

double ServoDevice::target_velocity() const { return torque() && turns() ? wanted_velocity() : 0; }

void ServoDevice::show_position(Item item, double pulses) {
  std::int32_t shown = rounded(pulses) + offset();
  constexpr auto turn = static_cast<std::int32_t>(pulses_per_turn);
  if (old() && mode() != Mode::extended) shown = (shown % turn + turn) % turn;
  memory().set(item, shown);
}

std::int32_t ServoDevice::with_direction(double counts) const {
  const std::int32_t value = rounded(counts);
  if (!old()) return value;
  return std::min(std::abs(value), largest) | (value < 0 ? clockwise : 0);
}

void ServoDevice::show_motion(double velocity) {
  const double counts = velocity / registers().table().units.velocity;
  memory().set(Item::present_velocity, with_direction(counts));
  const bool on_its_way = torque() && mode() != Mode::velocity && trajectory_ != goal_;
  const double threshold = registers().has(Item::moving_threshold) ? registers().get(Item::moving_threshold) : 5;
  const bool fast = std::abs(rounded(counts)) > threshold;
  memory().set(Item::moving, fast || (old() && on_its_way) ? 1 : 0);
  const bool arrived = std::abs(goal_ - present_) <= at_goal;
  memory().set(Item::moving_status, (arrived ? 1 : 0) | (on_its_way ? 2 : 0));
}

void ServoDevice::show_load(double torque) {
  const ServoUnits& units = registers().table().units;
  const double stall_torque = options_.stall_torque > 0 ? options_.stall_torque : units.stall_torque;
  const double share = std::isfinite(torque) ? torque / stall_torque : 0;
  memory().set(Item::present_load, with_direction(std::clamp(1000 * share, -1000.0, 1000.0)));
  if (units.current <= 0) return;
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
}

void ServoDevice::state(StateArchive& archive) {
  BusDevice::state(archive);
  archive(present_, goal_, trajectory_, velocity_, errors_);
}

}  // namespace murosimf::connect::dynamixel
