/// projection.h - projection of a picture: through a pinhole (sensors::Perspective), or by parallel rays.
#pragma once

#include <span>

#include "murosimf/sensors/view_source.h"

namespace murosimf::render {

/// Parallel rays: the size of an object does not depend on its distance, and nothing is too near to be visible. The middle of the
/// picture shows `center`; depths count from there and are negative nearer to the eye.
struct ParallelView {
  Vec3d center{};             ///< [m] world
  Mat3d axes{};               ///< optical axes (right, down, away from the eye) to world axes
  double pixel = 0.01;        ///< [m] side of a pixel, more than 0
  int width = 0, height = 0;  ///< [px]
};

/// Optical axes of an eye in the direction `azimuth` [rad, counterclockwise from x] at `elevation` [rad] above the ground.
/// (-pi/2, 0) looks along y, with x to the right; (-pi/2, pi/2) from above with x to the right.
[[nodiscard]] Mat3d axes_from(double azimuth, double elevation);

/// The view in which the points [m, world] fill the picture but for a margin of 6 % on each side.
[[nodiscard]] ParallelView view_of(std::span<const Vec3d> points, const Mat3d& axes, int width, int height);

/// Sine of the lowest elevation from which parallel rays see the ground; from below it, they see it cut open.
inline constexpr double level_sine = 0.01;

/// Either kind. A point at (x, y, z) in the optical axes of `window` is seen at x / z and y / z, by parallel rays at x and
/// y; the borders of the window are counted in these.
struct Projection {
  Projection(const sensors::Perspective& view) : window(view) {}
  Projection(const ParallelView& view);

  sensors::Perspective window;
  bool parallel = false;
};

}  // namespace murosimf::render
