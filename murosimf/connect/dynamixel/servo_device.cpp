#include "murosimf/connect/dynamixel/servo_device.h"

#include <algorithm>
#include <cmath>

#include "murosimf/connect/dynamixel/servo_counts.h"

namespace murosimf::connect::dynamixel {
namespace {

constexpr std::int32_t current_based = 5;  // operating mode

}  // namespace

ServoDevice::ServoDevice(const ControlTable& table, std::uint8_t id, const ServoOptions& options)
    : BusDevice(table, id), options_(options), present_(middle_pulse), goal_(middle_pulse), trajectory_(middle_pulse) {
  memory().set(Item::torque_enable, options.torque ? 1 : 0);
  was_on_ = options.torque;
}

ServoDevice::Mode ServoDevice::mode() const {
  if (!old()) {
    const std::int32_t mode = registers().get(Item::operating_mode);
    return mode == 1 ? Mode::velocity : mode == 4 || mode == current_based ? Mode::extended : Mode::position;
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
  velocity_ = integral_ = 0;
  show_position(Item::goal_position, present_);
}

void ServoDevice::written(const Field& field) {
  switch (field.item) {
    case Item::torque_enable:
      if (torque() != was_on_) stay();
      was_on_ = torque();
      return;
    case Item::operating_mode: return stay();
    case Item::lowest_position:
    case Item::highest_position:
      if (old()) stay();  // the limits say the mode
      return;
    case Item::goal_position: {
      const std::int32_t goal = registers().get(Item::goal_position);
      if (old() && !torque()) {  // a goal switches the torque on
        memory().set(Item::torque_enable, 1);
        was_on_ = true;
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
  if (old()) counts = (raw & clockwise_bit) != 0 ? -(raw & largest_size) : raw & largest_size;
  return counts * registers().table().units.velocity;
}

/// [pulses/s] on the way to a position.
double ServoDevice::fastest() const {
  const std::int32_t counts =
      registers().get(old() ? Item::goal_velocity : Item::profile_velocity) & (old() ? largest_size : 0x7FFF);
  if (counts == 0) return std::numeric_limits<double>::infinity();
  return counts * registers().table().units.velocity * pulses_per_radian;
}

double ServoDevice::gain_share() const {
  const Field& field = *registers().table().find(Item::position_p_gain);
  return static_cast<double>(registers().get(Item::position_p_gain)) / field.initial;
}

double ServoDevice::damping_time() const {
  const ServoUnits& units = registers().table().units;
  const double p = registers().table().find(Item::position_p_gain)->initial * units.p_gain;
  return registers().get(Item::position_d_gain) * units.d_gain / p;
}

double ServoDevice::torque_share() const {
  const Registers& at = registers();
  const ServoUnits& units = at.table().units;
  const double share = std::abs(at.get(Item::torque_limit)) / units.full_torque;
  if (old() || at.get(Item::operating_mode) != current_based) return share;
  return std::min(share, std::abs(at.get(Item::goal_current)) * units.current / units.stall_current);
}

/// Not beyond what gives all torque by itself.
void ServoDevice::integrate(double dt) {
  const ServoUnits& units = registers().table().units;
  const double p = registers().get(Item::position_p_gain) * units.p_gain;
  const double i = registers().get(Item::position_i_gain) * units.i_gain;
  if (!torque() || mode() == Mode::velocity || p <= 0 || i <= 0) {
    integral_ = 0;
    return;
  }
  const double most = options_.full_error * torque_share() / gain_share();
  integral_ += i / p * (angle_of(trajectory_) - angle_of(present_)) * dt;
  integral_ = std::clamp(integral_, -most, most);
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
  integrate(dt);
  velocity_ = torque() && trajectory_ != goal_ && dt > 0 ? (trajectory_ - before) / dt : 0;
  show_position(Item::position_trajectory, trajectory_);
  memory().set(Item::velocity_trajectory, rounded(velocity_ / pulses_per_radian / registers().table().units.velocity));
}

double ServoDevice::target() const {
  return std::clamp(angle_of(trajectory_) + integral_, options_.lowest, options_.highest);
}

double ServoDevice::target_velocity() const { return torque() && turns() ? wanted_velocity() : 0; }

void ServoDevice::state(StateArchive& archive) {
  BusDevice::state(archive);
  archive(present_, goal_, trajectory_, velocity_, integral_, errors_, sensed_);
}

}  // namespace murosimf::connect::dynamixel
