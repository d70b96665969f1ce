#include "murosimf/render/canvas.h"

#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::render {

Color mix(const Color& a, const Color& b, double share) {
  MUROSIMF_ASSERT(share >= 0 && share <= 1);
  const auto blend = [share](double x, double y) { return x + share * (y - x); };
  return {blend(a.red, b.red), blend(a.green, b.green), blend(a.blue, b.blue)};
}

double brightness(const Color& c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

void set_color(cairo_t* canvas, const Color& c, double alpha) {
  cairo_set_source_rgba(canvas, c.red, c.green, c.blue, alpha);
}

bool is_finite(const Vec3d& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void trace(cairo_t* canvas, std::span<const Vec3d> points) {
  for (const Vec3d& p : points) cairo_line_to(canvas, p.x, p.y);
}

void circle(cairo_t* canvas, double x, double y, double radius) {
  // A new sub path: otherwise cairo joins the present point with the beginning of the arc.
  cairo_new_sub_path(canvas);
  cairo_arc(canvas, x, y, radius, 0, 2 * pi);
}

void rounded_box(cairo_t* canvas, double half_x, double half_y, double radius) {
  MUROSIMF_ASSERT(radius <= half_x && radius <= half_y);
  cairo_new_sub_path(canvas);
  cairo_arc(canvas, half_x - radius, half_y - radius, radius, 0, pi / 2);
  cairo_arc(canvas, -half_x + radius, half_y - radius, radius, pi / 2, pi);
  cairo_arc(canvas, -half_x + radius, -half_y + radius, radius, pi, 1.5 * pi);
  cairo_arc(canvas, half_x - radius, -half_y + radius, radius, 1.5 * pi, 2 * pi);
  cairo_close_path(canvas);
}

void fill_with_edge(cairo_t* canvas, const Color& fill, const Color& edge, double edge_width) {
  set_color(canvas, fill);
  cairo_fill_preserve(canvas);
  set_color(canvas, edge);
  cairo_set_line_width(canvas, edge_width);
  cairo_stroke(canvas);
}

void soft_shadow(cairo_t* canvas, double x, double y, double radius) {
  MUROSIMF_ASSERT(radius > 0);
  const std::unique_ptr<cairo_pattern_t, decltype(&cairo_pattern_destroy)> shade(
      cairo_pattern_create_radial(x, y, 0.3 * radius, x, y, radius), cairo_pattern_destroy);
  cairo_pattern_add_color_stop_rgba(shade.get(), 0, 0, 0.08, 0, 0.45);
  cairo_pattern_add_color_stop_rgba(shade.get(), 1, 0, 0.08, 0, 0);
  cairo_set_source(canvas, shade.get());
  circle(canvas, x, y, radius);
  cairo_fill(canvas);
}

void set_font(cairo_t* canvas, double size, bool bold) {
  cairo_select_font_face(canvas, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(canvas, size);
}

double text_width(cairo_t* canvas, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(canvas, text.c_str(), &extents);
  return extents.x_advance;
}

void show_text(cairo_t* canvas, double x, double y, const std::string& text, const Color& color) {
  cairo_text_extents_t capital;
  cairo_text_extents(canvas, "H", &capital);
  cairo_move_to(canvas, x, y - capital.y_bearing / 2);
  set_color(canvas, color);
  cairo_show_text(canvas, text.c_str());
}

}  // namespace murosimf::render
