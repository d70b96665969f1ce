/// surface_kinds.h - which shapes have the same surface: what depends on pairs of surfaces is kept once for each pair of kinds.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/colliding_shapes.h"

namespace murosimf::collision {

/// As far as pairs of them go (MaterialTable::find).
[[nodiscard]] inline bool are_alike(const Surface& a, const Surface& b) {
  return a.material == b.material && a.friction == b.friction;
}

class SurfaceKinds {
 public:
  /// What a kind is one of.
  enum class Of {
    model,   ///< shapes of any objects are of one kind if their surfaces are equal
    object,  ///< only those of one object
  };

  SurfaceKinds(std::span<const CollidingShape> shapes, Of of);

  /// Of each kind, in the order in which the shapes have them.
  [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }
  /// Of each kind: the object, or the first object, with such a shape.
  [[nodiscard]] const std::vector<int>& objects() const { return objects_; }
  /// Number of the kind that a shape is of.
  [[nodiscard]] std::size_t of(std::size_t shape) const noexcept { return kinds_[shape]; }

 private:
  [[nodiscard]] std::size_t find(const CollidingShape& shape, Of of) const;

  std::vector<Surface> surfaces_;
  std::vector<int> objects_;
  std::vector<std::size_t> kinds_;  // of each shape
};

// ---- definitions ----

inline SurfaceKinds::SurfaceKinds(std::span<const CollidingShape> shapes, Of of) {
  for (const CollidingShape& shape : shapes) {
    kinds_.push_back(find(shape, of));
    if (kinds_.back() < surfaces_.size()) continue;
    surfaces_.push_back(shape.placed.surface);
    objects_.push_back(shape.object);
  }
}

inline std::size_t SurfaceKinds::find(const CollidingShape& shape, Of of) const {
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (of == Of::object && objects_[i] != shape.object) continue;
    if (are_alike(surfaces_[i], shape.placed.surface)) return i;
  }
  return surfaces_.size();
}

}  // namespace murosimf::collision
