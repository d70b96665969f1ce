/// constant_changes.h - constants that change while a scene runs: of models (mass, inertia, joints, servos) and of pairs of materials.
///
/// A change acts from the next step on, as if the scene had been built with it: levels and contacts work out anew what follows from it, and
/// keep place and velocities. Contacts of an entity begin anew with its model. What is worked out once from a model when a scene is built, as
/// seeds of gaits and the sensors joint_wrench and those of contacts, stays. The changes are part of saved states; a reset takes them back.
#pragma once

#include <string>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Throws SetupError: the entity has no such constant, or cannot have this value.
void check_constant(const SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity);
/// Changes a constant of the entity's model, whatever it was before. Throws SetupError, and changes nothing then.
void change_constant(SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity);

/// Of pairs of materials, or the friction of the field; the more specific one wins, as of --set. Throws SetupError.
void check_surfaces(const SceneParts& parts, const scene_file::SceneEvent& event);
void change_surfaces(SceneParts& parts, const scene_file::SceneEvent& event);

/// For a state that will be loaded, or a reset, before the next step.
void put_in_force(SceneParts& parts, const ChangedConstants& constants);

}  // namespace murosimf::scene
