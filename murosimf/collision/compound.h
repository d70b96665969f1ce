/// compound.h - all shapes of one entity that can collide, in a tree of bounding volumes (paper 5).
#pragma once

#include <string>
#include <utility>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/geometry/any_tree.h"
#include "murosimf/geometry/traversal.h"

namespace murosimf::collision {

struct CompoundOptions {
  std::string volume = "sphere";  ///< kind of bounding volume: one of geometry::volume_names()
  bool structured = true;         ///< the tree follows the robot's own; false: split top-down (the field)
};

class Compound {
 public:
  /// Throws SetupError if there is no such kind of volume. The compound keeps no reference to the model.
  explicit Compound(const Model& model, const CompoundOptions& options = {});

  /// In the order of colliding_shapes(); shape i is leaf i of the tree.
  [[nodiscard]] const std::vector<CollidingShape>& shapes() const { return shapes_; }
  [[nodiscard]] const geometry::AnyTree& tree() const { return tree_; }
  /// No shape is farther [m] from the base's origin, in any posture: who is near nobody needs no refit.
  [[nodiscard]] double reach() const { return reach_; }

  /// Works out all volumes; r [m], R: poses of the entity's objects, world frame.
  void refit(std::span<const Vec3d> r, std::span<const Mat3d> R) noexcept;
  /// Where shape i is in the world.
  [[nodiscard]] geometry::Pose pose(int i, std::span<const Vec3d> r, std::span<const Mat3d> R) const noexcept {
    const CollidingShape& shape = shapes_[i];
    return placed_in({r[shape.object], R[shape.object]}, {shape.placed.position, shape.placed.orientation});
  }

 private:
  std::vector<CollidingShape> shapes_;
  geometry::AnyTree tree_;
  double reach_ = 0;
};

/// Calls visit(shape of a, shape of b) for pairs of shapes whose bounding volumes overlap, until it returns false;
/// returns the number of pairs of volumes tested. Both compounds must have been refitted.
template <class Visit>
int for_pairs(const Compound& a, const Compound& b, const Visit& visit) {
  return std::visit([&](const auto& tree_a, const auto& tree_b) { return geometry::for_pairs(tree_a, tree_b, visit); },
                    a.tree(), b.tree());
}

}  // namespace murosimf::collision
