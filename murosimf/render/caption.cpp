#include "murosimf/render/caption.h"

#include <algorithm>

#include "murosimf/render/seen_drawing.h"

namespace murosimf::render {

void draw_caption(imaging::ColorImage& picture, const std::string& words) {
  constexpr double width_of_letter = 0.58;  // [1] of the height of a line, at most on average
  const double height = std::max(10.0, picture.height() / 24.0);
  const Vec3d middle{0.5 * picture.width(), picture.height() - 1.2 * height, 0};
  const Vec3d half{0.5 * height * (width_of_letter * static_cast<double>(words.size()) + 1), 0.8 * height, 0};
  const auto corner = [&](double x, double y) { return middle + Vec3d{x * half.x, y * half.y, 0}; };
  draw_over(picture, {SeenShape{.kind = SeenShape::Kind::area,
                                .points = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
                                .color = {0, 0, 0},
                                .opacity = 0.55,
                                .words = {}},
                      SeenShape{.kind = SeenShape::Kind::words,
                                .points = {middle},
                                .size = height,
                                .color = {1, 1, 1},
                                .words = words}});
}

}  // namespace murosimf::render
