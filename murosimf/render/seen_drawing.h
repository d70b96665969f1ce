/// seen_drawing.h - drawings for observers (world/drawing.h) projected into a picture: lines, areas and words in its pixels.
///
/// Over the picture, not in it: they are not hidden by objects.
#pragma once

#include <string>
#include <vector>

#include "murosimf/imaging/image.h"
#include "murosimf/math/transform.h"
#include "murosimf/sensors/view_source.h"
#include "murosimf/world/drawing.h"

namespace murosimf::render {

/// Points are pixels, x to the right and y down from the top left corner.
struct SeenShape {
  enum class Kind { line, area, words };
  Kind kind = Kind::line;
  std::vector<Vec3d> points;  ///< middle of words
  double size = 1;            ///< [px] width of lines, height of words
  Color color;
  double opacity = 1;
  std::string words;
};

/// Projects a shape. `frame`: of the shape's points, in the world. Parts behind the eye are cut off.
void see(const DrawnShape& shape, const Transformd& frame, const sensors::Perspective& view,
         std::vector<SeenShape>& into);

/// [px] Width of words of that height, without the margin of their background, which has a quarter of the height on each side. Throws
/// SetupError if this build has no pictures.
[[nodiscard]] double width_of_words(const std::string& words, double height);

/// Draws them over a picture. Throws SetupError if this build has no pictures.
void draw_over(imaging::ColorImage& picture, const std::vector<SeenShape>& shapes);

}  // namespace murosimf::render
