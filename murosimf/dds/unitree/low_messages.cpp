#include "murosimf/dds/unitree/low_messages.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dds/unitree/checksum.h"

namespace murosimf::dds::unitree {
namespace {

constexpr std::uint32_t none = 0;
constexpr std::int16_t room_temperature = 25;  // [C] of what has none
constexpr std::size_t word = 4;                // [byte]

/// As messages go over the wire, or as a C compiler lays the struct out: each struct in it begins at a whole word.
enum class Layout : std::uint8_t { wire, memory };

void begin_struct(CdrWriter& to, Layout layout) {
  while (layout == Layout::memory && (to.bytes().size() - encapsulation_size) % word != 0) to.number<std::uint8_t>(0);
}

/// Of a message that has been laid out without its checksum.
std::uint32_t checksum_of(const CdrWriter& memory) {
  return checksum(std::span(memory.bytes()).subspan(encapsulation_size));
}

void put_imu(CdrWriter& to, const ImuState& imu) {
  const double roll = imu.rpy[0] / 2, pitch = imu.rpy[1] / 2, yaw = imu.rpy[2] / 2;
  const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch);
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  // first about z, then about y, then about x; w, x, y, z
  for (const double value : {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
                             cr * cp * sy - sr * sp * cy})
    to.number(static_cast<float>(value));
  for (const auto& row : {imu.gyro, imu.acc, imu.rpy}) {
    for (const float value : row) to.number(value);
  }
  to.number(room_temperature);
}

void put_motor(CdrWriter& to, const MotorState& motor, bool enabled) {
  const auto temperature = static_cast<std::int16_t>(motor.temperature);
  to.number(static_cast<std::uint8_t>(enabled)).number(motor.q).number(motor.dq).number(motor.ddq).number(motor.tau);
  to.number(temperature).number(temperature).number(0.0F);  // of case and winding, voltage
  for (int i = 0; i < 7; ++i) to.number(none);              // sensor[2], motorstate, reserve[4]
}

void put(CdrWriter& to, const LowState& state, Layout layout) {
  to.number(none).number(none);  // version
  to.number(static_cast<std::uint8_t>(AnkleMode::pitch_roll)).number(state.mode_machine).number(state.tick);
  begin_struct(to, layout);
  put_imu(to, state.imu);
  for (std::size_t i = 0; i < state.motors.size(); ++i) {
    begin_struct(to, layout);
    put_motor(to, state.motors[i], i < state.count);
  }
  constexpr int remote = 40;  // [byte] of the remote control, which is not there
  for (int i = 0; i < remote; ++i) to.number<std::uint8_t>(0);
  for (int i = 0; i < 4; ++i) to.number(none);  // reserve
}

void put(CdrWriter& to, const LowCommand& command, Layout layout) {
  to.number(command.mode_pr).number(command.mode_machine);
  for (const LowCommand::Motor& motor : command.motors) {
    begin_struct(to, layout);
    to.number(motor.mode).number(motor.q).number(motor.dq).number(motor.tau).number(motor.kp).number(motor.kd);
    to.number(motor.reserve);
  }
  for (const std::uint32_t value : command.reserve) to.number(value);
}

}  // namespace

void write_low_state(CdrWriter& to, const LowState& state) {
  CdrWriter memory;
  put(memory, state, Layout::memory);
  put(to, state, Layout::wire);
  to.number(checksum_of(memory));
}

void write_imu(CdrWriter& to, const ImuState& imu) { put_imu(to, imu); }

void write_low_command(CdrWriter& to, const LowCommand& command) {
  put(to, command, Layout::wire);
  to.number(command.crc);
}

std::optional<LowCommand> read_low_command(std::span<const std::uint8_t> bytes) {
  CdrReader from(bytes);
  LowCommand command{.mode_pr = from.number<std::uint8_t>(), .mode_machine = from.number<std::uint8_t>()};
  for (LowCommand::Motor& motor : command.motors) {
    motor.mode = from.number<std::uint8_t>();
    for (float* const value : {&motor.q, &motor.dq, &motor.tau, &motor.kp, &motor.kd}) *value = from.number<float>();
    motor.reserve = from.number<std::uint32_t>();
  }
  for (std::uint32_t& value : command.reserve) value = from.number<std::uint32_t>();
  command.crc = from.number<std::uint32_t>();
  if (!from.good()) return std::nullopt;
  return command;
}

std::uint32_t checksum_of(const LowCommand& command) {
  CdrWriter memory;
  put(memory, command, Layout::memory);
  return checksum_of(memory);
}

bool is_finite(const LowCommand& command) {
  return std::ranges::all_of(command.motors, [](const LowCommand::Motor& motor) {
    return std::isfinite(motor.q) && std::isfinite(motor.dq) && std::isfinite(motor.tau) && std::isfinite(motor.kp) &&
           std::isfinite(motor.kd);
  });
}

}  // namespace murosimf::dds::unitree
