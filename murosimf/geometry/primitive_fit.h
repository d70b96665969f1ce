/// primitive_fit.h - a sphere, capsule, cylinder or box in the place of a convex polyhedron.
///
/// The primitive has the polyhedron's volume and center of mass, exactly, and the proportions of its second moments of
/// mass: lengths along the axes are those of the solid of the same kind with the same ratios of second moments (the
/// equivalent inertia box, and its like), all scaled by one factor for the volume. So a polyhedron that is such a
/// primitive gives itself.
/// Boxes stand along the tightest of three frames, the one in which the bounding box is smallest: the principal axes,
/// the shape's own axes, and those of the largest face; where two axes are free, they turn to the smallest rectangle.
/// Capsules lie along the longest principal axis, cylinders along the one about which the solid is most alike.
/// Source: MuJoCo documentation, modeling, "mesh fitting", for the idea of the equivalent inertia box.
#pragma once

#include "murosimf/model/shape.h"

namespace murosimf::geometry {

enum class PrimitiveKind { sphere, capsule, cylinder, box, best };

struct FittedPrimitive {
  Shape shape;
  Vec3d position;     ///< [m] of the shape's origin, frame of the polyhedron
  Mat3d orientation;  ///< shape axes to the axes of the polyhedron
  /// [1] Share of the volume that both have in common, 0 to 1, from fixed points (within 0.02). As much as is missing
  /// sticks out elsewhere.
  double overlap = 0;
};

/// `best`: the kind with the largest overlap; of equal ones the first of sphere, capsule, box, cylinder, which is the
/// order of their cost in contact. The volume of `hull` must be positive. The same hull gives the same primitive.
[[nodiscard]] FittedPrimitive fit_primitive(const ConvexHull& hull, PrimitiveKind kind);

}  // namespace murosimf::geometry
