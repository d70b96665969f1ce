/// epa.h - the least shift that parts two overlapping bodies, by a polyhedron that grows inside their difference.
///
/// Source: G. van den Bergen, Proximity queries and penetration depth computation on 3D game objects, 2001. Here the
/// polyhedron need not hold the origin from the beginning: the face that is lowest above the origin grows, also if that is
/// below it, and as the origin is inside the difference, the polyhedron swallows it. Keeps its store on the stack.
#pragma once

#include "murosimf/geometry/support.h"

namespace murosimf::geometry {

/// The unit vector n, from B to A, along which the least shift [m] of A parts the cores of A and B. The true least shift
/// is at most `tolerance` [m] less than that along n, if the store suffices. `size` [m]: of the smaller body.
[[nodiscard]] Vec3d parting_direction(const Body& a, const Body& b, double size, double tolerance);

}  // namespace murosimf::geometry
