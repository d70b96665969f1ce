/// scene_start.h - how a scene begins, every time: places, postures and velocities, as its file and its seed say.
#pragma once

#include <cstdint>
#include <optional>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Has the simulation do all of it at every start.
void begin_at_every_start(SceneParts& parts);

/// Where and how one entity begins: its place and posture, before its level starts; its velocity, after that.
void place_at_start(const SceneParts& parts, Entity& entity);
void start_moving(const SceneParts& parts, Entity& entity);

/// Back to the beginning, with the levels and laws of then; with another seed, if one is given. Throws SetupError.
void reset(SceneParts& parts, std::optional<std::uint64_t> seed);

}  // namespace murosimf::scene
