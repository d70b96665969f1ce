/// ground_projection.h - maps a pixel to the place on the ground that it shows, and back.
///
/// The frame is the robot's own on the ground: its origin below the origin of the base, x where the base looks, y left,
/// z up; the ground is its plane z = 0. With e the camera, A its optical axes and d the ray of a pixel in them,
///
///     p = e - (e_z / (A d)_z) A d          if the ray goes down
#pragma once

#include <optional>

#include "murosimf/imaging/lens.h"
#include "murosimf/math/mat3.h"

namespace murosimf::soccer {

/// Pose of a camera.
struct CameraPose {
  Vec3d eye;   ///< [m] the pinhole
  Mat3d axes;  ///< optical axes (x right, y down, z forward) to those of the robot on the ground
};

/// [m] Nothing if the pixel shows the horizon or above, or is beyond the lens.
[[nodiscard]] inline std::optional<Vec3d> on_ground(const imaging::Lens& lens, const CameraPose& pose,
                                                    const imaging::Pixel& pixel) noexcept {
  constexpr double flattest = 1e-3;  // [1] slope of a ray that meets the ground a kilometer away or nowhere
  const auto ray = lens.ray(pixel);
  if (!ray) return std::nullopt;
  const Vec3d d = pose.axes * *ray;
  if (d.z > -flattest) return std::nullopt;
  const double along = -pose.eye.z / d.z;
  return Vec3d{pose.eye.x + along * d.x, pose.eye.y + along * d.y, 0};
}

/// `point` [m] in the robot's frame. Nothing if the lens cannot see it; the pixel may be outside of the picture.
[[nodiscard]] inline std::optional<imaging::Pixel> in_picture(const imaging::Lens& lens, const CameraPose& pose,
                                                              const Vec3d& point) noexcept {
  return lens.project(transposed_times(pose.axes, point - pose.eye));
}

}  // namespace murosimf::soccer
