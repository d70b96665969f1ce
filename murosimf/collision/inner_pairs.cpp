#include "murosimf/collision/inner_pairs.h"

#include <algorithm>

#include "murosimf/geometry/collide.h"
#include "murosimf/model/error.h"

namespace murosimf::collision {
namespace {

bool neighbors(const Tree& tree, int object_a, int object_b) {
  const int a = tree.link_of[object_a], b = tree.link_of[object_b];
  return a == b || tree.links[a].parent == b || tree.links[b].parent == a;
}

/// Numbers of the shapes that a name stands for.
std::vector<int> shapes_of(const Model& model, std::span<const CollidingShape> shapes, const std::string& name) {
  const int object = at("excluded pair", [&] { return model.object_index(name); });
  const auto numbers = [&](auto&& belongs) {
    std::vector<int> result;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (belongs(shapes[i].object)) result.push_back(static_cast<int>(i));
    }
    return result;
  };
  auto own = numbers([&](int other) { return other == object; });
  if (!own.empty()) return own;
  const auto& link_of = model.tree().link_of;
  return numbers([&](int other) { return link_of[other] == link_of[object]; });
}

}  // namespace

InnerPairs::InnerPairs(const Model& model, std::span<const CollidingShape> shapes,
                       const std::vector<ExcludedPair>& excluded)
    : count_(shapes.size()), may_touch_(count_ * count_, true) {
  const auto objects = rest_poses(model);
  std::vector<geometry::Pose> at_rest;
  for (const CollidingShape& shape : shapes) {
    at_rest.push_back(placed_in(objects[shape.object], {shape.placed.position, shape.placed.orientation}));
  }
  const int count = static_cast<int>(count_);
  geometry::Manifold overlap;
  for (int a = 0; a < count; ++a) {
    for (int b = a; b < count; ++b) {
      if (neighbors(model.tree(), shapes[a].object, shapes[b].object) ||
          geometry::collide(shapes[a].placed.shape, at_rest[a], shapes[b].placed.shape, at_rest[b], overlap)) {
        exclude(a, b);
      }
    }
  }
  for (const auto& [first, second] : excluded) {
    const auto others = shapes_of(model, shapes, second);
    for (const int a : shapes_of(model, shapes, first)) {
      for (const int b : others) exclude(a, b);
    }
  }
}

}  // namespace murosimf::collision
