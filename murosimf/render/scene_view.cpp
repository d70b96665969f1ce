#include "murosimf/render/scene_view.h"

#include <algorithm>
#include <limits>

#include "murosimf/render/depth_image.h"
#include "murosimf/render/field_drawing.h"
#include "murosimf/render/png.h"
#include "murosimf/render/shape_facets.h"

namespace murosimf::render {
namespace {

constexpr Color background{0.83, 0.86, 0.88};
constexpr double margin = 0.06;        // [1] of the picture, on each side
constexpr double flattest = 0.05;      // [1] sine of the lowest elevation from which the ground is drawn
constexpr double shadow_depth = 0.35;  // [1] how much light is gone
constexpr double ambient = 0.5;        // [1] light from everywhere

/// To the light: over the left shoulder of whoever looks, always from above.
Vec3d light_of(const View& view) {
  Vec3d light = -0.5 * view.right + 0.55 * view.up + 0.65 * view.toward;
  light.z = std::max(light.z, 0.4);
  return (1 / norm(light)) * light;
}

Color shaded(const Color& color, double light) {
  const double share = ambient + (1 - ambient) * std::max(0.0, light);
  return {share * color.red, share * color.green, share * color.blue};
}

bool is_placed(const ViewedShape& s) {
  const double sum = norm(s.position) + norm(s.orientation.x) + norm(s.orientation.y) + norm(s.orientation.z);
  return std::isfinite(sum);
}

/// The facets of a shape in the world.
std::vector<Facet> placed_facets(const ViewedShape& s) {
  std::vector<Facet> facets = s.facets.empty() ? shape_facets(s.shape) : s.facets;
  for (Facet& facet : facets) {
    for (Vec3d& p : facet) p = s.position + s.orientation * p;
  }
  return facets;
}

/// Zero for a facet without area.
Vec3d normal_of(const Facet& facet) {
  const Vec3d normal = cross(facet[1] - facet[0], facet[2] - facet[0]);
  const double area = norm(normal);
  return area > 0 ? (1 / area) * normal : Vec3d{};
}

void draw_ground(cairo_t* canvas, const Markings& markings, const View& view) {
  cairo_save(canvas);
  // the ground's axes as the picture sees them
  const Vec3d origin = view({}), x = view({1, 0, 0}) - origin, y = view({0, 1, 0}) - origin;
  const cairo_matrix_t to_picture{x.x, x.y, y.x, y.y, origin.x, origin.y};
  cairo_transform(canvas, &to_picture);
  cairo_rectangle(canvas, -markings.half_length, -markings.half_width, 2 * markings.half_length,
                  2 * markings.half_width);
  cairo_clip(canvas);
  draw_field(canvas, markings, frame_of(markings, view.scale));
  cairo_restore(canvas);
}

/// The ground from its edge.
void draw_ground_line(cairo_t* canvas, const View& view) {
  const double height = view({}).y;
  cairo_move_to(canvas, 0, height);
  cairo_line_to(canvas, view.columns, height);
  cairo_set_line_width(canvas, 2);
  set_color(canvas, {0.2, 0.45, 0.25});
  cairo_stroke(canvas);
}

/// Where a shape keeps the light from the ground.
void trace_shadow(cairo_t* canvas, const std::vector<Facet>& facets, const View& view, const Vec3d& light) {
  std::vector<Vec3d> points;
  for (const Facet& facet : facets) {
    for (const Vec3d& p : facet) points.push_back(view(p - (std::max(0.0, p.z) / light.z) * light));
  }
  trace(canvas, outline(points));
  cairo_close_path(canvas);
}

void draw_shadows(cairo_t* canvas, const std::vector<std::vector<Facet>>& bodies, const View& view) {
  const Vec3d light = light_of(view);
  cairo_push_group(canvas);
  set_color(canvas, {0, 0.06, 0.02});
  for (const auto& facets : bodies) {
    trace_shadow(canvas, facets, view, light);
    cairo_fill(canvas);
  }
  cairo_pop_group_to_source(canvas);
  cairo_paint_with_alpha(canvas, shadow_depth);
}

DepthImage draw_bodies(const std::vector<std::vector<Facet>>& bodies, const std::vector<Color>& colors,
                       const View& view) {
  DepthImage image(view.columns, view.rows);
  const Vec3d light = light_of(view);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (const Facet& facet : bodies[i]) {
      const Vec3d normal = normal_of(facet);
      if (!(dot(normal, view.toward) > 0)) continue;
      Facet seen;
      for (const Vec3d& p : facet) seen.push_back(view(p));
      image.fill(seen, shaded(colors[i], dot(normal, light)), static_cast<std::uint32_t>(i) + 1);
    }
  }
  image.draw_edges();
  return image;
}

void paint(cairo_t* canvas, const DepthImage& image, const View& view) {
  std::vector<std::uint32_t> pixels = image.pixels();
  const SurfacePtr surface(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                                               CAIRO_FORMAT_ARGB32, view.columns, view.rows,
                                                               4 * view.columns),
                           cairo_surface_destroy);
  cairo_set_source_surface(canvas, surface.get(), 0, 0);
  cairo_paint(canvas);
  cairo_set_source_rgb(canvas, 0, 0, 0);  // lets go of the pixels
  cairo_surface_finish(surface.get());
}

