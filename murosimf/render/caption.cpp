#include "murosimf/render/caption.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/render/seen_drawing.h"

namespace murosimf::render {
namespace {

constexpr double away = 1.2, half_bar = 0.8, half_square = 0.4, room_of_square = 1.1;  // [1] of the height of a line

double line_height(int height) { return std::max(10.0, height / 24.0); }

/// A rectangle about its middle.
SeenShape rectangle(const Vec3d& middle, double half_x, double half_y, const Color& color, double opacity) {
  const auto corner = [&](double x, double y) { return middle + Vec3d{x * half_x, y * half_y, 0}; };
  return {.kind = SeenShape::Kind::area,
          .points = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)},
          .color = color,
          .opacity = opacity,
          .words = {}};
}

}  // namespace

double caption_room(int height) { return (away + half_bar) * line_height(height); }

void draw_caption(imaging::ColorImage& picture, const std::string& words, CaptionPlace place,
                  std::span<const Color> ends) {
  MUROSIMF_ASSERT(ends.empty() || ends.size() == 2);
  if (picture.empty()) return;
  const double height = line_height(picture.height());
  const double of_words = 0.5 * width_of_words(words, height);
  const double half = of_words + (0.5 + (ends.empty() ? 0 : room_of_square)) * height;
  const Vec3d middle{place == CaptionPlace::top_left ? 0.4 * height + half : 0.5 * picture.width(),
                     place == CaptionPlace::bottom ? picture.height() - away * height : away * height, 0};
  std::vector<SeenShape> shapes{rectangle(middle, half, half_bar * height, {0, 0, 0}, 0.55)};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double to_side = of_words + (0.25 + 0.5 * room_of_square) * height;
    const Vec3d at = middle + Vec3d{i == 0 ? -to_side : to_side, 0, 0};
    shapes.push_back(rectangle(at, half_square * height, half_square * height, ends[i], 1));
  }
  shapes.push_back(SeenShape{
      .kind = SeenShape::Kind::words, .points = {middle}, .size = height, .color = {1, 1, 1}, .words = words});
  draw_over(picture, shapes);
}

}  // namespace murosimf::render
