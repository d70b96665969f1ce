/// kinematic_separation.h - entities that cannot be pushed do not walk through each other or through static shapes.
///
/// No force acts between them (both are kinematic walkers): they get a `separation`, a way along the ground that their
/// level adds to the place of the standing foot. It is the horizontal part of the deepest overlap, half for either of
/// two walkers, all for one that runs into a goal, and at most 1 mm in a step, so that nobody jumps. Feet are compared as seen
/// from above: no walker steps on another one's.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/static_compound.h"

namespace murosimf::collision {

/// Renews the `separation` of all moving entities, by set.blocked and the environment; counts its tests in set.tests.
/// `within_reach`: entities whose spheres of reach meet, sorted (PairFinder::within_reach).
void kinematic_separation(std::vector<MovingEntity>& moving_entities, const StaticCompound& environment,
                          std::span<const std::pair<int, int>> within_reach, PairSet& set) noexcept;

}  // namespace murosimf::collision
