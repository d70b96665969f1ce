#include "murosimf/collision/robot_tree.h"

#include <algorithm>

namespace murosimf::collision {

using geometry::TreeBuilder;
using geometry::TreeLayout;

std::vector<geometry::BoundingSphere> rest_spheres(const Model& model, std::span<const CollidingShape> shapes) {
  const auto poses = rest_poses(model);
  std::vector<geometry::BoundingSphere> spheres;
  for (const CollidingShape& shape : shapes) {
    const Transformd at = poses[shape.object] * shape.placed.place();
    spheres.push_back(geometry::fit<geometry::BoundingSphere>(shape.placed.shape, at));
  }
  return spheres;
}

TreeLayout robot_tree(const Model& model, std::span<const CollidingShape> shapes) {
  const auto spheres = rest_spheres(model, shapes);
  if (shapes.empty()) return {};
  std::vector<std::vector<int>> own(static_cast<std::size_t>(model.size()));  // leaves of each object
  for (std::size_t i = 0; i < shapes.size(); ++i) own[shapes[i].object].push_back(static_cast<int>(i));

  TreeBuilder builder(spheres);
  std::vector<std::vector<TreeBuilder::Part>> parts(own.size());  // what hangs on each object
  for (int i = model.size() - 1; i >= 0; --i) {
    std::vector<TreeBuilder::Part>& here = parts[i];
    if (!own[i].empty()) here.push_back(builder.split(own[i]));
    std::reverse(here.begin(), here.end());  // children came last to first
    if (here.empty() || i == 0) continue;
    const Object& object = model.objects()[i];
    if (object.kind != Kind::fork || !own[i].empty()) here = {builder.join_nearest(here)};
    // of a fork, all branches go to what stands before it
    auto& before = parts[object.parent];
    before.insert(before.end(), here.rbegin(), here.rend());
  }
  const TreeLayout layout = builder.layout(builder.join_nearest(parts[0]));
  return layout.depth() <= TreeLayout::most_depth ? layout : geometry::split_top_down(spheres);
}

}  // namespace murosimf::collision
