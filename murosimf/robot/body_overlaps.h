/// body_overlaps.h - overlapping shapes of two bodies of a robot's file, and bodies that are excluded from contact.
#pragma once

#include <algorithm>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Calls use(shape of a, its pose, shape of b, its pose) for each pair of shapes that collide and may touch each other, until it returns
/// true; then returns true. `at_a`, `at_b`: places of the bodies in a common frame.
template <class Use>
bool any_touching_pair(const robot_formats::BodyDescription& a, const Transformd& at_a,
                       const robot_formats::BodyDescription& b, const Transformd& at_b, Use&& use) {
  return std::ranges::any_of(a.shapes, [&](const robot_formats::ShapeDescription& first) {
    return std::ranges::any_of(b.shapes, [&](const robot_formats::ShapeDescription& second) {
      const PlacedShape &one = first.placed, &other = second.placed;
      if (!one.collides || !other.collides || !may_touch(one, other)) return false;
      return use(one.shape, at_a * one.place(), other.shape, at_b * other.place());
    });
  });
}

/// By names of bodies, in either order.
[[nodiscard]] inline bool is_excluded(const robot_formats::RobotDescription& description, const std::string& a,
                                      const std::string& b) {
  return std::ranges::any_of(description.exclusions, [&](const robot_formats::ExclusionDescription& pair) {
    return (pair.body1 == a && pair.body2 == b) || (pair.body1 == b && pair.body2 == a);
  });
}

}  // namespace murosimf::robot
