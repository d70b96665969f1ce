/// low_messages.h - low-level messages of Unitree's humanoids: unitree_hg, the types and the order of their members.
///
/// Positions [rad], rates [rad/s], torques [N m], gains [N m/rad] and [N m s/rad]. A message's checksum is that of the struct that a C compiler
/// makes of it (2092 bytes of a state, 1004 of a command), whose gaps are zero, without its last word. CDR has no gap before a struct: messages
/// are 4 bytes shorter on the wire.
/// Source: unitree_sdk2py/idl/unitree_hg and unitree_sdk2py/utils/crc.py of github.com/unitreerobotics/unitree_sdk2_python, version 1.0.1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "murosimf/dds/cdr.h"
#include "murosimf/dds/motors.h"

namespace murosimf::dds::unitree {

inline constexpr std::size_t most_motors = 35;
inline constexpr std::size_t state_size = 2092, command_size = 1004;  ///< [byte] of structs, with their checksum

/// How ankles and waist are commanded: by the angles of their serial joints, or by those of the motors at their cranks.
enum class AnkleMode : std::uint8_t { pitch_roll = 0, cranks = 1 };

/// What a robot's sensors say.
struct LowState {
  std::uint8_t mode_machine = 0;
  std::uint32_t tick = 0;  ///< [ms]
  ImuState imu;
  std::array<MotorState, most_motors> motors{};
  std::size_t count = 0;  ///< [1] motors that there are: these are enabled
};

struct LowCommand {
  struct Motor {
    std::uint8_t mode = 0;  ///< 1: enabled
    float q = 0, dq = 0, tau = 0, kp = 0, kd = 0;
    std::uint32_t reserve = 0;
  };
  std::uint8_t mode_pr = 0;  ///< AnkleMode
  std::uint8_t mode_machine = 0;
  std::array<Motor, most_motors> motors{};
  std::array<std::uint32_t, 4> reserve{};
  std::uint32_t crc = 0;
};

/// With its checksum.
void write_low_state(CdrWriter& to, const LowState& state);
void write_imu(CdrWriter& to, const ImuState& imu);
void write_low_command(CdrWriter& to, const LowCommand& command);
/// Nothing: it is no such message. Its checksum and its numbers may be wrong.
[[nodiscard]] std::optional<LowCommand> read_low_command(std::span<const std::uint8_t> bytes);

/// That the command should have.
[[nodiscard]] std::uint32_t checksum_of(const LowCommand& command);
/// Whether all its numbers are finite.
[[nodiscard]] bool is_finite(const LowCommand& command);

}  // namespace murosimf::dds::unitree
