/// game_packet.h - a packet of a GameController of any known kind, distinguished by the version at its beginning.
#pragma once

#include <string_view>

#include "murosimf/league/game_state.h"

namespace murosimf::league {

inline constexpr int game_controller_port = 3838, answer_port = 3939;  ///< common to all of them

/// Version 12 (humanoid_packet.h), or 18 to 20 (soccer_packet.h). Throws SetupError in one line: no packet of a GameController, an
/// unknown version, another length, an invalid number.
[[nodiscard]] GameState read_game_packet(std::string_view bytes);

}  // namespace murosimf::league
