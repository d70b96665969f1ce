/// colliding_shapes.h - the shapes of a model that take part in collisions: one list, in one order, for all users.
#pragma once

#include <vector>

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"

namespace murosimf::collision {

struct CollidingShape {
  int object = 0;
  int index = 0;  ///< among the shapes of its object
  PlacedShape placed;
};

/// Every shape of the model that collides, planes excluded; by object, then by index.
[[nodiscard]] std::vector<CollidingShape> colliding_shapes(const Model& model);

/// Every plane of the model that collides; in the same order.
[[nodiscard]] std::vector<CollidingShape> colliding_planes(const Model& model);

/// No shape of colliding_shapes() is farther [m] from the base's origin, in any posture within the joints' ranges.
[[nodiscard]] double farthest_reach(const Model& model);

/// Poses of all objects in the base's frame with all joints at zero, or as near to it as their range lets them.
[[nodiscard]] std::vector<Transformd> rest_poses(const Model& model);

}  // namespace murosimf::collision
