/// line_points.h - points on the white lines of a green field, along columns and rows of a picture.
///
/// Every `spacing` pixels a column and a row are scanned for runs that are not green between green on both sides. Such
/// a run is a line if something in it is bright and gray enough, and if on the ground it is as wide as lines are: at most
/// `widest`, less what the borders of pixels may add. The point is the middle of the run's ends on the ground.
/// What stands on the ground (posts, robots) is a line only where it happens to be as wide.
/// Source: scan lines as of Jamzad et al., "Middle sized robots: ICE team", RoboCup 1999, and many since.
#pragma once

#include <vector>

#include "murosimf/imaging/image.h"
#include "murosimf/soccer/color_class.h"
#include "murosimf/soccer/ground_projection.h"

namespace murosimf::soccer {

struct LineScan {
  ColorClass green = field_green;
  int spacing = 12;           ///< [px] of the columns and of the rows
  int fewest_green = 3;       ///< [px] on both sides
  double least_white = 0.35;  ///< [1] of the darkest of the three colors, somewhere in the run
  double widest = 0.12;       ///< [m] of a run; lines are often crossed at an angle
  double farthest = 3;        ///< [m] from the robot
  std::size_t most = 400;     ///< points
};

struct LinePoint {
  Vec3d place;           ///< [m] on the ground, robot's frame (ground_projection.h)
  imaging::Pixel pixel;  ///< [px] middle of the run
};

/// Writes the points of a picture to `points`; columns from the left, each from the top, then rows likewise.
void find_line_points(const imaging::ColorImage& picture, const imaging::Lens& lens, const CameraPose& pose,
                      const LineScan& scan, std::vector<LinePoint>& points) noexcept;

}  // namespace murosimf::soccer
