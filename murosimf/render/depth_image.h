/// depth_image.h - polygons that hide each other: a picture with a depth for every sample, four samples to a pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

class DepthImage {
 public:
  DepthImage(int columns, int rows);

  /// A flat convex polygon: x, y [pixels], z the nearer the greater. `part`: from 1, of the thing that it belongs to;
  /// lines are drawn where one part ends and another begins.
  void fill(std::span<const Vec3d> polygon, const Color& color, std::uint32_t part);
  /// Darkens the samples at the edges of parts. To be called last.
  void draw_edges();
  /// Red, green, blue, times coverage, and coverage: 32 bits a pixel as cairo's ARGB32 has them.
  [[nodiscard]] std::vector<std::uint32_t> pixels() const;

 private:
  struct Sample {
    float depth = 0;
    std::uint32_t part = 0;  // 0: nothing
    std::uint8_t red = 0, green = 0, blue = 0;
  };
  [[nodiscard]] Sample& at(int x, int y) { return samples_[static_cast<std::size_t>(y) * width_ + x]; }

  int width_, height_;  // [samples]
  std::vector<Sample> samples_;
};

}  // namespace murosimf::render
