/// scene_start.h - the start of a scene: places, postures and velocities, from its file and its seed.
#pragma once

#include <cstdint>
#include <optional>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Registers these steps for every start of the simulation.
void begin_at_every_start(SceneParts& parts);

/// Start of one entity: its place and posture, before its level starts; its velocity, after that.
void place_at_start(const SceneParts& parts, Entity& entity);
void start_moving(const SceneParts& parts, Entity& entity);

/// Returns to the beginning, with the initial levels and laws; with another seed, if one is given. Throws SetupError.
void reset(SceneParts& parts, std::optional<std::uint64_t> seed);

}  // namespace murosimf::scene
