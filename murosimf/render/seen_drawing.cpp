#include "murosimf/render/seen_drawing.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::render {
namespace {

constexpr double nearest = 0.02;  // [m] in front of the eye, where things are cut
constexpr int corners_of_circle = 48, corners_of_disc = 24;
constexpr double least_width = 1.5, least_dot = 2, least_letters = 11, most_letters = 72;  // [px]
constexpr double usual_width = 2;                                                          // [px]

/// Projects one shape for an eye.
class Eye {
 public:
  Eye(const DrawnShape& shape, const Transformd& frame, const sensors::Perspective& view, std::vector<SeenShape>& into)
      : shape_(shape), frame_(frame), view_(view), into_(into) {}

  void project() {
    if (shape_.points.empty()) return;
    switch (shape_.kind) {
      case DrawnShape::circle: return circle();
      case DrawnShape::line: return strip(in_eye(shape_.points), shape_.size);
      case DrawnShape::dots:
        for (const Vec3d& point : in_eye(shape_.points)) disc(point, 0.5 * shape_.size, 1);
        return;
      case DrawnShape::sphere: return sphere(in_eye(shape_.points)[0]);
      case DrawnShape::polygon: return area(in_eye(shape_.points));
      case DrawnShape::text: return words(in_eye(shape_.points)[0]);
    }
  }

 private:
  /// Positions in optical axes: z away from the eye.
  [[nodiscard]] std::vector<Vec3d> in_eye(std::span<const Vec3d> points) const {
    std::vector<Vec3d> seen;
    seen.reserve(points.size());
    for (const Vec3d& p : points) {
      seen.push_back(transposed_times(view_.axes, frame_.position + frame_.orientation * p - view_.eye));
    }
    return seen;
  }
  [[nodiscard]] Vec3d pixel(const Vec3d& seen) const {
    MUROSIMF_ASSERT(view_.right > view_.left && view_.bottom > view_.top);
    return {(seen.x / seen.z - view_.left) / (view_.right - view_.left) * view_.width,
            (seen.y / seen.z - view_.top) / (view_.bottom - view_.top) * view_.height, 0};
  }
  /// [px] Size of a length across the line of sight.
  [[nodiscard]] double pixels(double length, double depth) const {
    return length / std::max(depth, nearest) * view_.width / (view_.right - view_.left);
  }
  SeenShape& add(SeenShape::Kind kind, double opacity) {
    return into_.emplace_back(
        SeenShape{.kind = kind, .points = {}, .color = shape_.color, .opacity = opacity * shape_.opacity, .words = {}});
  }

  /// Adds straight pieces, each with its projected width.
  void strip(const std::vector<Vec3d>& points, double width) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      Vec3d a = points[i], b = points[i + 1];
      if (a.z < nearest && b.z < nearest) continue;
      // Cut at the plane in front of the eye: a projection of points behind it is meaningless.
      if (a.z < nearest) a = b + ((b.z - nearest) / (b.z - a.z)) * (a - b);
      if (b.z < nearest) b = a + ((a.z - nearest) / (a.z - b.z)) * (b - a);
      SeenShape& line = add(SeenShape::Kind::line, 1);
      line.points = {pixel(a), pixel(b)};
      line.size = width > 0 ? std::max(least_width, pixels(width, 0.5 * (a.z + b.z))) : usual_width;
    }
  }

  void circle() {
    std::vector<Vec3d> ring;
    for (int i = 0; i <= corners_of_circle; ++i) {
      const double angle = 2 * pi * i / corners_of_circle;
      ring.push_back(shape_.points[0] + shape_.size * Vec3d{std::cos(angle), std::sin(angle), 0});
    }
    strip(in_eye(ring), 0);
  }

  void disc(const Vec3d& middle, double radius, double opacity) {
    if (middle.z < nearest) return;
    const double size = std::max(least_dot, pixels(radius, middle.z));
    const Vec3d at = pixel(middle);
    SeenShape& seen = add(SeenShape::Kind::area, opacity);
    for (int i = 0; i < corners_of_disc; ++i) {
      const double angle = 2 * pi * i / corners_of_disc;
      seen.points.push_back(at + size * Vec3d{std::cos(angle), std::sin(angle), 0});
    }
  }

  /// Adds the outline of a sphere, filled transparently.
  void sphere(const Vec3d& middle) {
    disc(middle, shape_.size, 0.45);
    if (middle.z < nearest) return;
    SeenShape& edge = add(SeenShape::Kind::line, 1);
    MUROSIMF_ASSERT(into_.size() >= 2);
    edge.points = into_[into_.size() - 2].points;
    edge.points.push_back(edge.points.front());
    edge.size = usual_width;
  }

  /// Adds the part of a polygon in front of the eye (Sutherland and Hodgman, at one plane).
  void area(const std::vector<Vec3d>& corners) {
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (a.z >= nearest) kept.push_back(pixel(a));
      if ((a.z >= nearest) != (b.z >= nearest)) kept.push_back(pixel(a + ((nearest - a.z) / (b.z - a.z)) * (b - a)));
    }
    if (kept.size() < 3) return;
    add(SeenShape::Kind::area, 1).points = std::move(kept);
  }

  void words(const Vec3d& middle) {
    if (middle.z < nearest || shape_.words.empty()) return;
    SeenShape& seen = add(SeenShape::Kind::words, 1);
    seen.points = {pixel(middle)};
    seen.size = std::clamp(pixels(shape_.size, middle.z), least_letters, most_letters);
    seen.words = shape_.words;
  }

  const DrawnShape& shape_;
  const Transformd& frame_;
  const sensors::Perspective& view_;
  std::vector<SeenShape>& into_;
};

}  // namespace

void see(const DrawnShape& shape, const Transformd& frame, const sensors::Perspective& view,
         std::vector<SeenShape>& into) {
  Eye(shape, frame, view, into).project();
}

}  // namespace murosimf::render
