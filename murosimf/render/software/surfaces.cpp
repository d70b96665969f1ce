#include "murosimf/render/software/surfaces.h"

#include <algorithm>

namespace murosimf::render::software {

void SurfaceBuffer::begin(int width, int height, int first_row, int rows) {
  MUROSIMF_ASSERT(width > 0 && first_row >= 0 && rows > 0 && first_row + rows <= height);
  box_ = {0, width - 1, first_row, first_row + rows - 1};
  stride_ = static_cast<std::size_t>(width + 2 * pixel_lanes);  // groups may reach beyond the end of a row
  const std::size_t size = stride_ * static_cast<std::size_t>(height);
  if (per_z_.size() != size) {
    per_z_.assign(size, 0);
    numbers_.assign(size, 0);
  }
  const auto first = static_cast<std::ptrdiff_t>(row(first_row)),
             end = static_cast<std::ptrdiff_t>(row(first_row + rows - 1) + stride_);
  std::fill(per_z_.begin() + first, per_z_.begin() + end, 0.0F);
  std::fill(numbers_.begin() + first, numbers_.begin() + end, 0);
  surfaces_.resize(1);
}

void SurfaceBuffer::draw(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners, const Surface& as) {
  for_near_parts(rays, corners, [&](const std::array<const SeenCorner*, 3>& part) {
    const PictureTriangle triangle(rays, box_, part, false);
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

void see(const RenderMesh& mesh, const Instance& instance, bool places, std::vector<SeenCorner>& corners) {
  corners.resize(mesh.corners.size());
  const auto &x = instance.row_x, &y = instance.row_y, &z = instance.row_z;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& p = mesh.corners[i].place;
    const std::array<float, 3> n{mesh.corners[i].normal[0] * instance.normal_scale[0],
                                 mesh.corners[i].normal[1] * instance.normal_scale[1],
                                 mesh.corners[i].normal[2] * instance.normal_scale[2]};
    SeenCorner& corner = corners[i];
    corner.x = x[0] * p[0] + x[1] * p[1] + x[2] * p[2] + x[3];
    corner.y = y[0] * p[0] + y[1] * p[1] + y[2] * p[2] + y[3];
    corner.z = z[0] * p[0] + z[1] * p[1] + z[2] * p[2] + z[3];
    corner.normal = {x[0] * n[0] + x[1] * n[1] + x[2] * n[2], y[0] * n[0] + y[1] * n[1] + y[2] * n[2],
                     z[0] * n[0] + z[1] * n[1] + z[2] * n[2]};
    if (places) corner.place = p;
  }
}

Float3 linear_color(const std::array<std::uint8_t, 4>& srgb) {
  // a polynomial close to the curve of sRGB, as the shaders have it
  const auto linear = [](std::uint8_t byte) {
    const float c = static_cast<float>(byte) / 255;
    return c * (c * (c * (0.50308F - 0.10041F * c) + 0.56448F) + 0.03285F);
  };
  return {linear(srgb[0]), linear(srgb[1]), linear(srgb[2])};
}

void see(const LookSurface& surface, const PixelRays& rays, std::vector<SeenCorner>& corners) {
  corners.clear();
  for (const LookCorner& corner : surface.corners) {
    const Float3 seen = rays.seen({corner.place[0], corner.place[1], corner.place[2]});
    corners.push_back({seen.x, seen.y, seen.z, {}, {corner.at[0], corner.at[1], 0}});
    corners.back().project(rays);
  }
}

NearCut::NearCut(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners) {
  std::array<const SeenCorner*, 4> kept{};
  std::size_t size = 0, made_count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const SeenCorner &a = *corners[i], &b = *corners[(i + 1) % 3];
    if (a.z >= nearest_z) kept[size++] = &a;
    if ((a.z >= nearest_z) == (b.z >= nearest_z)) continue;
    const float t = (nearest_z - a.z) / (b.z - a.z);
    SeenCorner& cut = made[made_count++];
    cut = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), nearest_z, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      cut.normal[k] = a.normal[k] + t * (b.normal[k] - a.normal[k]);
      cut.place[k] = a.place[k] + t * (b.place[k] - a.place[k]);
    }
    cut.project(rays);
    kept[size++] = &cut;
  }
  for (std::size_t i = 2; i < size; ++i) parts[static_cast<std::size_t>(count++)] = {kept[0], kept[i - 1], kept[i]};
}

}  // namespace murosimf::render::software
