/// section_changes.h - a scene's light and ball while it runs (paper 7.1): keys of [light], and those of [ball] that replace the ball.
///
/// A new ball has the lowest point and the velocities of the old one. Its contacts restart; if it then penetrates
/// something it is pushed out slowly, with a warning. A color changes pictures only.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Throws SetupError if the scene can never perform an event of a section.
void check_section_change(const SceneParts& parts, const scene_file::SceneEvent& event);
/// Performs it now, between two steps. Throws SetupError, and changes nothing, if that is impossible.
void apply_section_change(SceneParts& parts, const scene_file::SceneEvent& event);

[[nodiscard]] ChangingSections sections_in_force(const SceneParts& parts);
/// For a state that will be loaded, or a reset, before the next step: nothing is recorded as an event.
void put_in_force(SceneParts& parts, const ChangingSections& sections);

/// Notifies all renderers that the appearance of an entity has changed or an entity was added.
void show_changes(SceneParts& parts);

}  // namespace murosimf::scene
