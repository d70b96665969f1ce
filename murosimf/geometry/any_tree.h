/// any_tree.h - a bounding tree whose kind of volume is chosen by name at run time.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "murosimf/geometry/bounding_tree.h"

namespace murosimf::geometry {

using AnyTree =
    std::variant<BoundingTree<BoundingSphere>, BoundingTree<Aabb>, BoundingTree<Obb>, BoundingTree<BoundingCapsule>>;

/// "sphere", "aabb", "obb", "capsule".
[[nodiscard]] const std::vector<std::string_view>& volume_names();

/// A finite shape at a place in the frame of an object.
struct TreePart {
  int object = 0;
  const Shape* shape = nullptr;
  Transformd at;
};

/// A tree of `volume`s with a margin [m], one leaf for each part. Throws SetupError with the nearest name if there is no such volume.
[[nodiscard]] AnyTree make_tree(std::string_view volume, std::span<const TreePart> parts, const TreeLayout& layout,
                                double margin = 0);

}  // namespace murosimf::geometry
