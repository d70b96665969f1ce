/// game_packet.h - a packet of a GameController of any kind that is known, told apart by the version at its beginning.
#pragma once

#include <string_view>

#include "murosimf/league/game_state.h"

namespace murosimf::league {

inline constexpr int game_controller_port = 3838, answer_port = 3939;  ///< of all of them

/// Version 12 (humanoid_packet.h), or 18 to 20 (soccer_packet.h). Throws SetupError in one line: no packet of a GameController, an
/// unknown version, another length, a number that there is none of.
[[nodiscard]] GameState read_game_packet(std::string_view bytes);

}  // namespace murosimf::league
