/// compound.h - all shapes of one entity that can collide, in a tree of bounding volumes (paper 5).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "murosimf/collision/inner_pairs.h"
#include "murosimf/geometry/any_tree.h"
#include "murosimf/geometry/traversal.h"
#include "murosimf/world/entity.h"

namespace murosimf::collision {

struct CompoundOptions {
  std::string volume = "sphere";  ///< kind of bounding volume: one of geometry::volume_names()
  bool structured = true;         ///< the tree follows the robot's own; false: split top-down (the field)
  bool inner = false;             ///< shapes of this entity can touch each other
  ExcludedPairs excluded;         ///< but for these
  double margin = 0;              ///< [m] of the volumes: they stay right while nothing moves farther
};

class Compound {
 public:
  /// Throws SetupError if there is no such kind of volume or an excluded object does not exist. The compound keeps no reference
  /// to the model; all of one model with the same options share everything but their volumes.
  explicit Compound(const Model& model, const CompoundOptions& options = {});

  /// In the order of colliding_shapes(); shape i is leaf i of the tree.
  [[nodiscard]] const std::vector<CollidingShape>& shapes() const { return parts_->shapes; }
  [[nodiscard]] const geometry::AnyTree& tree() const { return tree_; }
  /// Every shape is of the one kind that is usual, and touches it.
  [[nodiscard]] bool all_touch() const { return parts_->all_touch; }
  [[nodiscard]] const InnerPairs& inner_pairs() const { return parts_->inner_pairs; }
  /// No shape is farther [m] from the base's origin, in any posture: an entity without others near it needs no refit.
  [[nodiscard]] double reach() const { return parts_->reach; }

  /// [m] of a body: that of its thickest shape (interpenetration.h); 0 without shapes.
  [[nodiscard]] double thickness_of(int object) const { return parts_->thicknesses[static_cast<std::size_t>(object)]; }

  /// About the root of the tree: a cheap first test whatever the kind of volume.
  [[nodiscard]] const geometry::BoundingSphere& around() const { return around_; }

  /// False if some shape has moved by more than the margin since the volumes were worked out.
  [[nodiscard]] bool still_fits(std::span<const Vec3d> r, std::span<const Mat3d> R) const noexcept;
  /// Works out all volumes; r [m], R: poses of the entity's objects, world frame.
  void refit(std::span<const Vec3d> r, std::span<const Mat3d> R) noexcept;
  /// Where shape i is in the world.
  [[nodiscard]] Transformd pose(int i, std::span<const Vec3d> r, std::span<const Mat3d> R) const noexcept {
    const CollidingShape& shape = shapes()[i];
    return Transformd{r[shape.object], R[shape.object]} * shape.placed.place();
  }

 private:
  struct Parts {
    Parts(const Model& model, const CompoundOptions& options);

    std::vector<CollidingShape> shapes;
    geometry::AnyTree tree;  // never refitted
    InnerPairs inner_pairs;
    double reach;                     // [m]
    std::vector<double> thicknesses;  // [m] by object
    bool all_touch;
  };

  std::shared_ptr<const Parts> parts_;
  geometry::AnyTree tree_;
  geometry::BoundingSphere around_;
};

/// Calls of visit(shape of a, shape of b) for pairs of shapes that are not to touch by their kinds (model/shape.h) are left out.
template <class Visit>
auto only_touching(const Compound& a, const Compound& b, Visit visit) {
  return [&a, &b, visit, all = a.all_touch() && b.all_touch()](int i, int j) {
    return !(all || may_touch(a.shapes()[i].placed, b.shapes()[j].placed)) || visit(i, j);
  };
}

/// The compound of an entity's model. Throws SetupError that names the entity.
[[nodiscard]] Compound compound_of(const Entity& entity, const CompoundOptions& options);

/// Calls visit(shape of a, shape of b) for pairs of shapes whose bounding volumes overlap, until it returns false;
/// returns the number of pairs of volumes tested. Both compounds must have been refitted.
template <class Visit>
int for_pairs(const Compound& a, const Compound& b, Visit&& visit) {
  if (!overlap(a.around(), b.around())) return 1;
  return std::visit([&](const auto& tree_a, const auto& tree_b) { return geometry::for_pairs(tree_a, tree_b, visit); },
                    a.tree(), b.tree());
}

/// The same for pairs of shapes of one compound that may touch, each once; none if inner collisions are off.
template <class Visit>
int for_inner_pairs(const Compound& compound, Visit&& visit) {
  const InnerPairs& inner = compound.inner_pairs();
  if (inner.off()) return 0;
  const auto allowed = [&](int a, int b) { return !inner.may_touch(a, b) || visit(a, b); };
  return std::visit([&](const auto& tree) { return geometry::for_self_pairs(tree, allowed); }, compound.tree());
}

}  // namespace murosimf::collision
