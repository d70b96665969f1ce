#include "murosimf/soccer/line_distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::soccer {
namespace {

double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) noexcept {
  const Vec3d ab = b - a;
  const double length_squared = dot(ab, ab);
  const double t = length_squared > 0 ? std::clamp(dot(p - a, ab) / length_squared, 0.0, 1.0) : 0;
  return norm(Vec3d(p - (a + t * ab)));
}

}  // namespace

double distance_to_lines(const Markings& markings, double x, double y) noexcept {
  /// Distance to the nearest segment of a stroke: curves are polylines.
  double nearest = std::numeric_limits<double>::infinity();
  for (const Stroke& stroke : markings.strokes) {
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      nearest = std::min(nearest, distance_to_segment({x, y, 0}, stroke.points[i - 1], stroke.points[i]));
    }
  }
  return nearest;
}

LineDistanceField::LineDistanceField(const Markings& markings, double cell)
    /// The grid covers the field with its border, with both edges as cells.
    : cell_(cell),
      half_length_(markings.half_length),
      half_width_(markings.half_width),
      columns_(static_cast<int>(std::ceil(2 * half_length_ / cell)) + 1),
      rows_(static_cast<int>(std::ceil(2 * half_width_ / cell)) + 1) {
  MUROSIMF_ASSERT(cell > 0);
  if (!std::isfinite(distance_to_lines(markings, 0, 0))) throw SetupError("the field has no lines to look for");
  if (static_cast<double>(columns_) * rows_ > 4e6)
    throw SetupError("the table of the field's lines has too many cells");
  distances_.reserve(static_cast<std::size_t>(columns_) * rows_);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const double x = column * cell - half_length_, y = row * cell - half_width_;
      distances_.push_back(static_cast<float>(distance_to_lines(markings, x, y)));
    }
  }
  MUROSIMF_ASSERT(distances_.size() == static_cast<std::size_t>(columns_) * rows_);
}

double LineDistanceField::distance(double x, double y) const noexcept {
  const int column = static_cast<int>(std::clamp((x + half_length_) / cell_ + 0.5, 0.0, columns_ - 1.0));
  const int row = static_cast<int>(std::clamp((y + half_width_) / cell_ + 0.5, 0.0, rows_ - 1.0));
  MUROSIMF_ASSERT(column >= 0 && column < columns_ && row >= 0 && row < rows_);
  return distances_[static_cast<std::size_t>(row) * columns_ + column];
}

}  // namespace murosimf::soccer
