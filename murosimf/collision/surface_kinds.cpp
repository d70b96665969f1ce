#include "murosimf/collision/surface_kinds.h"

namespace murosimf::collision {

SurfaceKinds::SurfaceKinds(std::span<const CollidingShape> shapes, Of of) {
  for (const CollidingShape& shape : shapes) {
    kinds_.push_back(find(shape, of));
    if (kinds_.back() < surfaces_.size()) continue;
    surfaces_.push_back(shape.placed.surface);
    objects_.push_back(shape.object);
  }
}

std::size_t SurfaceKinds::find(const CollidingShape& shape, Of of) const {
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (of == Of::object && objects_[i] != shape.object) continue;
    if (are_alike(surfaces_[i], shape.placed.surface)) return i;
  }
  return surfaces_.size();
}

}  // namespace murosimf::collision
