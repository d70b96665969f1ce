/// canvas.h - helpers on a cairo canvas: colors, shapes, text.
///
/// Only for the .cpp files of this folder: it brings cairo in.
#pragma once

#include <memory>
#include <span>
#include <string>

#include <cairo/cairo.h>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

inline constexpr Color white{1, 1, 1}, black{0, 0, 0};

/// Linear blend: `share` 0 gives a, 1 gives b.
[[nodiscard]] Color mix(const Color& a, const Color& b, double share);
/// Luminance [1] with the weights of Rec. 709.
[[nodiscard]] double brightness(const Color& c);
[[nodiscard]] bool is_finite(const Vec3d& p);

void set_color(cairo_t* canvas, const Color& c, double alpha = 1);
void trace(cairo_t* canvas, std::span<const Vec3d> points);
void circle(cairo_t* canvas, double x, double y, double radius);
/// Rectangle about the origin with round corners.
void rounded_box(cairo_t* canvas, double half_x, double half_y, double radius);
/// Fills the present path and strokes its edge.
void fill_with_edge(cairo_t* canvas, const Color& fill, const Color& edge, double edge_width);
void soft_shadow(cairo_t* canvas, double x, double y, double radius);

void set_font(cairo_t* canvas, double size, bool bold);
[[nodiscard]] double text_width(cairo_t* canvas, const std::string& text);
/// Shows text; its left end and the middle of its capitals lie at (x, y) [pixels].
void show_text(cairo_t* canvas, double x, double y, const std::string& text, const Color& color);

}  // namespace murosimf::render
