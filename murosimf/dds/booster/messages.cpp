#include "murosimf/dds/booster/messages.h"

#include <cmath>
#include <numbers>

namespace murosimf::dds::booster {
namespace {

void write_motors(CdrWriter& to, std::span<const MotorState> motors) {
  constexpr std::uint8_t mode = 0;
  constexpr std::uint32_t none = 0;
  to.number(static_cast<std::uint32_t>(motors.size()));
  for (const MotorState& motor : motors) {
    to.number(mode).number(motor.q).number(motor.dq).number(motor.ddq).number(motor.tau).number(motor.temperature);
    to.number(none).number(none).number(none);  // lost, reserve
  }
}

MotorCommand read_motor(CdrReader& from) {
  MotorCommand motor;
  (void)from.number<std::uint8_t>();  // mode
  for (float* const value : {&motor.q, &motor.dq, &motor.tau, &motor.kp, &motor.kd, &motor.weight})
    *value = from.number<float>();
  return motor;
}

bool is_finite(const MotorCommand& motor) {
  return std::isfinite(motor.q) && std::isfinite(motor.dq) && std::isfinite(motor.tau) && std::isfinite(motor.kp) &&
         std::isfinite(motor.kd) && std::isfinite(motor.weight);
}

}  // namespace

void write_low_state(CdrWriter& to, const ImuState& imu, std::span<const MotorState> motors) {
  for (const auto& row : {imu.rpy, imu.gyro, imu.acc}) {
    for (const float value : row) to.number(value);
  }
  write_motors(to, motors);
  write_motors(to, motors);
}

void write_odometer(CdrWriter& to, const Odometer& odometer) {
  to.number(odometer.x).number(odometer.y).number(odometer.theta);
}

void write_fall_down(CdrWriter& to, FallDown state, bool can_recover) {
  to.number(static_cast<std::int32_t>(state)).number(static_cast<std::uint8_t>(can_recover));
}

void write_robot_states(CdrWriter& to, const RobotStates& states) {
  constexpr std::uint32_t no_actions = 0;
  to.number(states.mode).number(states.body_control).number(no_actions);
}

void write_battery(CdrWriter& to, const Battery& battery) {
  to.number(battery.voltage).number(battery.current).number(battery.charge).number(battery.average_voltage);
}

void write_rpc(CdrWriter& to, const RpcMessage& message) {
  to.text(message.uuid).text(message.header).text(message.body);
}

std::optional<LowCommand> read_low_command(std::span<const std::uint8_t> bytes) {
  CdrReader from(bytes);
  LowCommand command;
  command.kind = from.number<std::int32_t>();
  const std::uint32_t count = from.count(most_motors);
  for (std::uint32_t i = 0; i < count && from.good(); ++i) {
    command.motors.push_back(read_motor(from));
    if (!is_finite(command.motors.back())) return std::nullopt;
  }
  const bool known = command.kind == LowCommand::parallel || command.kind == LowCommand::serial;
  if (!from.good() || !known) return std::nullopt;
  return command;
}

std::optional<KickTarget> read_kick(std::span<const std::uint8_t> bytes) {
  CdrReader from(bytes);
  (void)from.number<std::int32_t>(), (void)from.number<std::uint32_t>(), (void)from.text();  // time and frame
  KickTarget target{from.number<double>(), from.number<double>(), from.number<double>()};
  for (int i = 0; i < 3; ++i) (void)from.number<double>();  // goal and heading: the direction says it
  constexpr double farthest = 10;                           // [m] as motion.kick
  const bool known =
      std::abs(target.x) <= farthest && std::abs(target.y) <= farthest && std::isfinite(target.direction);
  if (!from.good() || !known) return std::nullopt;
  target.direction = std::remainder(target.direction, 2 * std::numbers::pi);
  return target;
}

std::optional<RpcMessage> read_rpc(std::span<const std::uint8_t> bytes) {
  CdrReader from(bytes);
  RpcMessage message{from.text(), from.text(), from.text()};  // in this order, by the braces
  if (!from.good()) return std::nullopt;
  return message;
}

}  // namespace murosimf::dds::booster
