/// messages.h - messages of Booster robots: topics, types and the order of their members, as the vendor's SDK sends and expects them.
///
/// Positions [rad], rates [rad/s], torques [N m], gains [N m/rad] and [N m s/rad].
/// Source: messages of the vendor's SDK 1.6.3 (PyPI booster-robotics-sdk-python), as they go over the wire; tests/oracle/booster_sdk.py.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/dds/cdr.h"
#include "murosimf/dds/motors.h"

namespace murosimf::dds::booster {

/// Motors are sent without their `mode`, whose meaning is not published.
struct LowCommand {
  enum Kind : std::int32_t { parallel = 0, serial = 1 };
  std::int32_t kind = serial;
  std::vector<MotorCommand> motors;
};

struct Odometer {
  float x = 0, y = 0, theta = 0;  ///< [m, m, rad]
};

enum class FallDown : std::int32_t { ready = 0, falling = 1, fallen = 2, getting_up = 3 };

struct RobotStates {
  std::int32_t mode = 0, body_control = 0;
};

struct Battery {
  float voltage = 0, current = 0, charge = 0, average_voltage = 0;  ///< [V], [A], [%], [V]
};

/// Where a program sees the ball, and where it wants it, in the robot's frame: x forward, y to the left.
struct KickTarget {
  double x = 0, y = 0;   ///< [m] of the ball
  double direction = 0;  ///< [rad] in which it shall go
};

/// A request to a service: JSON in header and body.
struct RpcMessage {
  std::string uuid, header, body;
};

inline constexpr std::uint32_t most_motors = 64;

/// The motors are sent as "parallel" and as "serial", which is the same but for the cranks of real ankles.
void write_low_state(CdrWriter& to, const ImuState& imu, std::span<const MotorState> motors);
void write_odometer(CdrWriter& to, const Odometer& odometer);
void write_fall_down(CdrWriter& to, FallDown state, bool can_recover);
void write_robot_states(CdrWriter& to, const RobotStates& states);
void write_battery(CdrWriter& to, const Battery& battery);
void write_rpc(CdrWriter& to, const RpcMessage& message);

/// Nothing: it is no such message, or a number in it is not finite.
[[nodiscard]] std::optional<LowCommand> read_low_command(std::span<const std::uint8_t> bytes);
/// Of a message brain/msg/Kick: a header, x, y, dir, goal_x, goal_y, robot_theta_to_field, and power, which older programs do not send.
/// Source of the order: the message's type in the vendor's demonstration for RoboCup.
[[nodiscard]] std::optional<KickTarget> read_kick(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::optional<RpcMessage> read_rpc(std::span<const std::uint8_t> bytes);

}  // namespace murosimf::dds::booster
