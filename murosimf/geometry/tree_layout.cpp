#include "murosimf/geometry/tree_layout.h"

#include <limits>
#include <numeric>

namespace murosimf::geometry {
namespace {

/// The box's longest axis as a unit vector.
Vec3d longest_axis(const Vec3d& half) {
  if (half.x >= half.y && half.x >= half.z) return {1, 0, 0};
  return half.y >= half.z ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
}

}  // namespace

int TreeLayout::depth() const {
  int deepest = 0;
  std::vector<int> depths(children.size());
  for (std::size_t i = 0; i < children.size(); ++i) {
    for (const int child : children[i]) {
      if (child < static_cast<int>(children.size())) depths[child] = depths[i] + 1;
      deepest = std::max(deepest, depths[i] + 1);
    }
  }
  return deepest;
}

TreeLayout split_top_down(std::span<const BoundingSphere> leaves) {
  if (leaves.empty()) return {};
  std::vector<int> all(leaves.size());
  std::iota(all.begin(), all.end(), 0);
  TreeBuilder builder(leaves);
  return builder.layout(builder.split(all));
}

TreeBuilder::Part TreeBuilder::join(const Part& a, const Part& b) {
  joints_.push_back({a.node, b.node});
  return {static_cast<int>(leaves_.size() + joints_.size()) - 1, merged(a.sphere, b.sphere)};
}

TreeBuilder::Part TreeBuilder::join_nearest(std::vector<Part> parts) {
  while (parts.size() > 1) {
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t first = 0, second = 1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t j = i + 1; j < parts.size(); ++j) {
        const double radius = merged(parts[i].sphere, parts[j].sphere).radius;
        if (radius >= smallest) continue;
        smallest = radius;
        first = i;
        second = j;
      }
    }
    parts[first] = join(parts[first], parts[second]);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(second));
  }
  return parts.front();
}

TreeBuilder::Part TreeBuilder::split(std::vector<int> leaves) {
  if (leaves.size() == 1) return leaf(leaves.front());
  const auto center = [&](int i) -> const Vec3d& { return leaves_[static_cast<std::size_t>(i)].center; };
  Aabb box{center(leaves.front()), {}};
  for (const int i : leaves) box = merged(box, Aabb{center(i), {}});
  const Vec3d axis = longest_axis(box.half);
  std::stable_sort(leaves.begin(), leaves.end(),
                   [&](int i, int j) { return dot(axis, center(i)) < dot(axis, center(j)); });
  const auto middle = leaves.begin() + static_cast<std::ptrdiff_t>(leaves.size() / 2);
  const Part low = split({leaves.begin(), middle});
  return join(low, split({middle, leaves.end()}));
}

TreeLayout TreeBuilder::layout(const Part& root) const {
  const int leaf_count = static_cast<int>(leaves_.size());
  TreeLayout result;
  result.leaves = leaf_count;
  std::vector<int> order;  // of the joints, parents first
  if (root.node >= leaf_count) order.push_back(root.node - leaf_count);
  const auto number = [&](int node) {
    if (node < leaf_count) return leaf_count - 1 + node;
    order.push_back(node - leaf_count);
    return static_cast<int>(order.size()) - 1;
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [first, second] = joints_[static_cast<std::size_t>(order[i])];
    const int a = number(first);
    result.children.push_back({a, number(second)});
  }
  return result;
}

}  // namespace murosimf::geometry
