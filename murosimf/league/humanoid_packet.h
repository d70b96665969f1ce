/// humanoid_packet.h - packets of the Humanoid League's GameController: struct version 12, 688 bytes, little-endian, by UDP.
///
/// Source: RoboCupGameControlData.h of the Humanoid League's GameController (RoboCup-Humanoid-TC/GameController): offsets worked out by
/// a compiler.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/league/game_state.h"

namespace murosimf::league {

inline constexpr int humanoid_version = 12;
inline constexpr std::size_t humanoid_bytes = 688;
inline constexpr std::size_t humanoid_players = 11;  ///< of a team in such a packet

/// For a packet that begins as one of this version (game_packet.h). Throws SetupError in one line: another length, an invalid state.
[[nodiscard]] GameState read_humanoid_packet(std::string_view bytes);

/// RoboCupGameControlReturnData, version 2: 8 bytes.
[[nodiscard]] std::string to_bytes(const Answer& answer);

}  // namespace murosimf::league
