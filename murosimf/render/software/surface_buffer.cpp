#include "murosimf/render/software/surface_buffer.h"

#include <algorithm>

namespace murosimf::render::software {

void SurfaceBuffer::begin(int width, int height, int first_row, int rows) {
  MUROSIMF_ASSERT(width > 0 && first_row >= 0 && rows > 0 && first_row + rows <= height);
  box_ = {0, width - 1, first_row, first_row + rows - 1};
  stride_ = static_cast<std::size_t>(width + 2 * pixel_lanes);  // groups may reach beyond the end of a row
  const std::size_t size = stride_ * static_cast<std::size_t>(rows);
  if (per_z_.size() < size) per_z_.resize(size);
  numbers_.assign(size, 0);
  surfaces_.resize(1);
}

void SurfaceBuffer::draw(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners, const Surface& as) {
  for_near_parts(rays, corners, [&](const std::array<const SeenCorner*, 3>& part) {
    const PictureTriangle triangle(rays, part, false);
    if (!triangle.is_seen()) return;
    const auto count = static_cast<std::int32_t>(surfaces_.size());
    const Ints number = all_lanes(as.is_measured() ? count : -count);
    bool drawn = false;
    for_covered(triangle.corners, triangle.per_z, triangle.anchor, box_,
                [&](int v, int u, const Ints& inside, const Floats& at) {
                  float* depth = per_z(v) + u;
                  const auto old = load_lanes<Floats>(depth);
                  const Ints nearer = inside & (at > old);
                  if (!any(nearer)) return;
                  store_lanes(choose(nearer, at, old), depth);
                  std::int32_t* shown = numbers(v) + u;
                  store_lanes((nearer & number) | (~nearer & load_lanes<Ints>(shown)), shown);
                  drawn = true;
                });
    if (!drawn) return;
    surfaces_.push_back(as);
    triangle.complete(surfaces_.back());
  });
}

}  // namespace murosimf::render::software
