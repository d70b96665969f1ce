#include "murosimf/geometry/any_tree.h"

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::geometry {
namespace {

template <class V>
BoundingTree<V> tree_of(std::span<const TreePart> parts, const TreeLayout& layout, double margin) {
  std::vector<typename BoundingTree<V>::Leaf> leaves;
  for (const TreePart& part : parts) leaves.push_back({part.object, fit<V>(*part.shape, part.at)});
  return {std::move(leaves), layout, margin};
}

}  // namespace

const std::vector<std::string_view>& volume_names() {
  static const std::vector<std::string_view> names{"sphere", "aabb", "obb", "capsule"};
  return names;
}

AnyTree make_tree(std::string_view volume, std::span<const TreePart> parts, const TreeLayout& layout, double margin) {
  MUROSIMF_ASSERT(margin >= 0);
  MUROSIMF_ASSERT(layout.depth() <= TreeLayout::most_depth);
  if (volume == "sphere") return tree_of<BoundingSphere>(parts, layout, margin);
  if (volume == "aabb") return tree_of<Aabb>(parts, layout, margin);
  if (volume == "obb") return tree_of<Obb>(parts, layout, margin);
  if (volume == "capsule") return tree_of<BoundingCapsule>(parts, layout, margin);
  throw SetupError(unknown_name("bounding volume", volume, volume_names()));
}

}  // namespace murosimf::geometry
