/// orbit_camera.h - a camera that the mouse moves around a place: it turns about it, zooms, moves aside.
///
/// Pixels count from the top left corner of the picture, and the middle of the first one is at 0.5.
#pragma once

#include <optional>

#include "murosimf/sensors/view_source.h"

namespace murosimf::viewer {

/// A point of the picture [px], from its top left corner.
struct Pixel {
  double x = 0, y = 0;
};

/// The line of sight of a pixel.
struct Ray {
  Vec3d from;       ///< [m] world
  Vec3d direction;  ///< [1] unit, world
};

/// Looks from `eye` to `at` [m, world] with `fov` [rad] from the left to the right border; up is up.
[[nodiscard]] sensors::Perspective look(const Vec3d& eye, const Vec3d& at, double fov, int width, int height);

/// Pixel of a place [m, world]; nothing if it is behind the eye.
[[nodiscard]] std::optional<Pixel> pixel_of(const sensors::Perspective& view, const Vec3d& place);
[[nodiscard]] Ray ray_of(const sensors::Perspective& view, const Pixel& pixel);
/// Intersection of a pixel's ray with the plane through `place` normal to `normal`; nothing if there is none in front of the eye.
[[nodiscard]] std::optional<Vec3d> on_plane(const sensors::Perspective& view, const Pixel& pixel, const Vec3d& place,
                                            const Vec3d& normal);

struct OrbitCamera {
  Vec3d target{0, 0, 0.2};  ///< [m] world, in the middle of the picture
  double azimuth = -1.3;    ///< [rad] of the eye from there, counterclockwise from x
  double elevation = 0.45;  ///< [rad] of the eye above the horizon
  double distance = 6;      ///< [m]
  double fov = 0.7;         ///< [rad] from the left to the right border

  /// Approximates another view: about the place that it sees on the ground, or `distance` [m] in front of it.
  void take_over(const sensors::Perspective& view);

  // Drags of the mouse by a number of pixels of a picture that is `height` [px] high.
  void orbit(double right, double down, int height);
  void pan(double right, double down, int height);
  /// Moves nearer for positive clicks of a wheel.
  void zoom(double clicks);
  /// Moves [m] along its own horizontal axes: forward, to the left, upwards.
  void fly(double forward, double left, double up);

  [[nodiscard]] sensors::Perspective view(int width, int height) const;
  [[nodiscard]] Vec3d eye() const;
};

}  // namespace murosimf::viewer
