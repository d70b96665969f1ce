/// entity_states.h - what may change of a scene besides poses, as parts of the JSON that the page reads.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "murosimf/runtime/simulation.h"

namespace murosimf::league {
class GameTask;
}

namespace murosimf::web {

/// [{level, contact, controller, present, frozen}], by entity of the world.
[[nodiscard]] nlohmann::json entity_states(const World& world);

/// [[x, y, heading]] [m, m, rad] of where robots take themselves to be (soccer/beliefs.h), by entity of the world; null: it has no opinion.
[[nodiscard]] nlohmann::json beliefs_of(const World& world);

/// The last events and warnings, at most 200 each: [{time, text, warning}] by time. Warnings have the time 0 if they do not say one.
[[nodiscard]] nlohmann::json lines_of(const Simulation& simulation);

/// {state, half, remaining, teams: [{name, score}]} of a referee; null if there is none, or it has said nothing yet.
[[nodiscard]] nlohmann::json game_of(const league::GameTask* game);

}  // namespace murosimf::web
