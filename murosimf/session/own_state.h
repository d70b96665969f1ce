/// own_state.h - participants outside of a run with state that is not part of the run's state, and therefore unaffected by jumps in time.
#pragma once

#include <string>

#include "murosimf/runtime/external_input_history.h"
#include "murosimf/world/world.h"

namespace murosimf::session {

/// "software of blue1, blue2 and the GameController keep their own state"; empty: there is none.
[[nodiscard]] std::string own_state(const World& world, const ExternalInputHistory* memory);

/// The consequence for a run that continues live at `time` after a jump; empty: none.
[[nodiscard]] std::string own_state_from(const World& world, const ExternalInputHistory* memory, Duration time);

}  // namespace murosimf::session
