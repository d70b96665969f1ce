/// scene_exchange.h - how a scene changes while it runs: levels and laws, by name; and its events.
///
/// All throw SetupError, and change nothing, for unknown names and if the robot cannot change as it is now.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

void exchange_level(SceneParts& parts, std::string_view robot, std::string_view level);

/// Of a robot, of the ball or of a body.
void exchange_contact(SceneParts& parts, std::string_view entity, std::string_view law);

/// Of all servos of a robot at articulated_dynamics; the others remember it.
void exchange_servo_law(SceneParts& parts, std::string_view robot, std::string_view law);

/// What is in force for each of the entities that move, in their order.
[[nodiscard]] std::vector<Algorithms> algorithms_in_force(const SceneParts& parts);
/// For a state that will be loaded, or a reset, before the next step: levels begin anew, and nothing is an event.
void put_in_force(SceneParts& parts, Entity& entity, const Algorithms& algorithms);

/// Throws SetupError if nobody can ever do what an event says: constants, objects that there are none of.
void check_change(const SceneParts& parts, const scene_file::SceneEvent& change);

/// Does now what an event says, to all whom it means: who refuses does not keep the others from changing. Throws SetupError, the
/// first one, when all are done.
void apply_change(SceneParts& parts, const scene_file::SceneEvent& change);

/// Has the simulation do the events of the spec when their time comes. Throws SetupError for those that nobody can do.
void schedule_events(SceneParts& parts);

}  // namespace murosimf::scene
