#include "murosimf/render/overlay_drawing.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

/// Draws the head of an arrow with its tip at the origin, pointing along x.
void draw_head(cairo_t* canvas, double size) {
  cairo_move_to(canvas, 0, 0);
  cairo_line_to(canvas, -size, 0.45 * size);
  cairo_line_to(canvas, -0.75 * size, 0);
  cairo_line_to(canvas, -size, -0.45 * size);
  cairo_close_path(canvas);
  cairo_fill(canvas);
}

void draw_head_at(cairo_t* canvas, const Vec3d& tip, const Vec3d& along, double size) {
  cairo_save(canvas);
  cairo_translate(canvas, tip.x, tip.y);
  cairo_rotate(canvas, std::atan2(along.y, along.x));
  draw_head(canvas, size);
  cairo_restore(canvas);
}

void draw_line(cairo_t* canvas, const OverlayLine& line, double pixel) {
  if (line.points.size() < 2 || !std::all_of(line.points.begin(), line.points.end(), is_finite)) return;
  MUROSIMF_ASSERT(pixel > 0);
  const double width = std::max(line.width, 1.5 * pixel);
  set_color(canvas, line.color);
  cairo_set_line_width(canvas, width);
  trace(canvas, line.points);
  cairo_stroke(canvas);
  if (!line.arrow) return;
  const Vec3d& tip = line.points.back();
  const Vec3d along = tip - line.points[line.points.size() - 2];
  // The head reaches a little beyond the end, so that the blunt end of the line stays covered.
  const double size = 5 * width, length = norm(along);
  if (length > 0) draw_head_at(canvas, tip + (0.6 * size / length) * along, along, size);
}

void draw_circle(cairo_t* canvas, const OverlayCircle& shown, double pixel) {
  if (!is_finite(shown.center) || !std::isfinite(shown.radius)) return;
  circle(canvas, shown.center.x, shown.center.y, shown.radius);
  set_color(canvas, shown.color);
  cairo_set_line_width(canvas, std::max(0.025, 1.5 * pixel));
  shown.filled ? cairo_fill(canvas) : cairo_stroke(canvas);
}

void draw_arrow(cairo_t* canvas, const OverlayArrow& arrow, double pixel) {
  if (!is_finite(arrow.pose) || !std::isfinite(arrow.pose.z)) return;
  cairo_save(canvas);
  cairo_translate(canvas, arrow.pose.x, arrow.pose.y);
  cairo_rotate(canvas, arrow.pose.z);
  set_color(canvas, arrow.color);
  cairo_set_line_width(canvas, std::max(0.07 * arrow.length, 1.2 * pixel));
  cairo_move_to(canvas, 0, 0);
  cairo_line_to(canvas, 0.7 * arrow.length, 0);
  cairo_stroke(canvas);
  cairo_translate(canvas, arrow.length, 0);
  draw_head(canvas, 0.42 * arrow.length);
  cairo_restore(canvas);
}

}  // namespace

void draw_overlay(cairo_t* canvas, const Overlay& overlay, const PictureFrame& frame) {
  cairo_set_line_join(canvas, CAIRO_LINE_JOIN_ROUND);
  for (const OverlayLine& line : overlay.lines) draw_line(canvas, line, frame.pixel());
  for (const OverlayCircle& circle : overlay.circles) draw_circle(canvas, circle, frame.pixel());
  for (const OverlayArrow& arrow : overlay.arrows) draw_arrow(canvas, arrow, frame.pixel());
}

}  // namespace murosimf::render
