#include "murosimf/serial/dynamixel/servo_device.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::serial::dynamixel {
namespace {

constexpr std::int32_t current_based = 5;  // operating mode
constexpr std::int32_t reverse_bit = 1, second_servo_bit = 2, time_based_bit = 4,
                       goal_switches_on_bit = 8;  // drive mode

}  // namespace

ServoDevice::ServoDevice(const ControlTable& table, std::uint8_t id, const ServoOptions& options)
    : BusDevice(table, id),
      options_(options),
      present_(table.middle_pulse),
      goal_(table.middle_pulse),
      trajectory_(table.middle_pulse) {
  memory().set(Item::torque_enable, options.torque ? 1 : 0);
  was_on_ = options.torque;
}

bool ServoDevice::has_drive_mode(std::int32_t bit) const { return (registers().get(Item::drive_mode) & bit) != 0; }

ServoDevice::Mode ServoDevice::mode() const {
  if (registers().has(Item::operating_mode)) {
    switch (registers().get(Item::operating_mode)) {
      case 0: return old() ? Mode::position : Mode::torque;
      case 1: return Mode::velocity;
      case 4:
      case current_based: return Mode::extended;
      case 16: return Mode::pwm;
      default: return Mode::position;
    }
  }
  const std::int32_t low = registers().get(Item::lowest_position), high = registers().get(Item::highest_position);
  if (low == 0 && high == 0) return Mode::velocity;
  const bool several_turns = registers().has(Item::position_offset) && low == 4095 && high == 4095;
  return several_turns ? Mode::extended : Mode::position;
}

/// The protocols and vendors differ in sign and range of the offset.
std::int32_t ServoDevice::offset() const {
  constexpr std::int32_t most_in_one_turn = 1024;
  const std::int32_t offset = registers().get(Item::position_offset);
  if (table().feetech) return -offset;
  if (mode() == Mode::extended) return offset;
  return !old() && std::abs(offset) <= most_in_one_turn ? offset : 0;
}

double ServoDevice::direction() const { return has_drive_mode(reverse_bit) ? -1 : 1; }

/// [rad] End stops of the shaft in the servo's direction of counting.
double ServoDevice::lowest() const { return direction() > 0 ? options_.lowest : -options_.highest; }
double ServoDevice::highest() const { return direction() > 0 ? options_.highest : -options_.lowest; }

bool ServoDevice::eeprom_locked() const {
  if (table().feetech) return false;
  return registers().get(old() ? Item::lock : Item::torque_enable) != 0;
}

Refusal ServoDevice::check_goal(const Field& field, std::int32_t value) const {
  const Registers& at = registers();
  if (watchdog_has_fired()) return Refusal::range;
  const auto within = [&](Item limit) { return !at.has(limit) || std::abs(value) <= at.get(limit); };
  switch (field.item) {
    case Item::goal_position: {
      if (mode() != Mode::position) return Refusal::none;
      const bool inside = value >= at.get(Item::lowest_position) && value <= at.get(Item::highest_position);
      return inside ? Refusal::none : Refusal::limit;
    }
    case Item::goal_velocity: return within(Item::velocity_limit) ? Refusal::none : Refusal::limit;
    case Item::goal_pwm: return within(Item::pwm_limit) ? Refusal::none : Refusal::limit;
    case Item::goal_current: return within(Item::current_limit) ? Refusal::none : Refusal::limit;
    default: return Refusal::none;
  }
}

