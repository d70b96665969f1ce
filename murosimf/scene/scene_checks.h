/// scene_checks.h - whether settings of a scene have an effect, are invalid, or change nothing. docs/scenes.md has the rule.
///
/// Each function adds lines to the diagnostics of the scene. All throw SetupError for invalid settings.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Settings of the scene without effect (unused_settings.h).
void warn_about_settings(SceneParts& parts);

/// Settings and events, before the first step (property_checks.h).
void check_properties(SceneParts& parts);

/// Entities that overlap, before the first step.
void warn_about_start(SceneParts& parts);

/// Settings of a robot's level that users overlook: steps too long for it, joints without servos.
void warn_about_level(SceneParts& parts, const scene_file::RobotSpec& robot);

}  // namespace murosimf::scene
