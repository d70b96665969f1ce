#include "murosimf/geometry/bounding_tree.h"

namespace murosimf::geometry {

template class BoundingTree<BoundingSphere>;
template class BoundingTree<Aabb>;
template class BoundingTree<Obb>;
template class BoundingTree<BoundingCapsule>;

}  // namespace murosimf::geometry
