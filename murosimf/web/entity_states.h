/// entity_states.h - changing data of a scene other than poses, as parts of the JSON for the page.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "murosimf/runtime/simulation.h"

namespace murosimf::league {
class GameTask;
}

namespace murosimf::web {

/// [{level, contact, controller, present, frozen}], by entity of the world.
[[nodiscard]] nlohmann::json entity_states(const World& world);

/// [[x, y, heading]] [m, m, rad], the robots' own estimates of their poses (soccer/beliefs.h), by entity of the world; null: no estimate.
[[nodiscard]] nlohmann::json beliefs_of(const World& world);

/// The last events and warnings, at most 200 each: [{time, text, warning}] by time. Warnings without a time have the time 0.
[[nodiscard]] nlohmann::json lines_of(const Simulation& simulation);

/// {state, half, remaining, teams: [{name, score}]} of a referee; null if there is none, or no message yet.
[[nodiscard]] nlohmann::json game_of(const league::GameTask* game);

}  // namespace murosimf::web
