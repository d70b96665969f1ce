#include "murosimf/collision/entity_tree.h"

#include "murosimf/geometry/sweep_and_prune.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {

using geometry::BoundingSphere;

namespace {

/// Enlarged, so that spheres around several of them contain each after rounding, too.
BoundingSphere with_slack(const BoundingSphere& sphere) {
  return {sphere.center, sphere.radius + 1e-6 + 1e-9 * (norm(sphere.center) + sphere.radius)};
}

}  // namespace

void EntityTree::build(std::span<const BoundingSphere> reach, std::span<const FoundBy> found_by) {
  MUROSIMF_ASSERT(reach.size() == found_by.size());
  std::vector<BoundingSphere> spheres;
  std::vector<Vec3d> centers;
  entities_.clear();
  always_.clear();
  for (int i = 0; i < static_cast<int>(reach.size()); ++i) {
    if (found_by[i] == FoundBy::none) continue;
    if (found_by[i] == FoundBy::all || !geometry::is_bounded(reach[i])) {
      always_.push_back(i);
      continue;
    }
    entities_.push_back(i);
    spheres.push_back(with_slack(reach[i]));
    centers.push_back(reach[i].center);
  }
  std::vector<geometry::BoundingTree<BoundingSphere>::Leaf> leaves;
  for (int i = 0; i < static_cast<int>(spheres.size()); ++i) leaves.push_back({i, {{}, spheres[i].radius}});
  MUROSIMF_ASSERT(leaves.size() == entities_.size() && centers.size() == entities_.size());
  tree_ = {std::move(leaves), geometry::split_top_down(spheres)};
  tree_.refit(centers, std::vector<Mat3d>(centers.size()));
}

}  // namespace murosimf::collision
