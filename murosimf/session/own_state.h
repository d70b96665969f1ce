/// own_state.h - who outside of a run remembers what no state of the run holds, and goes on as it is when time jumps.
#pragma once

#include <string>

#include "murosimf/model/world.h"
#include "murosimf/runtime/external_input_history.h"

namespace murosimf::session {

/// "software of blue1, blue2 and the GameController keep their own state"; empty: nobody does, or nobody is there.
[[nodiscard]] std::string own_state(const World& world, const ExternalInputHistory* memory);

/// What follows of a run that goes on live at `time` where it had been before; empty: nothing.
[[nodiscard]] std::string own_state_from(const World& world, const ExternalInputHistory* memory, Duration time);

}  // namespace murosimf::session