Refusal ServoDevice::check(const Field& field, std::int32_t value) const {
  const std::vector<std::int32_t>& modes = table().operating_modes;
  switch (field.item) {
    case Item::goal_position:
    case Item::goal_velocity:
    case Item::goal_pwm:
    case Item::goal_current:
    case Item::profile_acceleration:
    case Item::profile_velocity: return check_goal(field, value);
    case Item::operating_mode: return std::ranges::find(modes, value) != modes.end() ? Refusal::none : Refusal::range;
    case Item::drive_mode: return (value & second_servo_bit) != 0 ? Refusal::range : Refusal::none;
    case Item::baud_rate: return table().baud_rate(value) > 0 ? Refusal::none : Refusal::range;
    case Item::bus_watchdog: return value < 0 ? Refusal::range : Refusal::none;
    case Item::torque_enable: {
      const bool forbidden = (errors_ & registers().get(Item::shutdown)) != 0 && !(old() && overloaded_);
      return value != 0 && forbidden ? Refusal::failed : Refusal::none;
    }
    default: return Refusal::none;
  }
}

/// Sets the goal to the present position.
void ServoDevice::stay() {
  goal_ = trajectory_ = present_;
  velocity_ = integral_ = 0;
  show_position(Item::goal_position, present_);
}

/// Commands of the new mode start at zero, limits at their maximum.
void ServoDevice::change_mode() {
  if (mode() == Mode::position) count_turns();
  stay();
  if (old()) return;
  memory().set(Item::profile_velocity, 0);
  memory().set(Item::profile_acceleration, 0);
  memory().set(Item::goal_velocity, 0);
  memory().set(Item::goal_pwm, mode() == Mode::pwm ? 0 : registers().get(Item::pwm_limit));
  memory().set(Item::goal_current, mode() == Mode::torque ? 0 : registers().get(Item::current_limit));
}

/// Reverses the direction of counting.
void ServoDevice::turn_round() {
  present_ = 2 * table().middle_pulse - present_ - turns_;
  turns_ = 0;
  stay();
}

/// Counts turns as after power-on: the encoder measures the angle within one turn.
void ServoDevice::count_turns() {
  const double all = present_ + turns_;
  turns_ = std::floor(all / table().pulses_per_turn) * table().pulses_per_turn;
  present_ = all - turns_;
}

void ServoDevice::switch_torque() {
  if (torque() != was_on_) stay();
  if (torque() && old()) overloaded_ = false;
  if (torque()) loaded_for_ = silent_ = 0;
  was_on_ = torque();
}

void ServoDevice::take_goal() {
  const std::int32_t goal = registers().get(Item::goal_position);
  if (!torque() && (old() || has_drive_mode(goal_switches_on_bit))) {
    memory().set(Item::torque_enable, 1);
    switch_torque();
    memory().set(Item::goal_position, goal);
  }
  goal_ = static_cast<double>(goal) - offset();
  constexpr double ms = 1e-3;
  const double all = ms * registers().get(Item::profile_velocity);
  // The acceleration time is part of the total time, at most half of it: a trapezoid or a triangle.
  const double rise = std::min(ms * registers().get(Item::profile_acceleration), 0.5 * all);
  timed_speed_ = all > 0 ? std::abs(goal_ - trajectory_) / (all - rise) : 0;
  timed_rise_ = rise > 0 ? timed_speed_ / rise : 0;
}

void ServoDevice::written(const Field& field) {
  switch (field.item) {
    case Item::torque_enable: return switch_torque();
    case Item::operating_mode: return change_mode();
    case Item::drive_mode: return turn_round();
    case Item::lowest_position:
    case Item::highest_position:
      if (!registers().has(Item::operating_mode)) stay();  // the limits determine the mode
      return;
    case Item::goal_position: return take_goal();
    case Item::bus_watchdog: silent_ = 0; return;
    default: return;
  }
}

/// Turns are counted anew from the present position, and the goal is there: the servo does not jump.
void ServoDevice::restarted() {
  errors_ = 0;
  overloaded_ = false;
  loaded_for_ = silent_ = 0;
  count_turns();
  stay();
  was_on_ = torque();
}

/// The manual asks for these bytes, so that turns are not cleared by accident.
Refusal ServoDevice::clear(ByteView parameters) {
  constexpr std::uint8_t all_turns[] = {0x01, 0x44, 0x58, 0x4C, 0x22};
  if (!std::ranges::equal(parameters, all_turns)) return Refusal::range;
  if (registers().get(Item::moving) != 0) return Refusal::failed;
  count_turns();
  show_position(Item::present_position, present_);
  stay();
  return Refusal::none;
}

