/// section_changes.h - a scene's light and ball while it runs (paper 7.1): keys of [light], and of [ball] what makes another ball.
///
/// A ball that becomes another one stays where its lowest point is, with its velocities. Its contacts begin anew; what is inside
/// something then is let out slowly, with a warning. A color changes nothing but pictures.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Throws SetupError if the scene can never do what an event of a section says.
void check_section_change(const SceneParts& parts, const scene_file::SceneEvent& event);
/// Does it now, between two steps. Throws SetupError, and changes nothing, if it cannot be.
void apply_section_change(SceneParts& parts, const scene_file::SceneEvent& event);

[[nodiscard]] ChangingSections sections_in_force(const SceneParts& parts);
/// For a state that will be loaded, or a reset, before the next step: nothing is an event.
void put_in_force(SceneParts& parts, const ChangingSections& sections);

/// Tells all who draw that something looks different or somebody has come.
void show_changes(SceneParts& parts);

}  // namespace murosimf::scene
