/// scene_exchange.h - changes of a running scene: levels and laws, by name; and its events.
///
/// All throw SetupError, and change nothing, for unknown names and if the robot cannot change in its present state.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

void exchange_level(SceneParts& parts, std::string_view robot, std::string_view level);

/// For a robot, the ball or a body.
void exchange_contact(SceneParts& parts, std::string_view entity, std::string_view law);

/// For all servos of a robot at articulated_dynamics; other levels store it.
void exchange_servo_law(SceneParts& parts, std::string_view robot, std::string_view law);

/// The algorithms in use for each of the moving entities, in their order.
[[nodiscard]] std::vector<Algorithms> algorithms_in_force(const SceneParts& parts);
/// For a state that will be loaded, or a reset, before the next step: levels restart, and nothing is recorded as an event.
void put_in_force(SceneParts& parts, Entity& entity, const Algorithms& algorithms);

/// Throws SetupError if no entity can ever perform the change: constants, unknown objects.
void check_change(const SceneParts& parts, const scene_file::SceneEvent& change);

/// Performs the change now, for all entities that it denotes: errors of one do not keep the others from changing. Throws the first
/// SetupError when all are done.
void apply_change(SceneParts& parts, const scene_file::SceneEvent& change);

/// Schedules the events of the spec. Throws SetupError for events that can never be performed.
void schedule_events(SceneParts& parts);

}  // namespace murosimf::scene
