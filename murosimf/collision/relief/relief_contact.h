/// relief_contact.h - where a shape touches uneven ground: the normals are those of the surface, also where triangles meet.
///
/// A point of a body touches the face below it, as it touches a plane. Edges and corners of the surface touch only where they stand out, and
/// only along directions between the normals of the faces that they join: what lies flat or hollow on both sides catches nothing. Spheres
/// and the ends of capsules are exact: each nearest feature whose Voronoi region holds the center is one contact (Ericson, "Real-Time
/// Collision Detection", 2005, section 5.1.5, has the regions of a triangle). Of other shapes, the points that a plane could touch
/// (geometry/low_points.h) count against faces, and of edges and corners what is inside of the shape, along the direction that parts them
/// soonest among the normals of the shape's sides and of the faces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/collision/relief/relief.h"
#include "murosimf/math/transform.h"

namespace murosimf::collision {

struct ReliefContact {
  std::uint32_t feature =
      0;              ///< of the shape's point, whichever face it is over; or of an edge or corner of the surface
  Vec3d point;        ///< [m] world frame
  Vec3d normal;       ///< [1] unit, world frame, from the surface to the shape
  double depth = 0;   ///< [m] along the normal, positive
  double radius = 0;  ///< [m] of a round body at the point
};

/// Writes the contacts of a shape with these triangles of `relief`, rising numbers, to `found`, sorted by feature, which are all different.
/// Where a point is right above the edge of two triangles that touch it alike, they are one contact. `at`, `at_relief`: poses in the
/// world.
void find_relief_contacts(const Shape& shape, const Transformd& at, const Relief& relief, const Transformd& at_relief,
                          std::span<const int> triangles, std::vector<ReliefContact>& found);

}  // namespace murosimf::collision
