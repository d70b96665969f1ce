/// start_posture.h - the start posture of a robot: that of its file, or a key of it (model/keyframe.h).
///
/// Joints start at their targets, so this sets targets. A key's own targets apply from the first step on.
#pragma once

#include <string_view>

#include "murosimf/model/keyframe.h"
#include "murosimf/world/entity.h"

namespace murosimf::scene {

/// Null for an empty name. Throws SetupError with all names if the model has no such key.
[[nodiscard]] const Keyframe* find_keyframe(const Model& model, std::string_view name);

/// [rad | m] Start of the joint; `keyframe` may be null.
[[nodiscard]] double start_position(const Model& model, const Keyframe* keyframe, int joint);

/// Before the level starts: for joints with a start in the file; `keyframe` may be null.
void take_posture(const Keyframe* keyframe, Entity& robot);
/// After the level has started.
void take_targets(const Keyframe* keyframe, Entity& robot);

}  // namespace murosimf::scene
