#include "murosimf/render/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace murosimf::render {
namespace {

constexpr int samples_per_side = 2;  // of a pixel
constexpr double edge_shade = 0.45;  // [1] what is left of the color

std::uint8_t byte_of(double channel) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
}

/// Samples of one row inside the polygon: centers from first to last - 1.
struct Span {
  int first, last;
};
Span span_at(std::span<const Vec3d> polygon, double y, int width) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  if (!(low <= high)) return {0, 0};
  const double right = width;
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, right)),
          static_cast<int>(std::clamp(std::ceil(high - 0.5), 0.0, right))};
}

/// Depth over the picture: z = a x + b y + c.
struct DepthPlane {
  double a, b, c;
};
DepthPlane plane_of(std::span<const Vec3d> polygon) {
  Vec3d normal;  // twice the area: holds where the first corners lie on a line
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  const double a = -normal.x / normal.z, b = -normal.y / normal.z;
  return {a, b, polygon[0].z - a * polygon[0].x - b * polygon[0].y};
}

}  // namespace

DepthImage::DepthImage(int columns, int rows)
    : width_(samples_per_side * columns),
      height_(samples_per_side * rows),
      samples_(static_cast<std::size_t>(width_) * height_) {}

void DepthImage::fill(std::span<const Vec3d> polygon, const Color& color, std::uint32_t part) {
  std::vector<Vec3d> corners;
  double top = std::numeric_limits<double>::infinity(), bottom = -top;
  for (const Vec3d& p : polygon) {
    corners.push_back({samples_per_side * p.x, samples_per_side * p.y, p.z});
    top = std::min(top, corners.back().y);
    bottom = std::max(bottom, corners.back().y);
  }
  const DepthPlane plane = plane_of(corners);
  if (!std::isfinite(plane.a + plane.b + plane.c)) return;  // seen from its edge
  const Sample paint{0, part, byte_of(color.red), byte_of(color.green), byte_of(color.blue)};
  const int first = static_cast<int>(std::clamp(std::ceil(top - 0.5), 0.0, 1.0 * height_));
  const int last = static_cast<int>(std::clamp(std::ceil(bottom - 0.5), 0.0, 1.0 * height_));
  for (int y = first; y < last; ++y) {
    const Span span = span_at(corners, y + 0.5, width_);
    for (int x = span.first; x < span.last; ++x) {
      const auto depth = static_cast<float>(plane.a * (x + 0.5) + plane.b * (y + 0.5) + plane.c);
      Sample& sample = at(x, y);
      if (sample.part != 0 && sample.depth >= depth) continue;
      sample = paint;
      sample.depth = depth;
    }
  }
}

void DepthImage::draw_edges() {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      Sample& sample = at(x, y);
      const bool right = x + 1 < width_ && at(x + 1, y).part != sample.part;
      const bool below = y + 1 < height_ && at(x, y + 1).part != sample.part;
      if (sample.part == 0 || !(right || below)) continue;
      for (std::uint8_t* channel : {&sample.red, &sample.green, &sample.blue}) {
        *channel = static_cast<std::uint8_t>(edge_shade * *channel);
      }
    }
  }
}

std::vector<std::uint32_t> DepthImage::pixels() const {
  constexpr std::uint32_t all = samples_per_side * samples_per_side;
  const int columns = width_ / samples_per_side, rows = height_ / samples_per_side;
  std::vector<std::uint32_t> result;
  result.reserve(static_cast<std::size_t>(columns) * rows);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      std::uint32_t red = 0, green = 0, blue = 0, covered = 0;
      for (std::uint32_t k = 0; k < all; ++k) {
        const int row = samples_per_side * y + static_cast<int>(k) / samples_per_side;
        const int column = samples_per_side * x + static_cast<int>(k) % samples_per_side;
        const Sample& sample = samples_[static_cast<std::size_t>(row) * width_ + column];
        if (sample.part == 0) continue;
        red += sample.red;
        green += sample.green;
        blue += sample.blue;
        ++covered;
      }
      result.push_back(255 * covered / all << 24 | red / all << 16 | green / all << 8 | blue / all);
    }
  }
  return result;
}

}  // namespace murosimf::render
