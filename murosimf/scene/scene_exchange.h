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

/// Levels and laws of a robot, or the law of ball and bodies.
struct Algorithms {
  std::string level, servo_law;  ///< empty: no robot
  std::string contact;
  friend bool operator==(const Algorithms&, const Algorithms&) = default;
  void state(StateArchive& archive) { archive(level, servo_law, contact); }
};
[[nodiscard]] Algorithms algorithms_of(const SceneParts& parts, const Entity& entity);
/// For a state that will be loaded before the next step: levels begin anew, and nothing is an event.
void put_in_force(SceneParts& parts, Entity& entity, const Algorithms& algorithms);

/// Has the simulation do the events of the spec when their time comes. Throws SetupError for those that nobody can do.
void schedule_events(SceneParts& parts);

}  // namespace murosimf::scene
