#include "murosimf/render/legend.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

struct LegendEntry {
  std::string label;
  const Path* path = nullptr;  // null: the entry that explains the ring at the start of a path
};

/// The team of a path: "blue_2" belongs to "blue".
std::string team_name(const Path& path) {
  const std::size_t end = path.name.find_last_not_of("0123456789");
  if (end == std::string::npos) return path.name;
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

/// Draws a symbol of the size of a capital, its middle at (x, y).
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
  MUROSIMF_ASSERT(font > 0);
  const double needed = width(font);
  return needed > room ? font * room / needed : font;
}

void draw_title(cairo_t* canvas, const PictureFrame& frame, const std::string& title, double strip, double room,
                double left) {
  const auto width = [&](double font) {
    set_font(canvas, font, true);
    return text_width(canvas, title);
  };
  const double font = fitting_font(std::min(0.36 * strip, std::max(12.0, 0.2 * frame.scale)), room, width);
  set_font(canvas, font, true);
  show_text(canvas, left, strip / 2, title, white);
}

void draw_legend(cairo_t* canvas, const PictureFrame& frame, const std::vector<LegendEntry>& entries, double strip,
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

}  // namespace

void draw_writing(cairo_t* canvas, const PictureFrame& frame, const std::vector<Path>& paths,
                  const std::string& title) {
  constexpr double thinnest_strip = 20;  // [pixels] below, letters are illegible
  const double strip = (frame.half_width - frame.lines_width) * frame.scale;
  if (strip < thinnest_strip || frame.lines_width == 0) return;
  const double left = (frame.half_length - frame.lines_length) * frame.scale;
  const double room = 2 * frame.lines_length * frame.scale;
  if (!title.empty()) draw_title(canvas, frame, title, strip, room, left);
  draw_legend(canvas, frame, legend_entries(paths), strip, room, left);
}

}  // namespace murosimf::render
