/// vision_rig.h - a camera above a painted field, drawn by the definition: every pixel shows the point that its ray meets.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/imaging/image.h"
#include "murosimf/soccer/ground_projection.h"
#include "murosimf/soccer/line_distance_field.h"

namespace murosimf::test {

inline constexpr imaging::Rgb grass{60, 150, 75}, white{235, 235, 230}, sky{180, 190, 200};

inline imaging::Lens plain_lens() {
  return imaging::Lens(
      {.model = "perspective", .width = 320, .height = 240, .fx = 175, .fy = 175, .cx = 159.5, .cy = 119.5});
}

/// `height` [m] above the ground, looking along x and down by `pitch` [rad].
inline soccer::CameraPose looking_down(double height, double pitch) {
  const Mat3d forward{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};
  return {{0, 0, height}, rotation_y(pitch) * forward};
}

/// The picture of a robot at `pose` [m, m, rad] on the field.
inline imaging::ColorImage picture_of(const Markings& field, const imaging::Lens& lens,
                                      const soccer::CameraPose& camera, const Vec3d& pose) {
  imaging::ColorImage picture(lens.spec().width, lens.spec().height, sky);
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const auto place = soccer::on_ground(lens, camera, {static_cast<double>(u), static_cast<double>(v)});
      if (!place) continue;
      const double c = std::cos(pose.z), s = std::sin(pose.z);
      const double x = pose.x + c * place->x - s * place->y, y = pose.y + s * place->x + c * place->y;
      picture(u, v) = soccer::distance_to_lines(field, x, y) < 0.025 ? white : grass;
    }
  }
  return picture;
}

}  // namespace murosimf::test
