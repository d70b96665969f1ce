#include "murosimf/render/path_drawing.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::render {
namespace {

constexpr double path_width = 0.024;  // [m]

/// The pieces of a path between gaps, thinned to what is visible.
using Piece = std::vector<Vec3d>;

std::vector<Piece> visible_pieces(const std::vector<Vec3d>& points, const PictureFrame& frame) {
  std::vector<Piece> pieces(1);
  const double far = 10 * (frame.half_length + frame.half_width);  // cairo's fixed-point numbers are limited
  for (const Vec3d& p : points) {
    Piece& piece = pieces.back();
    if (!is_finite(p)) {
      if (!piece.empty()) pieces.emplace_back();
      continue;
    }
    const Vec3d seen{std::clamp(p.x, -far, far), std::clamp(p.y, -far, far), 0};
    if (piece.empty() || norm(Vec3d(seen - piece.back())) > 0.7 * frame.pixel()) piece.push_back(seen);
  }
  if (pieces.back().empty()) pieces.pop_back();
  return pieces;
}

/// Draws the line of a robot: pale at its beginning, strong at its end.
void draw_fading_line(cairo_t* canvas, const Piece& piece, const Color& color, double strength, double width) {
  MUROSIMF_ASSERT(piece.size() >= 2 && width > 0);
  constexpr std::size_t shades = 48;
  // In a group, a later shade replaces an earlier one instead of adding to it where they overlap.
  cairo_push_group(canvas);
  cairo_set_operator(canvas, CAIRO_OPERATOR_SOURCE);
  cairo_set_line_width(canvas, width);
  const std::size_t segments = piece.size() - 1, step = segments / shades + 1;
  for (std::size_t begin = 0; begin < segments; begin += step) {
    const std::size_t end = std::min(begin + step, segments);
    trace(canvas, std::span(piece).subspan(begin, end - begin + 1));
    set_color(canvas, color, strength * (0.55 + 0.45 * static_cast<double>(end) / static_cast<double>(segments)));
    cairo_stroke(canvas);
  }
  cairo_pop_group_to_source(canvas);
  cairo_paint(canvas);
}

void draw_robot_path(cairo_t* canvas, const Path& path, const PictureFrame& frame) {
  const double width = std::max(path_width, 1.6 * frame.pixel());
  const std::vector<Piece> pieces = visible_pieces(path.points, frame);
  for (const Piece& piece : pieces) {
    if (piece.size() < 2) continue;
    draw_fading_line(canvas, piece, mix(path.color, black, 0.75), 0.45, width + 2.5 * frame.pixel());
    draw_fading_line(canvas, piece, mix(path.color, white, 0.15), 1, width);
  }
}

void draw_ball_path(cairo_t* canvas, const Path& path, const PictureFrame& frame) {
  const double width = std::max(path_width, 1.6 * frame.pixel());
  const double dashes[] = {2.6 * width, 2.4 * width};
  cairo_set_dash(canvas, dashes, 2, 0);
  for (const Piece& piece : visible_pieces(path.points, frame)) {
    trace(canvas, piece);
    cairo_set_line_width(canvas, width + 1.6 * frame.pixel());
    set_color(canvas, white);
    cairo_stroke_preserve(canvas);
    cairo_set_line_width(canvas, width);
    set_color(canvas, path.color);
    cairo_stroke(canvas);
  }
  cairo_set_dash(canvas, nullptr, 0, 0);
}

void draw_start(cairo_t* canvas, const Path& path, const PictureFrame& frame) {
  const auto first = std::find_if(path.points.begin(), path.points.end(), is_finite);
  if (first == path.points.end()) return;
  // A white ring with a dark rim: visible on grass, lines and the path itself.
  const double pixel = frame.pixel(), radius = std::max(0.036, 3.5 * pixel);
  circle(canvas, first->x, first->y, radius);
  fill_with_edge(canvas, white, mix(path.color, black, 0.6), std::max(0.026, 3 * pixel) + 1.5 * pixel);
  circle(canvas, first->x, first->y, radius);
  fill_with_edge(canvas, white, path.color, std::max(0.022, 2.5 * pixel));
}

// ---- robots and ball ----

void draw_arrow(cairo_t* canvas, double size, const Color& color, double edge) {
  cairo_move_to(canvas, 1.5 * size, 0);
  cairo_line_to(canvas, 0.66 * size, 0.5 * size);
  cairo_line_to(canvas, 0.66 * size, -0.5 * size);
  cairo_close_path(canvas);
  fill_with_edge(canvas, white, mix(color, black, 0.65), edge);
}

/// Draws feet, shoulders with arms, and head, looking along x.
void draw_body(cairo_t* canvas, double size, const Color& color, double edge) {
  MUROSIMF_ASSERT(size > 0);
  const Color dark = mix(color, black, 0.65);
  for (const double side : {1.0, -1.0}) {
    cairo_save(canvas);
    cairo_translate(canvas, 0.14 * size, side * 0.42 * size);
    rounded_box(canvas, 0.48 * size, 0.25 * size, 0.16 * size);
    fill_with_edge(canvas, {0.33, 0.34, 0.37}, {0.1, 0.1, 0.11}, edge);
    cairo_restore(canvas);
  }
  rounded_box(canvas, 0.42 * size, 0.98 * size, 0.4 * size);
  fill_with_edge(canvas, color, dark, edge);
  circle(canvas, 0, 0, 0.54 * size);
  fill_with_edge(canvas, mix(color, black, 0.22), dark, edge);
}

/// Draws a number upright, independent of the robot's heading.
void draw_number(cairo_t* canvas, double x, double y, double font, const std::string& number, const Color& color) {
  cairo_save(canvas);
  cairo_user_to_device(canvas, &x, &y);
  cairo_identity_matrix(canvas);
  set_font(canvas, font, true);
  show_text(canvas, x - text_width(canvas, number) / 2, y, number, color);
  cairo_restore(canvas);
}

void draw_robot(cairo_t* canvas, const Path& path, const PictureFrame& frame) {
  if (path.points.empty() || !is_finite(path.points.back())) return;
  const Vec3d& place = path.points.back();
  const double size = std::max(7 * frame.pixel(), path.size), edge = std::max(0.09 * size, 1.2 * frame.pixel());
  MUROSIMF_ASSERT(size > 0 && edge > 0);
  soft_shadow(canvas, place.x + 0.18 * size, place.y - 0.24 * size, 1.4 * size);
  cairo_save(canvas);
  cairo_translate(canvas, place.x, place.y);
  cairo_rotate(canvas, std::isfinite(path.heading) ? path.heading : 0);
  draw_arrow(canvas, size, path.color, edge);
  draw_body(canvas, size, path.color, edge);
  cairo_restore(canvas);
  if (path.number < 0) return;
  const Color ink = brightness(path.color) > 0.65 ? Color{0.05, 0.05, 0.06} : white;
  const std::string number = std::to_string(path.number);
  const double font = size * frame.scale * (number.size() > 1 ? 0.62 : 0.8);
  draw_number(canvas, place.x, place.y, font, number, ink);
}

void draw_ball(cairo_t* canvas, const Path& path, const PictureFrame& frame) {
  if (path.points.empty() || !is_finite(path.points.back())) return;
  const Vec3d& place = path.points.back();
  const double radius = std::max(4.5 * frame.pixel(), path.size);
  MUROSIMF_ASSERT(radius > 0);
  soft_shadow(canvas, place.x + 0.3 * radius, place.y - 0.4 * radius, 1.7 * radius);
  circle(canvas, place.x, place.y, radius);
  fill_with_edge(canvas, path.color, mix(path.color, black, 0.55), std::max(0.12 * radius, 1.2 * frame.pixel()));
  circle(canvas, place.x - 0.3 * radius, place.y + 0.32 * radius, 0.24 * radius);
  set_color(canvas, white, 0.85);
  cairo_fill(canvas);
}

}  // namespace

void draw_paths(cairo_t* canvas, const std::vector<Path>& paths, const PictureFrame& frame) {
  cairo_set_line_join(canvas, CAIRO_LINE_JOIN_ROUND);
  // Paths first, then starts, robots and the ball: what stands last hides the least.
  for (const Path& path : paths) {
    if (!path.is_ball) draw_robot_path(canvas, path, frame);
  }
  cairo_set_line_cap(canvas, CAIRO_LINE_CAP_BUTT);
  for (const Path& path : paths) {
    if (path.is_ball) draw_ball_path(canvas, path, frame);
  }
  for (const Path& path : paths) draw_start(canvas, path, frame);
  for (const Path& path : paths) {
    if (!path.is_ball) draw_robot(canvas, path, frame);
  }
  for (const Path& path : paths) {
    if (path.is_ball) draw_ball(canvas, path, frame);
  }
}

}  // namespace murosimf::render
