/// scene_settings.h - properties that a scene sets, at its beginning and while it runs. Each is an event of the report.
#pragma once

#include <string>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Sets the property of one entity. Warns later if a controller writes it, too. Throws SetupError.
void apply(SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity);

/// Sets what the spec sets. After initialize().
void apply_settings(SceneParts& parts);
/// What it sets of one entity, which has come back.
void apply_settings_of(SceneParts& parts, const Entity& entity);

}  // namespace murosimf::scene