/// [rad/s] Commanded velocity.
double ServoDevice::wanted_velocity() const { return registers().get(Item::goal_velocity) * units().velocity; }

/// [pulses/s] Velocity limit on the way to a position.
double ServoDevice::fastest() const {
  constexpr double any = std::numeric_limits<double>::infinity();
  if (has_drive_mode(time_based_bit) && !old()) return timed_speed_ > 0 ? timed_speed_ : any;
  const bool own = registers().has(Item::profile_velocity);
  const std::int32_t counts = std::abs(registers().get(own ? Item::profile_velocity : Item::goal_velocity));
  return counts == 0 ? any : counts * units().velocity * table().pulses_per_radian();
}

/// [pulses/s^2]
double ServoDevice::acceleration() const {
  constexpr double any = std::numeric_limits<double>::infinity();
  if (has_drive_mode(time_based_bit) && !old() && !turns()) return timed_rise_ > 0 ? timed_rise_ : any;
  const std::int32_t counts = registers().get(Item::profile_acceleration);
  const double one = units().acceleration * table().pulses_per_radian();
  return counts == 0 || one <= 0 ? any : counts * one;
}

double ServoDevice::gain_share() const {
  const Field* field = table().find(Item::position_p_gain);
  if (!field || field->initial <= 0 || pushes()) return 1;
  return static_cast<double>(registers().get(Item::position_p_gain)) / field->initial;
}

double ServoDevice::damping_time() const {
  const Field* p_gain = table().find(Item::position_p_gain);
  const Field* d_gain = table().find(Item::position_d_gain);
  if (!p_gain || !d_gain || p_gain->initial <= 0 || units().p_gain <= 0 || pushes()) return 0;
  const double more = std::max(0, registers().get(Item::position_d_gain) - d_gain->initial);
  return more * units().d_gain / (p_gain->initial * units().p_gain);
}

double ServoDevice::torque_share() const {
  const Registers& at = registers();
  const Item limit = at.has(Item::goal_pwm) ? Item::goal_pwm : Item::torque_limit;
  const double share = at.has(limit) ? std::abs(at.get(limit)) / units().full_torque : 1;
  const bool by_current = mode() == Mode::torque || (!old() && at.get(Item::operating_mode) == current_based);
  if (!by_current || units().stall_current <= 0) return share;
  return std::min(share, std::abs(at.get(Item::goal_current)) * units().current / units().stall_current);
}

/// Limits the integral to the error that yields full torque by itself: no windup beyond saturation.
void ServoDevice::integrate(double dt) {
  MUROSIMF_ASSERT(dt >= 0);
  const double p = registers().get(Item::position_p_gain) * units().p_gain;
  const double i = registers().get(Item::position_i_gain) * units().i_gain;
  if (!torque() || turns() || pushes() || p <= 0 || i <= 0) {
    integral_ = 0;
    return;
  }
  const double most = options_.full_error * torque_share() / gain_share();
  integral_ += i / p * (table().angle_of(trajectory_) - table().angle_of(present_)) * dt;
  integral_ = std::clamp(integral_, -most, most);
}

/// Stops if no instruction has arrived for the period of the bus watchdog, in units of 20 ms.
void ServoDevice::watch_bus(double dt) {
  constexpr double unit = 0.02, rounding = 1e-9;  // [s]
  const std::int32_t limit = registers().get(Item::bus_watchdog);
  if (limit <= 0 || !torque()) return;
  silent_ += dt;
  if (silent_ <= unit * limit + rounding) return;
  memory().set(Item::bus_watchdog, -1);
  memory().set(Item::goal_velocity, 0);
  if (mode() == Mode::pwm) memory().set(Item::goal_pwm, 0);
  if (mode() == Mode::torque) memory().set(Item::goal_current, 0);
  stay();
}

