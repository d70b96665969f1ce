// Overlays of world coordinates as lines, dots and letters over the picture.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/render/polygon_triangles.h"
#include "murosimf/viewer/window/panels.h"

namespace murosimf::viewer {
namespace {

constexpr double nearest_drawn = 0.02;  // [m] distance from the eye at which lines are clipped

ImVec2 in_area(const Pixel& pixel, const Area& area) { return vec2(area.x + pixel.x, area.y + pixel.y); }

/// Clips a line to the part in front of the eye; false if there is none.
bool cut(const sensors::Perspective& view, Vec3d& a, Vec3d& b) {
  const double za = dot(view.axes.z, a - view.eye), zb = dot(view.axes.z, b - view.eye);
  if (za < nearest_drawn && zb < nearest_drawn) return false;
  if (za < nearest_drawn) a = b + ((zb - nearest_drawn) / (zb - za)) * (a - b);
  if (zb < nearest_drawn) b = a + ((za - nearest_drawn) / (za - zb)) * (b - a);
  return true;
}

/// A head on a very short arrow would hide it.
void paint_head(ImDrawList& list, const ImVec2& from, const ImVec2& to, ImU32 color, double width) {
  const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
  if (length < 3) return;
  const double size = std::min(scaled(4) + 2 * width, 0.6 * length), ux = x / length, uy = y / length;
  const double bx = to.x - size * ux, by = to.y - size * uy;
  list.AddTriangleFilled(to, vec2(bx - 0.5 * size * uy, by + 0.5 * size * ux),
                         vec2(bx + 0.5 * size * uy, by - 0.5 * size * ux), color);
}

void paint_segment(ImDrawList& list, const sensors::Perspective& view, const Area& area, Vec3d a, Vec3d b,
                   const Mark& mark, bool head) {
  if (!cut(view, a, b)) return;
  const auto from = pixel_of(view, a), to = pixel_of(view, b);
  if (!from || !to) return;
  const ImU32 color = packed(mark.color);
  const ImVec2 p = in_area(*from, area), q = in_area(*to, area);
  const double width = scaled(mark.width);
  list.AddLine(p, q, color, static_cast<float>(width));
  if (head) paint_head(list, p, q, color, width);
}

/// An area that reaches behind the eye is left out: its corners have no pixels.
void paint_filled(ImDrawList& list, const sensors::Perspective& view, const Area& area, const Mark& mark) {
  std::vector<ImVec2> corners;
  for (const Vec3d& point : mark.points) {
    const auto pixel = pixel_of(view, point);
    if (!pixel) return;
    corners.push_back(in_area(*pixel, area));
  }
  list.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), packed(mark.color, 0.25));
}

void paint(ImDrawList& list, const sensors::Perspective& view, const Area& area, const Mark& mark) {
  if (mark.points.size() == 1) {
    const auto pixel = pixel_of(view, mark.points[0]);
    if (!pixel) return;
    const auto radius = static_cast<float>(scaled(mark.width));
    if (mark.filled) list.AddCircleFilled(in_area(*pixel, area), radius, packed(mark.color));
    list.AddCircle(in_area(*pixel, area), radius, mark.filled ? IM_COL32(0, 0, 0, 160) : packed(mark.color), 12, 1.5F);
    return;
  }
  if (mark.filled && mark.points.size() > 2) paint_filled(list, view, area, mark);
  for (std::size_t i = 0; i + 1 < mark.points.size(); ++i) {
    paint_segment(list, view, area, mark.points[i], mark.points[i + 1], mark,
                  mark.arrow && i + 2 == mark.points.size());
  }
  if (mark.closed && mark.points.size() > 2)
    paint_segment(list, view, area, mark.points.back(), mark.points.front(), mark, false);
}

/// `points`: of the shape, in the window.
void paint_area(ImDrawList& list, const render::SeenShape& shape, const std::vector<ImVec2>& points, ImU32 color) {
  if (render::is_convex(shape.points)) {
    return list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), color);
  }
  const ImDrawListFlags flags = list.Flags;
  list.Flags = flags & ~ImDrawListFlags_AntiAliasedFill;  // smooth borders would show as seams
  for (const auto& [a, b, c] : render::polygon_triangles(shape.points)) {
    list.AddTriangleFilled(points[a], points[b], points[c], color);
  }
  list.Flags = flags;
}

