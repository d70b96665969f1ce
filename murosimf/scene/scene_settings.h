/// scene_settings.h - properties that a scene sets, at its beginning and while it runs. Each one is an event of the report.
#pragma once

#include <string>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Sets the property of one entity. Warns later if a controller overwrites it. Throws SetupError.
void apply(SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity);

/// Applies the settings of the spec. After initialize().
void apply_settings(SceneParts& parts);
/// Applies those of one entity that has returned.
void apply_settings_of(SceneParts& parts, const Entity& entity);

}  // namespace murosimf::scene
