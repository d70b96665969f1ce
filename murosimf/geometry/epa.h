/// epa.h - the least shift that parts two overlapping bodies, by a polyhedron that grows inside their difference.
///
/// Source: G. van den Bergen, Proximity queries and penetration depth computation on 3D game objects, 2001. Here the
/// polyhedron need not hold the origin from the beginning: the face that is lowest above the origin grows, also if that is
/// below it, and as the origin is inside the difference, the polyhedron swallows it. Keeps its store on the stack.
#pragma once

#include "murosimf/geometry/penetration.h"

namespace murosimf::geometry {

/// The least shift that parts the overlapping cores of A and B; size [m]: of the smaller body. Exact for polyhedra. With
/// curved bodies a local minimum to rounding, of which no other one is lower by more than 1e-5 sizes if the store, one
/// hundred vertices, suffices.
[[nodiscard]] Deepest deepest_of_cores(const Body& a, const Body& b, double size);

}  // namespace murosimf::geometry