/// Letters with a dark shade behind, readable on grass and shirts.
void paint_letters(ImDrawList& list, const ImVec2& middle, const std::string& letters, ImU32 color, float height = 0) {
  const float scale = height > 0 ? height / ImGui::GetFontSize() : 1;
  const ImVec2 usual = ImGui::CalcTextSize(letters.c_str()), size(scale * usual.x, scale * usual.y);
  const ImVec2 corner = vec2(std::round(middle.x - 0.5 * size.x), std::round(middle.y - 0.5 * size.y));
  list.AddRectFilled(vec2(corner.x - 3, corner.y - 1), vec2(corner.x + size.x + 3, corner.y + size.y + 1),
                     IM_COL32(0, 0, 0, 120), 3);
  list.AddText(ImGui::GetFont(), scale * ImGui::GetFontSize(), corner, color, letters.c_str());
}

/// Clips to the area.
class Clipped {
 public:
  explicit Clipped(const Area& area) : list(*ImGui::GetBackgroundDrawList()) {
    list.PushClipRect(vec2(area.x, area.y), vec2(area.x + area.width, area.y + area.height));
  }
  ~Clipped() { list.PopClipRect(); }
  Clipped(const Clipped&) = delete;
  Clipped& operator=(const Clipped&) = delete;
  ImDrawList& list;
};

}  // namespace

void paint_overlays(const Overlays& overlays, const sensors::Perspective& view, const Area& area) {
  const Clipped clipped(area);
  for (const Mark& mark : overlays.marks) paint(clipped.list, view, area, mark);
  for (const Label& label : overlays.labels) {
    if (const auto pixel = pixel_of(view, label.place)) {
      paint_letters(clipped.list, in_area(*pixel, area), label.text, packed(label.color));
    }
  }
}

void paint_drawings(const std::vector<render::SeenShape>& shapes, const Area& area) {
  const Clipped clipped(area);
  for (const render::SeenShape& shape : shapes) {
    const ImU32 color = packed(shape.color, shape.opacity);
    std::vector<ImVec2> points;
    for (const Vec3d& point : shape.points) points.push_back(in_area({point.x, point.y}, area));
    const int count = static_cast<int>(points.size());
    switch (shape.kind) {
      case render::SeenShape::Kind::line:
        clipped.list.AddPolyline(points.data(), count, color, 0, static_cast<float>(shape.size));
        break;
      case render::SeenShape::Kind::area: paint_area(clipped.list, shape, points, color); break;
      case render::SeenShape::Kind::words:
        paint_letters(clipped.list, points[0], shape.words, color, static_cast<float>(shape.size));
        break;
    }
  }
}

/// The arrow is drawn in the world, the force as text beside its end.
void paint_pull(const MouseControl::Pull& pull, const sensors::Perspective& view, const Area& area) {
  const Clipped clipped(area);
  const Mark arrow{.points = {pull.from, pull.to}, .color = {1, 0.35, 0.1}, .width = 4, .arrow = true};
  paint(clipped.list, view, area, arrow);
  if (const auto pixel = pixel_of(view, pull.to)) {
    const bool turns = norm(pull.moment) > 0;
    paint_letters(clipped.list, in_area({pixel->x, pixel->y - scaled(18)}, area),
                  turns ? fmt::format("{:.2f} N m", norm(pull.moment)) : fmt::format("{:.1f} N", norm(pull.force)),
                  packed({1, 0.8, 0.5}));
  }
}

/// A ring on the ground, which other bodies hardly hide.
void paint_selection(const Viewer& viewer, const sensors::Perspective& view, const Area& area) {
  if (!viewer.selected()) return;
  const Clipped clipped(area);
  const auto base = viewer.poses().place_of({viewer.selected()->entity, 0});
  if (!base) return;
  Mark ring{.color = {1, 1, 1}, .width = 2, .closed = true};
  constexpr int corners = 32;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    ring.points.push_back({base->x + 0.26 * std::cos(angle), base->y + 0.26 * std::sin(angle), 0.004});
  }
  paint(clipped.list, view, area, ring);
  const auto place = viewer.selected()->object == 0 ? std::nullopt : viewer.poses().place_of(*viewer.selected());
  if (!place) return;
  paint(clipped.list, view, area, {.points = {*place}, .color = {1, 1, 1}, .width = 5});
}

}  // namespace murosimf::viewer
