#include "murosimf/dataset/field_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace murosimf::dataset {
namespace {

constexpr double same_place = 0.03;  // [m] lines end half of their width inside each other
constexpr double arm = 0.08;         // [m] how far a line must go on to count as an arm of a crossing

struct Segment {
  Vec3d from, to;
  std::size_t stroke = 0;
};

double distance(const Vec3d& p, const Segment& s) {
  const Vec3d along = s.to - s.from;
  const double t = std::clamp(dot(p - s.from, along) / dot(along, along), 0.0, 1.0);
  return norm(p - (s.from + t * along));
}

/// Where two segments meet, lengthened at both ends by same_place; false: nowhere, or they are parallel.
bool meet(const Segment& a, const Segment& b, Vec3d& at) {
  const Vec3d u = a.to - a.from, v = b.to - b.from, w = b.from - a.from;
  const double cross_uv = u.x * v.y - u.y * v.x;
  if (std::abs(cross_uv) < 1e-3 * norm(u) * norm(v)) return false;
  const double s = (w.x * v.y - w.y * v.x) / cross_uv, t = (w.x * u.y - w.y * u.x) / cross_uv;
  const double more_s = same_place / norm(u), more_t = same_place / norm(v);
  if (s < -more_s || s > 1 + more_s || t < -more_t || t > 1 + more_t) return false;
  at = a.from + s * u;
  return true;
}

/// Lines without the outlines of goals, which reach beyond the lines.
std::vector<Segment> lines_of(const Markings& markings, const scene_file::FieldSize& field) {
  std::vector<Segment> lines;
  for (std::size_t i = 0; i < markings.strokes.size(); ++i) {
    const Stroke& stroke = markings.strokes[i];
    const auto beyond = [&](const Vec3d& p) { return std::abs(p.x) > 0.5 * field.length; };
    if (std::ranges::any_of(stroke.points, beyond)) continue;
    for (std::size_t k = 0; k + 1 < stroke.points.size(); ++k) {
      lines.push_back({stroke.points[k], stroke.points[k + 1], i});
    }
  }
  return lines;
}

/// In how many of eight directions a line goes on from there; a circle is nearly straight on that length.
int arms_at(const Vec3d& p, const std::vector<Segment>& lines) {
  int arms = 0;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::acos(-1.0) / 4;
    const Vec3d there = p + arm * Vec3d{std::cos(angle), std::sin(angle), 0};
    const auto near = [&](const Segment& s) { return distance(there, s) < 0.25 * arm; };
    if (std::ranges::any_of(lines, near)) ++arms;
  }
  return arms;
}

bool is_corner(const Segment& a, const Segment& b) {
  const Vec3d u = a.to - a.from, v = b.to - b.from;
  return std::abs(dot(u, v)) < 0.5 * norm(u) * norm(v);
}

}  // namespace

std::vector<FieldPoint> crossings_of(const Markings& markings, const scene_file::FieldSize& field) {
  const std::vector<Segment> lines = lines_of(markings, field);
  std::vector<FieldPoint> points;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = i + 1; k < lines.size(); ++k) {
      Vec3d at;
      if (!is_corner(lines[i], lines[k]) || !meet(lines[i], lines[k], at)) continue;
      const auto same = [&](const FieldPoint& other) { return norm(other.place - at) < same_place; };
      if (std::ranges::any_of(points, same)) continue;
      const int arms = arms_at(at, lines);
      if (arms >= 2) points.push_back({"", arms == 2 ? 'L' : arms == 3 ? 'T' : 'X', at});
    }
  }
  std::ranges::sort(points, [](const FieldPoint& a, const FieldPoint& b) {
    if (std::abs(a.place.x - b.place.x) > same_place) return a.place.x < b.place.x;
    return a.place.y < b.place.y;
  });
  std::array<int, 128> count{};
  for (FieldPoint& point : points) {
    point.name = fmt::format("{}{}", point.kind, ++count[static_cast<std::size_t>(point.kind)]);
  }
  return points;
}

GoalPoints goal_points(const scene_file::FieldSize& field, double side) {
  const double x = side * (0.5 * field.length + 0.5 * field.post_width);
  const double left = side * 0.5 * (field.goal_width + field.post_width);  // y is left of x
  const double top = field.goal_height;
  return {side, {{x, left, 0}, {x, -left, 0}, {x, left, top}, {x, -left, top}}};
}

}  // namespace murosimf::dataset
