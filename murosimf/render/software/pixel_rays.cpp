#include "murosimf/render/software/pixel_rays.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/light.h"

namespace murosimf::render::software {

PixelRays::PixelRays(const sensors::Perspective& view, const Vec3d& around)
    : whole_{0, view.width - 1, 0, view.height - 1},
      left_(static_cast<float>(view.left)),
      top_(static_cast<float>(view.top)),
      pixel_x_(static_cast<float>((view.right - view.left) / view.width)),
      pixel_y_(static_cast<float>((view.bottom - view.top) / view.height)),
      per_pixel_x_(static_cast<float>(view.width / (view.right - view.left))),
      per_pixel_y_(static_cast<float>(view.height / (view.bottom - view.top))),
      eye_place_(view.eye),
      axes_(view.axes),
      eye_(floats(view.eye)),
      around_(floats(around)),
      near_ground_(static_cast<float>(norm(Vec3d{std::max(std::abs(view.left), std::abs(view.right)),
                                                 std::max(std::abs(view.top), std::abs(view.bottom)), 1}) /
                                      floor_reach)) {
  MUROSIMF_ASSERT(view.width > 0 && view.height > 0 && view.right > view.left && view.bottom > view.top);
  const double du = (view.right - view.left) / view.width, dv = (view.bottom - view.top) / view.height;
  const Vec3d per_u = du * view.axes.x, per_v = dv * view.axes.y;
  const Vec3d first = (view.left + 0.5 * du) * view.axes.x + (view.top + 0.5 * dv) * view.axes.y + view.axes.z;
  way_x_ = {first.x, per_u.x, per_v.x};
  way_y_ = {first.y, per_u.y, per_v.y};
  way_z_ = {first.z, per_u.z, per_v.z};
  if (view.eye.z > 0) ground_ = {-first.z / view.eye.z, -per_u.z / view.eye.z, -per_v.z / view.eye.z};
}

/// n . p = n . a for all its points p, with p = z (x, y, 1): 1 / z = n . (x, y, 1) / n . a.
Slope PixelRays::plane(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Anchor& anchor) const {
  const Vec3d normal = cross(b - a, c - a);
  const double per_away = 1 / dot(normal, a), x = double{pixel_x_} * normal.x * per_away,
               y = double{pixel_y_} * normal.y * per_away;
  const double tangent_x = double{left_} + (double{anchor.u} + 0.5) * double{pixel_x_};
  const double tangent_y = double{top_} + (double{anchor.v} + 0.5) * double{pixel_y_};
  return {static_cast<float>(dot(normal, Vec3d{tangent_x, tangent_y, 1}) * per_away), static_cast<float>(x),
          static_cast<float>(y)};
}

}  // namespace murosimf::render::software
