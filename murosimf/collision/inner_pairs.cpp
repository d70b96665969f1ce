#include "murosimf/collision/inner_pairs.h"

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/geometry/collide.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

bool neighbors(const Tree& tree, int object_a, int object_b) {
  MUROSIMF_ASSERT(static_cast<std::size_t>(object_a) < tree.link_of.size() &&
                  static_cast<std::size_t>(object_b) < tree.link_of.size());
  const int a = tree.link_of[object_a], b = tree.link_of[object_b];
  return a == b || tree.links[a].parent == b || tree.links[b].parent == a;
}

/// Numbers of the shapes that a name stands for.
std::vector<int> shapes_of(const Model& model, std::span<const CollidingShape> shapes, const std::string& name) {
  const int object = with_context("excluded pair", [&] { return model.object_index(name); });
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

/// Number of one shape.
int number_of(const Model& model, std::span<const CollidingShape> shapes, const ShapeOfObject& wanted) {
  const int object = with_context("allowed pair", [&] { return model.object_index(wanted.object); });
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].object == object && shapes[i].index == static_cast<int>(wanted.index)) return static_cast<int>(i);
  }
  throw SetupError(
      fmt::format("allowed pair: '{}' has no shape {} that collides", model.objects()[object].name, wanted.index));
}

template <class Pairs>
Pairs of_base(const Model& model, const Property<Pairs>& property) {
  const Pairs* pairs = model.find(property, 0);
  return pairs ? *pairs : Pairs{};
}

}  // namespace

InnerPairs::InnerPairs(const Model& model, std::span<const CollidingShape> shapes, const ExcludedPairs& excluded)
    : count_(shapes.size()), may_touch_(count_ * count_, true) {
  exclude_near(model, shapes);
  exclude(model, shapes, of_base(model, properties::excluded_pairs));
  exclude(model, shapes, excluded);
  allow(model, shapes, of_base(model, properties::allowed_pairs));
}

void InnerPairs::exclude_near(const Model& model, std::span<const CollidingShape> shapes) {
  const auto objects = rest_poses(model);
  std::vector<Transformd> at_rest;
  for (const CollidingShape& shape : shapes) {
    at_rest.push_back(objects[shape.object] * shape.placed.place());
  }
  MUROSIMF_ASSERT(at_rest.size() == count_);
  const int count = static_cast<int>(count_);
  geometry::Manifold overlap;
  for (int a = 0; a < count; ++a) {
    for (int b = a; b < count; ++b) {
      if (neighbors(model.tree(), shapes[a].object, shapes[b].object) ||
          !murosimf::may_touch(shapes[a].placed, shapes[b].placed) ||
          geometry::collide(shapes[a].placed.shape, at_rest[a], shapes[b].placed.shape, at_rest[b], overlap)) {
        set(a, b, false);
      }
    }
  }
}

void InnerPairs::exclude(const Model& model, std::span<const CollidingShape> shapes, const ExcludedPairs& pairs) {
  for (const auto& [first, second] : pairs) {
    const auto others = shapes_of(model, shapes, second);
    for (const int a : shapes_of(model, shapes, first)) {
      for (const int b : others) set(a, b, false);
    }
  }
}

void InnerPairs::allow(const Model& model, std::span<const CollidingShape> shapes, const AllowedPairs& pairs) {
  for (const auto& [first, second] : pairs) {
    const int a = number_of(model, shapes, first), b = number_of(model, shapes, second);
    if (a != b) set(a, b, true);
  }
}

}  // namespace murosimf::collision
