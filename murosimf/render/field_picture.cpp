#include "murosimf/render/field_picture.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include <cairo/cairo.h>
#include <fmt/format.h>
#include <unistd.h>

#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::render {
namespace {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using CanvasPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using FilePtr = std::unique_ptr<std::FILE, decltype(&std::fclose)>;
using PatternPtr = std::unique_ptr<cairo_pattern_t, decltype(&cairo_pattern_destroy)>;

constexpr Color white{1, 1, 1}, black{0, 0, 0};
constexpr Color line_white{0.96, 0.97, 0.95};
constexpr Color grass_light{0.243, 0.545, 0.271}, grass_dark{0.212, 0.502, 0.243};
constexpr double stripe_width = 0.5;  // [m]
constexpr double path_width = 0.024;  // [m]

// ---- colors, points and text ----

Color mix(const Color& a, const Color& b, double share) {
  const auto blend = [share](double x, double y) { return x + share * (y - x); };
  return {blend(a.red, b.red), blend(a.green, b.green), blend(a.blue, b.blue)};
}

/// Rec. 709 weights.
double brightness(const Color& c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

void set_color(cairo_t* canvas, const Color& c, double alpha = 1) {
  cairo_set_source_rgba(canvas, c.red, c.green, c.blue, alpha);
}

bool is_finite(const Vec3d& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

void trace(cairo_t* canvas, std::span<const Vec3d> points) {
  for (const Vec3d& p : points) cairo_line_to(canvas, p.x, p.y);
}

void circle(cairo_t* canvas, double x, double y, double radius) {
  cairo_new_sub_path(canvas);
  cairo_arc(canvas, x, y, radius, 0, 2 * pi);
}

/// Rectangle about the origin with round corners.
void rounded_box(cairo_t* canvas, double half_x, double half_y, double radius) {
  cairo_new_sub_path(canvas);
  cairo_arc(canvas, half_x - radius, half_y - radius, radius, 0, pi / 2);
  cairo_arc(canvas, -half_x + radius, half_y - radius, radius, pi / 2, pi);
  cairo_arc(canvas, -half_x + radius, -half_y + radius, radius, pi, 1.5 * pi);
  cairo_arc(canvas, half_x - radius, -half_y + radius, radius, 1.5 * pi, 2 * pi);
  cairo_close_path(canvas);
}

/// Fills the present path and draws its edge.
void fill_with_edge(cairo_t* canvas, const Color& fill, const Color& edge, double edge_width) {
  set_color(canvas, fill);
  cairo_fill_preserve(canvas);
  set_color(canvas, edge);
  cairo_set_line_width(canvas, edge_width);
  cairo_stroke(canvas);
}

void soft_shadow(cairo_t* canvas, double x, double y, double radius) {
  const PatternPtr shade(cairo_pattern_create_radial(x, y, 0.3 * radius, x, y, radius), cairo_pattern_destroy);
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

/// Text whose left end and whose middle of capitals lie at (x, y) [pixels].
void show_text(cairo_t* canvas, double x, double y, const std::string& text, const Color& color) {
  cairo_text_extents_t capital;
  cairo_text_extents(canvas, "H", &capital);
  cairo_move_to(canvas, x, y - capital.y_bearing / 2);
  set_color(canvas, color);
  cairo_show_text(canvas, text.c_str());
}

// ---- the field ----

struct Frame {
  double half_length = 0, half_width = 0;                   // [m] of the picture
  double lines_length = 0, lines_width = 0;                 // [m] half, of the area inside the outer lines
  double scale = 0;                                         // [pixels/m]
  [[nodiscard]] double pixel() const { return 1 / scale; }  // [m]
  [[nodiscard]] int columns() const { return static_cast<int>(std::lround(2 * half_length * scale)); }
  [[nodiscard]] int rows() const { return static_cast<int>(std::lround(2 * half_width * scale)); }
};

bool is_closed(const Stroke& stroke) {
  if (stroke.points.size() < 3) return false;
  const Vec3d gap = stroke.points.back() - stroke.points.front();
  return norm(gap) < 1e-9;
}

Frame frame_of(const Markings& markings, const FieldPictureOptions& options) {
  Frame frame{markings.half_length, markings.half_width, 0, 0, static_cast<double>(options.pixels_per_meter)};
  for (const Stroke& stroke : markings.strokes) {
    if (!is_closed(stroke)) continue;
    for (const Vec3d& p : stroke.points) {
      frame.lines_length = std::max(frame.lines_length, std::abs(p.x) + stroke.width / 2);
      frame.lines_width = std::max(frame.lines_width, std::abs(p.y) + stroke.width / 2);
    }
  }
  return frame;
}

bool is_goal(const Stroke& stroke, const Frame& frame) {
  if (frame.lines_length == 0 || is_closed(stroke)) return false;
  return std::any_of(stroke.points.begin(), stroke.points.end(),
                     [&](const Vec3d& p) { return std::abs(p.x) > frame.lines_length; });
}

void draw_grass(cairo_t* canvas, const Frame& frame) {
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
  set_color(canvas, white);
  cairo_stroke(canvas);
}

void draw_field(cairo_t* canvas, const Markings& markings, const Frame& frame) {
  draw_grass(canvas, frame);
  cairo_set_line_join(canvas, CAIRO_LINE_JOIN_MITER);
  cairo_set_line_cap(canvas, CAIRO_LINE_CAP_BUTT);
  for (const Stroke& stroke : markings.strokes) {
    if (!is_goal(stroke, frame)) draw_line(canvas, stroke);
  }
  for (const Stroke& stroke : markings.strokes) {
    if (is_goal(stroke, frame)) draw_goal(canvas, stroke);
  }
}

// ---- paths ----

/// A piece of a path without gaps, thinned to what can be seen.
using Piece = std::vector<Vec3d>;

std::vector<Piece> visible_pieces(const std::vector<Vec3d>& points, const Frame& frame) {
  std::vector<Piece> pieces(1);
  const double far = 10 * (frame.half_length + frame.half_width);  // cairo's numbers end somewhere beyond
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

/// The line of a robot: pale where it began, strong where it is now.
void draw_fading_line(cairo_t* canvas, const Piece& piece, const Color& color, double strength, double width) {
  constexpr std::size_t shades = 48;
  // in a group, a later shade replaces an earlier one instead of adding to it where they overlap
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

void draw_robot_path(cairo_t* canvas, const Path& path, const Frame& frame) {
  const double width = std::max(path_width, 1.6 * frame.pixel());
  const std::vector<Piece> pieces = visible_pieces(path.points, frame);
  for (const Piece& piece : pieces) {
    if (piece.size() < 2) continue;
    draw_fading_line(canvas, piece, mix(path.color, black, 0.75), 0.45, width + 2.5 * frame.pixel());
    draw_fading_line(canvas, piece, mix(path.color, white, 0.15), 1, width);
  }
}

void draw_ball_path(cairo_t* canvas, const Path& path, const Frame& frame) {
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

void draw_start(cairo_t* canvas, const Path& path, const Frame& frame) {
  const auto first = std::find_if(path.points.begin(), path.points.end(), is_finite);
  if (first == path.points.end()) return;
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

/// Feet, shoulders with arms, and head, looking along x.
void draw_body(cairo_t* canvas, double size, const Color& color, double edge) {
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

/// Upright, whatever way the robot looks.
void draw_number(cairo_t* canvas, double x, double y, double font, const std::string& number, const Color& color) {
  cairo_save(canvas);
  cairo_user_to_device(canvas, &x, &y);
  cairo_identity_matrix(canvas);
  set_font(canvas, font, true);
  show_text(canvas, x - text_width(canvas, number) / 2, y, number, color);
  cairo_restore(canvas);
}

void draw_robot(cairo_t* canvas, const Path& path, const Frame& frame) {
  if (path.points.empty() || !is_finite(path.points.back())) return;
  const Vec3d& place = path.points.back();
  const double size = std::max(7 * frame.pixel(), path.size), edge = std::max(0.09 * size, 1.2 * frame.pixel());
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

void draw_ball(cairo_t* canvas, const Path& path, const Frame& frame) {
  if (path.points.empty() || !is_finite(path.points.back())) return;
  const Vec3d& place = path.points.back();
  const double radius = std::max(4.5 * frame.pixel(), path.size);
  soft_shadow(canvas, place.x + 0.3 * radius, place.y - 0.4 * radius, 1.7 * radius);
  circle(canvas, place.x, place.y, radius);
  fill_with_edge(canvas, path.color, mix(path.color, black, 0.55), std::max(0.12 * radius, 1.2 * frame.pixel()));
  circle(canvas, place.x - 0.3 * radius, place.y + 0.32 * radius, 0.24 * radius);
  set_color(canvas, white, 0.85);
  cairo_fill(canvas);
}

void draw_paths(cairo_t* canvas, const std::vector<Path>& paths, const Frame& frame) {
  cairo_set_line_join(canvas, CAIRO_LINE_JOIN_ROUND);
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

// ---- title and legend, in the border strip, in pixels ----

struct LegendEntry {
  std::string label;
  const Path* path = nullptr;  // null: what the ring at the start of a path means
};

/// "blue_2" belongs to "blue".
std::string team_name(const Path& path) {
  const std::size_t end = path.name.find_last_not_of("0123456789");
  if (path.is_ball || end == std::string::npos) return path.name;
  const std::size_t last = path.name.find_last_not_of("_-. ", end);
  return last == std::string::npos ? path.name : path.name.substr(0, last + 1);
}

std::vector<LegendEntry> legend_entries(const std::vector<Path>& paths) {
  std::vector<LegendEntry> entries;
  for (const bool ball : {false, true}) {
    for (const Path& path : paths) {
      const std::string label = team_name(path);
      const auto same = [&](const LegendEntry& entry) { return entry.label == label; };
      if (path.is_ball == ball && std::none_of(entries.begin(), entries.end(), same)) entries.push_back({label, &path});
    }
  }
  if (!entries.empty()) entries.push_back({"start", nullptr});
  return entries;
}

/// A symbol of the size of a capital, its middle at (x, y).
void draw_swatch(cairo_t* canvas, const LegendEntry& entry, double x, double y, double font) {
  const double radius = 0.42 * font;
  const Color color = entry.path ? entry.path->color : white;
  if (entry.path && !entry.path->is_ball) {
    cairo_save(canvas);
    cairo_translate(canvas, x, y);
    rounded_box(canvas, radius, radius, 0.4 * radius);
    fill_with_edge(canvas, color, white, 0.09 * font);
    cairo_restore(canvas);
    return;
  }
  circle(canvas, x, y, entry.path ? radius : 0.8 * radius);
  set_color(canvas, color);
  if (entry.path) cairo_fill_preserve(canvas);
  set_color(canvas, white);
  cairo_set_line_width(canvas, (entry.path ? 0.09 : 0.2) * font);
  cairo_stroke(canvas);
}

void draw_scale_bar(cairo_t* canvas, double right, double y, double font, double scale) {
  const double left = right - scale, tick = 0.28 * font;
  cairo_move_to(canvas, left, y - tick);
  cairo_line_to(canvas, left, y + tick);
  cairo_move_to(canvas, left, y);
  cairo_line_to(canvas, right, y);
  cairo_move_to(canvas, right, y - tick);
  cairo_line_to(canvas, right, y + tick);
  cairo_set_line_width(canvas, std::max(1.5, 0.12 * font));
  set_color(canvas, white);
  cairo_stroke(canvas);
  show_text(canvas, left - 0.4 * font - text_width(canvas, "1 m"), y, "1 m", white);
}

/// The largest font up to `font` with which `width(font)` fits.
double fitting_font(double font, double room, const std::function<double(double)>& width) {
  const double needed = width(font);
  return needed > room ? font * room / needed : font;
}

void draw_title(cairo_t* canvas, const Frame& frame, const std::string& title, double strip, double room, double left) {
  const auto width = [&](double font) {
    set_font(canvas, font, true);
    return text_width(canvas, title);
  };
  const double font = fitting_font(std::min(0.36 * strip, std::max(12.0, 0.2 * frame.scale)), room, width);
  set_font(canvas, font, true);
  show_text(canvas, left, strip / 2, title, white);
}

void draw_legend(cairo_t* canvas, const Frame& frame, const std::vector<LegendEntry>& entries, double strip,
                 double room, double left) {
  const auto width = [&](double font) {
    set_font(canvas, font, false);
    double sum = 0.4 * font + text_width(canvas, "1 m");
    for (const LegendEntry& entry : entries) sum += text_width(canvas, entry.label) + 2.8 * font;
    return sum;
  };
  const double room_beside_bar = std::max(room - frame.scale, 0.2 * room);
  const double font = fitting_font(std::min(0.34 * strip, std::max(10.0, 0.13 * frame.scale)), room_beside_bar, width);
  set_font(canvas, font, false);
  const double y = frame.rows() - strip / 2;
  double x = left + 0.5 * font;
  for (const LegendEntry& entry : entries) {
    draw_swatch(canvas, entry, x, y, font);
    show_text(canvas, x + 0.8 * font, y, entry.label, white);
    x += 2.8 * font + text_width(canvas, entry.label);
  }
  draw_scale_bar(canvas, left + room, y, font, frame.scale);
}

void draw_writing(cairo_t* canvas, const Frame& frame, const std::vector<Path>& paths, const std::string& title) {
  constexpr double thinnest_strip = 20;  // [pixels] below, no letter could be read
  const double strip = (frame.half_width - frame.lines_width) * frame.scale;
  if (strip < thinnest_strip || frame.lines_width == 0) return;
  const double left = (frame.half_length - frame.lines_length) * frame.scale;
  const double room = 2 * frame.lines_length * frame.scale;
  if (!title.empty()) draw_title(canvas, frame, title, strip, room, left);
  draw_legend(canvas, frame, legend_entries(paths), strip, room, left);
}

// ---- the file ----

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw SetupError(fmt::format("cannot write picture '{}': {}", file.string(), reason));
}

void check(const std::filesystem::path& file, cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) refuse(file, cairo_status_to_string(status));
}

std::string encode(const std::filesystem::path& file, cairo_surface_t* picture) {
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  check(file, cairo_surface_write_to_png_stream(picture, append, &bytes));
  return bytes;
}

/// 0, or errno of what failed.
int write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  FilePtr out(std::fopen(file.c_str(), "wb"), std::fclose);
  if (!out) return errno;
  if (std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) return errno;
  return std::fclose(out.release()) == 0 ? 0 : errno;
}

/// A full disk must not leave half a picture: write beside the file, then rename.
void replace_file(const std::filesystem::path& file, const std::string& bytes) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::is_directory(file, error)) refuse(file, "it is a folder");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) refuse(file, fmt::format("there is no folder '{}'", folder.string()));
  // a device or pipe cannot be replaced
  const bool special = fs::is_other(file, error);
  const fs::path target = special ? file : fs::path(file.string() + fmt::format(".{}.part", ::getpid()));
  int failure = write_bytes(target, bytes);
  if (!failure && !special) {
    fs::rename(target, file, error);
    failure = error.value();
  }
  if (!failure) return;
  if (!special) fs::remove(target, error);
  refuse(file, std::generic_category().message(failure));
}

Frame checked_frame(const std::filesystem::path& file, const Markings& markings, const FieldPictureOptions& options) {
  constexpr double largest = 16384;  // [pixels] cairo ends at 32767, and this is a gigabyte already
  const Frame frame = frame_of(markings, options);
  const double longer = 2 * frame.scale * std::max(frame.half_length, frame.half_width);
  if (!(frame.half_length > 0 && frame.half_width > 0)) refuse(file, "the markings have no half_length or half_width");
  if (frame.scale <= 0 || frame.columns() < 1 || frame.rows() < 1) refuse(file, "pixels_per_meter is too small");
  if (!(longer <= largest)) refuse(file, fmt::format("pixels_per_meter is too large: over {} pixels", largest));
  return frame;
}

}  // namespace

void write_field_picture(const std::filesystem::path& file, const Markings& markings, const std::vector<Path>& paths,
                         const FieldPictureOptions& options) {
  const Frame frame = checked_frame(file, markings, options);
  const SurfacePtr picture(cairo_image_surface_create(CAIRO_FORMAT_RGB24, frame.columns(), frame.rows()),
                           cairo_surface_destroy);
  const CanvasPtr canvas(cairo_create(picture.get()), cairo_destroy);
  cairo_save(canvas.get());
  cairo_translate(canvas.get(), frame.columns() / 2.0, frame.rows() / 2.0);
  cairo_scale(canvas.get(), frame.scale, -frame.scale);
  draw_field(canvas.get(), markings, frame);
  draw_paths(canvas.get(), paths, frame);
  cairo_restore(canvas.get());
  draw_writing(canvas.get(), frame, paths, options.title);
  check(file, cairo_status(canvas.get()));
  replace_file(file, encode(file, picture.get()));
}

}  // namespace murosimf::render
