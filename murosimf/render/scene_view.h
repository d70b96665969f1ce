/// scene_view.h - a picture of bodies on the ground by parallel projection, from any side: shaded, the near ones hide
/// the far ones, with shadows.
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/shape.h"
#include "murosimf/render/view.h"

namespace murosimf::render {

/// A shape at its place in the world.
struct ViewedShape {
  Shape shape;
  Vec3d position;     ///< [m] of the shape's origin
  Mat3d orientation;  ///< shape axes to world axes
  Color color;
  /// Flat convex polygons [m], counterclockwise seen from outside, in the shape's frame; they are drawn instead of `shape`
  /// unless there are none.
  std::vector<std::vector<Vec3d>> facets{};
};

/// Places all of `shapes` so that they fill a picture of `columns` by `rows` pixels, but for a margin. `axes`: as from
/// view_from(); a plane counts as a point.
[[nodiscard]] View view_of(const View& axes, const std::vector<ViewedShape>& shapes, int columns, int rows);
/// The same for the ground of a field.
[[nodiscard]] View view_of(const View& axes, const Markings& markings, int columns, int rows);

/// A PNG file, as bytes. The ground (z = 0) is drawn with its markings if `view` sees it from above by more than 3 degrees,
/// else as a line; markings without extent are no ground. Places that are not finite are left out. Throws SetupError if the picture cannot be drawn, or if this build
/// has no pictures. `title`: UTF-8, one line.
[[nodiscard]] std::string scene_view_png(const Markings& markings, const std::vector<ViewedShape>& shapes,
                                         const View& view, const std::string& title = {});

}  // namespace murosimf::render
