/// scan.h - a fan of rays in a plane, all cast at once: the scan of a laser range finder.
///
///     const Fan fan(1081, -0.75 * pi, 1.5 * pi);
///     std::vector<double> distances(fan.size());
///     scene.cast(fan, {position, orientation}, {.range = 30, .without = &robot}, distances);
///
/// Each distance is exactly what QueryScene::cast finds for that ray alone; all together cost much less. The tree of an
/// entity is walked once for the whole fan: a volume counts if the fan's plane cuts it, and a shape is tried only by
/// the rays that can meet the sphere around its volume. In the plane this sphere is a disc; a disc of radius rho with
/// its middle d from the fan's apex is met by rays within asin(rho / d) of its bearing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "murosimf/geometry/ray.h"
#include "murosimf/geometry/volume.h"

namespace murosimf::collision {

/// Rays from the origin of a frame in its x-y plane.
class Fan {
 public:
  /// `rays` from the angle `first` [rad] on, from x towards y, evenly over `fov` [rad], both ends included. There
  /// must be at least one ray, and the fov must be from 0 to 2 pi.
  Fan(int rays, double first, double fov);

  [[nodiscard]] std::size_t size() const { return directions_.size(); }
  /// Of ray i [1], unit, in the fan's frame.
  [[nodiscard]] const Vec3d& direction(std::size_t i) const { return directions_[i]; }
  /// Ray i of the fan whose frame is `at`.
  [[nodiscard]] geometry::Ray ray(std::size_t i, const Transformd& at) const {
    return {at.position, at.orientation * directions_[i]};
  }
  /// Calls visit(i) for each ray that may meet a sphere of the fan's frame, once.
  template <class Visit>
  void for_rays_towards(const geometry::BoundingSphere& sphere, const Visit& visit) const;

 private:
  /// Angles [rad] around `middle`, which is from 0 to 2 pi, from the first ray on.
  struct Sector {
    double middle = 0, half = pi;
  };
  [[nodiscard]] Sector sector(const geometry::BoundingSphere& sphere) const;

  double first_, step_;  // [rad]
  std::vector<Vec3d> directions_;
};

// ---- definitions ----

template <class Visit>
void Fan::for_rays_towards(const geometry::BoundingSphere& sphere, const Visit& visit) const {
  const auto count = static_cast<double>(size());
  const auto [middle, half] = sector(sphere);
  const bool all = half >= pi || step_ == 0;
  // the sector, and the same one turn before and after
  for (double turn = all ? 0 : -2 * pi; turn <= (all ? 0 : 2 * pi); turn += 2 * pi) {
    const double low = all ? 0 : std::clamp(std::ceil((middle - half + turn) / step_), 0.0, count);
    const double high = all ? count : std::clamp(std::floor((middle + half + turn) / step_) + 1, 0.0, count);
    for (auto i = static_cast<std::size_t>(low); i < static_cast<std::size_t>(high); ++i) visit(i);
  }
}

}  // namespace murosimf::collision
