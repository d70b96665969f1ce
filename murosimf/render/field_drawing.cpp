#include "murosimf/render/field_drawing.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

constexpr Color line_white{0.96, 0.97, 0.95};
constexpr Color grass_light{0.243, 0.545, 0.271}, grass_dark{0.212, 0.502, 0.243};
constexpr double stripe_width = 0.5;  // [m]

bool is_closed(const Stroke& stroke) {
  if (stroke.points.size() < 3) return false;
  const Vec3d gap = stroke.points.back() - stroke.points.front();
  return norm(gap) < 1e-9;
}

bool is_goal(const Stroke& stroke, const PictureFrame& frame) {
  // Open strokes that reach beyond the outer lines are goals: the markings have no kind of their own.
  if (frame.lines_length == 0 || is_closed(stroke)) return false;
  return std::any_of(stroke.points.begin(), stroke.points.end(),
                     [&](const Vec3d& p) { return std::abs(p.x) > frame.lines_length; });
}

void draw_grass(cairo_t* canvas, const PictureFrame& frame) {
  set_color(canvas, grass_light);
  cairo_paint(canvas);
  // mown stripes; one begins at the half line
  const int stripes = static_cast<int>(std::ceil(frame.half_length / stripe_width));
  for (int i = -stripes; i < stripes; ++i) {
    if (i % 2 == 0) cairo_rectangle(canvas, i * stripe_width, -frame.half_width, stripe_width, 2 * frame.half_width);
  }
  set_color(canvas, grass_dark);
  cairo_fill(canvas);
  // the border strip is a little darker than the field
  cairo_rectangle(canvas, -frame.half_length, -frame.half_width, 2 * frame.half_length, 2 * frame.half_width);
  // The opposite direction makes a hole of the inner rectangle (non-zero winding rule).
  cairo_rectangle(canvas, frame.lines_length, -frame.lines_width, -2 * frame.lines_length, 2 * frame.lines_width);
  set_color(canvas, {0, 0.09, 0.02}, 0.24);
  cairo_fill(canvas);
}

void draw_line(cairo_t* canvas, const Stroke& stroke) {
  trace(canvas, stroke.points);
  if (is_closed(stroke)) cairo_close_path(canvas);
  cairo_set_line_width(canvas, stroke.width);
  set_color(canvas, line_white);
  cairo_stroke(canvas);
}

void draw_net(cairo_t* canvas, const Stroke& goal, double mesh) {
  MUROSIMF_ASSERT(mesh > 0);
  cairo_save(canvas);
  trace(canvas, goal.points);
  cairo_close_path(canvas);
  cairo_clip(canvas);
  set_color(canvas, black, 0.22);
  cairo_paint(canvas);
  double left, bottom, right, top;
  cairo_clip_extents(canvas, &left, &bottom, &right, &top);
  for (double x = left - (top - bottom); x < right; x += mesh) {
    cairo_move_to(canvas, x, bottom);
    cairo_line_to(canvas, x + top - bottom, top);
    cairo_move_to(canvas, x, top);
    cairo_line_to(canvas, x + top - bottom, bottom);
  }
  cairo_set_line_width(canvas, 0.1 * mesh);
  set_color(canvas, white, 0.5);
  cairo_stroke(canvas);
  cairo_restore(canvas);
}

void draw_goal(cairo_t* canvas, const Stroke& goal) {
  draw_net(canvas, goal, std::max(0.05, goal.width));
  trace(canvas, goal.points);
  cairo_set_line_width(canvas, goal.width);
  set_color(canvas, {0.45, 0.5, 0.47});
  cairo_stroke_preserve(canvas);
  cairo_set_line_width(canvas, 0.72 * goal.width);
  set_color(canvas, goal.color);
  cairo_stroke(canvas);
}

}  // namespace

PictureFrame frame_of(const Markings& markings, double pixels_per_meter) {
  PictureFrame frame{markings.half_length, markings.half_width, 0, 0, pixels_per_meter};
  for (const Stroke& stroke : markings.strokes) {
    if (!is_closed(stroke)) continue;
    for (const Vec3d& p : stroke.points) {
      frame.lines_length = std::max(frame.lines_length, std::abs(p.x) + stroke.width / 2);
      frame.lines_width = std::max(frame.lines_width, std::abs(p.y) + stroke.width / 2);
    }
  }
  return frame;
}

void draw_field(cairo_t* canvas, const Markings& markings, const PictureFrame& frame) {
  MUROSIMF_ASSERT(frame.scale > 0);
  draw_grass(canvas, frame);
  cairo_set_line_join(canvas, CAIRO_LINE_JOIN_MITER);
  cairo_set_line_cap(canvas, CAIRO_LINE_CAP_BUTT);
  for (const Stroke& stroke : markings.strokes) {
    if (!is_goal(stroke, frame)) draw_line(canvas, stroke);
  }
  // Goals above lines: a net covers the goal line's ends.
  for (const Stroke& stroke : markings.strokes) {
    if (is_goal(stroke, frame)) draw_goal(canvas, stroke);
  }
}

}  // namespace murosimf::render
