/// scene_checks.h - whether what a scene says acts, is impossible, or changes nothing. docs/scenes.md has the rule.
///
/// Each function adds lines to the diagnostics of the scene. All throw SetupError for what is impossible.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Whatever the scene says that changes nothing (unused_settings.h).
void warn_about_settings(SceneParts& parts);

/// Settings and events, before the first step (property_checks.h).
void check_properties(SceneParts& parts);

/// Who stands in whom, before the first step.
void warn_about_start(SceneParts& parts);

/// What a user may have overlooked in a robot's level: steps too long for it, joints without servos.
void warn_about_level(SceneParts& parts, const scene_file::RobotSpec& robot);

}  // namespace murosimf::scene
