/// bounds_filter.h - which entities overlap the bounds that a client of simulation_interfaces asks about.
#pragma once

#include "murosimf/model/shape.h"
#include "murosimf/ros2/simulation_messages.h"
#include "murosimf/world/entity.h"

namespace murosimf::ros2 {

/// A box along the axes of the world, a convex hull or a sphere, in the world.
class BoundsFilter {
 public:
  /// `region`: not empty, and of a type that is known. Throws SetupError: its points do not make one of its type.
  explicit BoundsFilter(const Region& region);

  /// One of its shapes that collide touches the bounds, as it stands; without such shapes: its origin.
  [[nodiscard]] bool meets(const Entity& entity) const;

 private:
  Shape shape_;
  Transformd place_;
};

}  // namespace murosimf::ros2
