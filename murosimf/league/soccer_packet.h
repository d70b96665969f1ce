/// soccer_packet.h - packets of the Humanoid Soccer League's GameController, 2025 and later: struct versions 18, 19 and 20, little-endian,
/// without gaps, by UDP; and the status packet (version 4) that robots send back.
///
/// Both have the same head of 18 bytes and two teams of 10 bytes and 20 players. A player has 2 bytes (penalty, seconds) in version 18, 4
/// (and warnings, cautions) in 19, 3 (and cautions) in 20. Version 20 numbers penalties anew; here they always have its numbers.
/// Source: RoboCup-HumanoidSoccerLeague/GameController, game_controller_msgs and dissectors/robocup_gc.lua (versions 6 and 7).
#pragma once

#include <string>
#include <string_view>

#include "murosimf/league/game_state.h"

namespace murosimf::league {

/// Penalties, by the numbers of version 20.
enum class SoccerPenalty : std::uint8_t {
  none,
  illegal_positioning,
  motion_in_set,
  motion_in_stop,
  local_game_stuck,
  incapable,
  pick_up,
  ball_holding,
  leaving_field,
  arms_or_hands,
  pushing,
  cautioned,
  sent_off,
  substitute,
};

inline constexpr int first_soccer_version = 18, last_soccer_version = 20;
inline constexpr std::size_t status_bytes = 32;

/// 118, 198 or 158.
[[nodiscard]] std::size_t soccer_bytes(int version) noexcept;

/// For a packet that begins as one of these versions (game_packet.h). Throws SetupError in one line: another length, an invalid state, set play or
/// penalty.
[[nodiscard]] GameState read_soccer_packet(std::string_view bytes);

/// Lengths in mm, the heading in rad, as floats.
[[nodiscard]] std::string to_bytes(const RobotStatus& status);

}  // namespace murosimf::league
