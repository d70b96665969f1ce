#include "murosimf/viewer/overlay_shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/viewer/orbit_camera.h"

namespace murosimf::viewer {
namespace {

using render::SeenShape;

constexpr double filled_opacity = 0.3;
constexpr double gap = 1;  // [px] between labels at least

/// A head at the end of the last line; a very short arrow would be hidden by it.
void add_head(const Mark& mark, const OverlayStyle& style, std::vector<SeenShape>& into) {
  if (into.empty() || into.back().kind != SeenShape::Kind::line) return;
  const std::vector<Vec3d> line = into.back().points;
  MUROSIMF_ASSERT(line.size() == 2);
  const Vec3d along = line[1] - line[0];
  const double length = std::hypot(along.x, along.y);
  if (length < 3) return;
  const double size = std::min(style.width * (4 + 2 * mark.width), 0.6 * length);
  const Vec3d ahead = (1 / length) * along, across{-ahead.y, ahead.x, 0}, back = line[1] - size * ahead;
  into.push_back({.kind = SeenShape::Kind::area,
                  .points = {line[1], back + 0.5 * size * across, back - 0.5 * size * across},
                  .color = mark.color,
                  .words = {}});
}

void add_mark(const Mark& mark, const sensors::Perspective& view, const OverlayStyle& style,
              std::vector<SeenShape>& into) {
  DrawnShape shape{.kind = DrawnShape::dots, .points = mark.points, .color = mark.color};
  if (mark.points.size() < 2) return render::see(shape, {}, view, into);
  if (mark.filled && mark.points.size() > 2) {
    shape.kind = DrawnShape::polygon;
    shape.opacity = filled_opacity;
    render::see(shape, {}, view, into);
  }
  shape.kind = DrawnShape::line;
  shape.opacity = 1;
  if (mark.closed) shape.points.push_back(mark.points.front());
  const std::size_t first = into.size();
  render::see(shape, {}, view, into);
  for (std::size_t i = first; i < into.size(); ++i) into[i].size = style.width * mark.width;
  if (mark.arrow && into.size() > first) add_head(mark, style, into);
}

/// [px] A label in the picture.
struct Placed {
  const Label* label = nullptr;
  Vec3d at;             // of what it says the name
  double distance = 0;  // [m]
  Vec3d middle;         // of its words
  double half_x = 0, half_y = 0;
};

bool overlap(const Placed& a, const Placed& b) {
  return std::abs(a.middle.x - b.middle.x) < a.half_x + b.half_x &&
         std::abs(a.middle.y - b.middle.y) < a.half_y + b.half_y;
}

/// Those in the picture, the nearest one first.
std::vector<Placed> seen_labels(const std::vector<Label>& labels, const sensors::Perspective& view,
                                const OverlayStyle& style) {
  std::vector<Placed> seen;
  for (const Label& label : labels) {
    const auto at = pixel_of(view, label.place);
    if (!at || label.text.empty() || at->x < 0 || at->x > view.width || at->y < 0 || at->y > view.height) continue;
    Placed placed{.label = &label,
                  .at = {at->x, at->y, 0},
                  .distance = dot(view.axes.z, label.place - view.eye),
                  .middle = {at->x, at->y, 0},
                  .half_x = 0.5 * render::width_of_words(label.text, style.letters) + 0.3 * style.letters,
                  .half_y = 0.75 * style.letters};
    if (2 * placed.half_x <= view.width) {
      placed.middle.x = std::clamp(placed.middle.x, placed.half_x, view.width - placed.half_x);
    }
    seen.push_back(placed);
  }
  std::ranges::stable_sort(seen, {}, &Placed::distance);
  return seen;
}

/// Moves a label to the nearest free place above, or else below. False if there is none.
bool find_room(Placed& one, const std::vector<Placed>& others, double top, double bottom) {
  for (const double way : {-1.0, 1.0}) {
    one.middle.y = std::clamp(one.at.y, top + one.half_y, std::max(top, bottom) - one.half_y);
    while (one.middle.y - one.half_y >= top && one.middle.y + one.half_y <= bottom) {
      const auto in_the_way = std::ranges::find_if(others, [&](const Placed& other) { return overlap(one, other); });
      if (in_the_way == others.end()) return true;
      one.middle.y = in_the_way->middle.y + way * (in_the_way->half_y + one.half_y + gap);
    }
  }
  return false;
}

void add_labels(const std::vector<Label>& labels, const sensors::Perspective& view, const OverlayStyle& style,
                std::vector<SeenShape>& into) {
  std::vector<Placed> placed;
  for (Placed& one : seen_labels(labels, view, style)) {
    if (2 * one.half_y > view.height - style.top) continue;
    if (find_room(one, placed, style.top, view.height)) placed.push_back(one);
  }
  for (const Placed& one : placed) {
    if (std::abs(one.middle.y - one.at.y) < 2 * one.half_y) continue;
    into.push_back({.points = {one.at, one.middle}, .size = style.width, .color = one.label->color, .words = {}});
  }
  for (const Placed& one : placed) {
    into.push_back({.kind = SeenShape::Kind::words,
                    .points = {one.middle},
                    .size = style.letters,
                    .color = one.label->color,
                    .words = one.label->text});
  }
}

}  // namespace

std::vector<SeenShape> shapes_of(const Overlays& overlays, const sensors::Perspective& view,
                                 const OverlayStyle& style) {
  std::vector<SeenShape> shapes;
  for (const Mark& mark : overlays.marks) add_mark(mark, view, style, shapes);
  add_labels(overlays.labels, view, style, shapes);
  return shapes;
}

}  // namespace murosimf::viewer