/// Detects an overload that lasts too long.
void ServoDevice::watch_load(double dt) {
  const Registers& at = registers();
  const bool own = at.has(Item::overload_torque) && at.has(Item::overload_time);
  const double most = own ? 0.01 * at.get(Item::overload_torque) : overload_share;
  const double longest = own ? 0.01 * at.get(Item::overload_time) : overload_time;
  loaded_for_ = torque() && load_ >= most ? loaded_for_ + dt : 0;
  if (loaded_for_ > longest) overloaded_ = true;
}

/// Moves with the velocity and acceleration of the profile; without an acceleration at constant velocity.
void ServoDevice::follow_profile(double dt) {
  const double left = goal_ - trajectory_, rise = acceleration();
  MUROSIMF_ASSERT(dt >= 0);
  if (!std::isfinite(rise)) {
    const double most = fastest() * dt;
    trajectory_ += std::clamp(left, -most, most);
    return;
  }
  // velocity from which the rest is just enough for braking: v dt + v^2 / (2 a) = |left|
  const double stopping = rise * (std::sqrt(dt * dt + 2 * std::abs(left) / rise) - dt);
  const double wanted = std::copysign(std::min(fastest(), stopping), left);
  velocity_ += std::clamp(wanted - velocity_, -rise * dt, rise * dt);
  const double step = velocity_ * dt;
  // half a pulse: below the resolution of the register, so that the goal is reached exactly
  const bool arrives = std::abs(left - step) < 0.5 && std::abs(velocity_) <= 2 * rise * dt;
  trajectory_ = arrives ? goal_ : trajectory_ + step;
}

void ServoDevice::follow_rate(double dt) {
  const double wanted = wanted_velocity() * table().pulses_per_radian(), rise = acceleration();
  velocity_ = std::isfinite(rise) ? velocity_ + std::clamp(wanted - velocity_, -rise * dt, rise * dt) : wanted;
  const double next = trajectory_ + velocity_ * dt;
  trajectory_ = std::clamp(next, table().pulses_of(lowest()) - turns_, table().pulses_of(highest()) - turns_);
}

void ServoDevice::advance(double dt) {
  const double before = trajectory_;
  pass(dt);
  watch_bus(dt);
  watch_load(dt);
  if (!torque()) {
    trajectory_ = present_;
    velocity_ = 0;
  } else if (turns()) {
    follow_rate(dt);
  } else if (pushes()) {  // a goal far ahead: the torque limit then determines the torque
    const std::int32_t push = registers().get(mode() == Mode::pwm ? Item::goal_pwm : Item::goal_current);
    const double far = driven_ && push != 0 ? std::copysign(table().pulses_per_turn, push) : 0.0;
    trajectory_ = present_ + far;
    velocity_ = 0;
  } else {
    follow_profile(dt);
    velocity_ = trajectory_ != goal_ && dt > 0 ? (trajectory_ - before) / dt : 0;
  }
  integrate(dt);
  show_position(Item::position_trajectory, trajectory_);
  const double rate = velocity_ / table().pulses_per_radian() / units().velocity;
  memory().set(Item::velocity_trajectory, static_cast<std::int32_t>(std::lround(std::clamp(rate, -1e9, 1e9))));
}

double ServoDevice::target() const {
  return direction() * std::clamp(table().angle_of(trajectory_ + turns_) + integral_, lowest(), highest());
}

double ServoDevice::target_velocity() const {
  if (!torque() || !turns()) return 0;
  const double rate = std::isfinite(acceleration()) ? velocity_ / table().pulses_per_radian() : wanted_velocity();
  return direction() * rate;
}

void ServoDevice::state(StateArchive& archive) {
  BusDevice::state(archive);
  archive(present_, turns_, goal_, trajectory_, velocity_, timed_speed_, timed_rise_, integral_, silent_, load_,
          loaded_for_, errors_, overloaded_, driven_, sensed_);
}

}  // namespace murosimf::serial::dynamixel
