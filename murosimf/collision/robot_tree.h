/// robot_tree.h - the tree of a structured compound: a robot's own tree, made fit for collision detection (paper 5.1).
#pragma once

#include <span>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/geometry/tree_layout.h"

namespace murosimf::collision {

/// Objects without shapes become empty nodes; of these, those without children go and those with one give way to it.
/// Bodies with children move down to the leaves, beside their children, and nodes with more than two children get empty
/// nodes in between: always the two that fit into the smallest sphere while all joints are at zero, of equal ones those
/// that the model names first (the paper leaves the order open). Forks have no place of their own: their branches count
/// as children of what stands before them. A body of several shapes is split top-down in its leaf's place. A robot that
/// would be deeper than TreeLayout::most_depth (a long snake) is split top-down as a whole.
[[nodiscard]] geometry::TreeLayout robot_tree(const Model& model, std::span<const CollidingShape> shapes);

/// Spheres about the shapes with all joints at zero, in the base's frame.
[[nodiscard]] std::vector<geometry::BoundingSphere> rest_spheres(const Model& model,
                                                                 std::span<const CollidingShape> shapes);

}  // namespace murosimf::collision