void draw_title(cairo_t* canvas, const View& view, const std::string& title) {
  if (title.empty()) return;
  const double size = std::clamp(view.rows / 28.0, 11.0, 28.0);
  set_font(canvas, size, true);
  cairo_rectangle(canvas, 0.5 * size, 0.5 * size, text_width(canvas, title) + size, 1.7 * size);
  set_color(canvas, white, 0.75);
  cairo_fill(canvas);
  show_text(canvas, size, 1.35 * size, title, {0.1, 0.12, 0.12});
}

/// What points take in a picture.
struct Bounds {
  void add(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

View fitted(View view, const std::vector<Vec3d>& points, int columns, int rows) {
  Bounds seen;  // [m] to the right, up, to the eye
  for (const Vec3d& p : points) seen.add({dot(view.right, p), dot(view.up, p), dot(view.toward, p)});
  if (points.empty()) seen.low = seen.high = {};
  const Vec3d middle = 0.5 * (seen.low + seen.high), size = seen.high - seen.low;
  view.center = middle.x * view.right + middle.y * view.up + middle.z * view.toward;
  const double room = 1 - 2 * margin;
  view.scale = std::min(room * columns / std::max(size.x, 1e-3), room * rows / std::max(size.y, 1e-3));
  view.columns = columns;
  view.rows = rows;
  return view;
}

}  // namespace

View view_of(const View& axes, const std::vector<ViewedShape>& shapes, int columns, int rows) {
  std::vector<Vec3d> points;
  for (const ViewedShape& shape : shapes) {
    if (!is_placed(shape)) continue;
    points.push_back(shape.position);
    for (const Facet& facet : placed_facets(shape)) points.insert(points.end(), facet.begin(), facet.end());
  }
  return fitted(axes, points, columns, rows);
}

View view_of(const View& axes, const Markings& markings, int columns, int rows) {
  const double x = markings.half_length, y = markings.half_width;
  return fitted(axes, {{x, y, 0}, {-x, y, 0}, {-x, -y, 0}, {x, -y, 0}}, columns, rows);
}

std::string scene_view_png(const Markings& markings, const std::vector<ViewedShape>& shapes, const View& view,
                           const std::string& title) {
  if (view.columns < 1 || view.rows < 1) refuse_picture("it has no pixels");
  if (std::max(view.columns, view.rows) > largest_side / 4) refuse_picture("it has too many pixels");
  if (!(view.scale > 0 && std::isfinite(view.scale + norm(view.center)))) refuse_picture("nothing would be seen");
  std::vector<std::vector<Facet>> bodies;
  std::vector<Color> colors;
  for (const ViewedShape& shape : shapes) {
    if (!is_placed(shape)) continue;
    bodies.push_back(placed_facets(shape));
    colors.push_back(shape.color);
  }
  const SurfacePtr picture(cairo_image_surface_create(CAIRO_FORMAT_RGB24, view.columns, view.rows),
                           cairo_surface_destroy);
  const CanvasPtr canvas(cairo_create(picture.get()), cairo_destroy);
  set_color(canvas.get(), background);
  cairo_paint(canvas.get());
  if (view.toward.z > flattest) {
    if (markings.half_length > 0 && markings.half_width > 0) draw_ground(canvas.get(), markings, view);
    draw_shadows(canvas.get(), bodies, view);
  } else if (markings.half_length > 0) {
    draw_ground_line(canvas.get(), view);
  }
  paint(canvas.get(), draw_bodies(bodies, colors, view), view);
  draw_title(canvas.get(), view, title);
  check(cairo_status(canvas.get()));
  return png_of(picture.get());
}

}  // namespace murosimf::render
