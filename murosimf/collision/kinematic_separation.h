/// kinematic_separation.h - entities that cannot be pushed do not walk through each other or through static shapes.
///
/// No force acts between them (both are kinematic walkers): they get a `separation`, a way along the ground that their
/// level adds to the place of the standing foot. It is the horizontal part of the deepest overlap, half for either of
/// two walkers, all for one that runs into a goal, and at most 1 m/s, so that nothing jumps. What carries from below (GroundSurface) is no
/// wall. Feet are compared as seen from above: no walker steps on another one's.
///
/// A walker pushes what can be pushed. But its joints know no limit: it would press a ball, or a robot that cannot get out of the way,
/// into what is behind. So it gives way, too, by what the deepest overlap is more than 0.15 of the thinner shape's thickness (half
/// is where shapes go through each other, interpenetration.h): its own with what it touches, and those of that with others. Feet are again
/// compared as seen from above.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "murosimf/collision/moving_entity.h"
#include "murosimf/collision/static_compound.h"

namespace murosimf::collision {

/// Renews the `separation` of all moving entities, by set.blocked, set.points and the environment; counts its tests in set.tests.
/// `within_reach`: entities whose spheres of reach meet, sorted (PairFinder::within_reach). `dt` [s] of the step.
void kinematic_separation(std::vector<MovingEntity>& moving_entities, const StaticCompound& environment,
                          std::span<const std::pair<int, int>> within_reach, double dt, PairSet& set) noexcept;

}  // namespace murosimf::collision
