/// field_points.h - places on the field by which a robot finds out where it is: crossings and corners of lines, marks, feet of posts.
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/shape.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::dataset {

/// L: two lines end there at an angle; T: one ends on another; X: two cross. A circle is a line.
struct FieldPoint {
  std::string name;  ///< "L1", "T3", "X2": kind, and number by x, then y
  char kind = 'X';
  Vec3d place;  ///< [m] world, on the ground
};

/// Of all lines, by the middles of their paint; goals (strokes with a color of their own) are no lines.
[[nodiscard]] std::vector<FieldPoint> crossings_of(const Markings& markings, const scene_file::FieldSize& field);

/// Corners of a goal's opening: feet and tops of its posts, in the middle of each post. Left and right as seen from the field.
struct GoalPoints {
  double side = 1;  ///< 1: at x > 0
  std::vector<Vec3d> places;
};
inline const std::vector<std::string> goal_point_names{"left_foot", "right_foot", "left_top", "right_top"};

[[nodiscard]] GoalPoints goal_points(const scene_file::FieldSize& field, double side);

}  // namespace murosimf::dataset
