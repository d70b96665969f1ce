/// field_picture.h - a picture of a match, seen from above: the field, and the paths of robots and ball.
#pragma once

#include <string>
#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"
#include "murosimf/render/overlay.h"

namespace murosimf::render {

/// The path of a robot or a ball.
struct Path {
  std::string name;           ///< without the number at its end it names the team in the legend
  Color color;                ///< of the team, or of the ball
  std::vector<Vec3d> points;  ///< [m] world, oldest first; a point that is not finite leaves a gap
  double size = 0.12;         ///< [m] radius of the symbol at the end: half the breadth of the shoulders
  double heading = 0;         ///< [rad] at the end; 0 looks along x
  bool is_ball = false;
  int number = -1;  ///< on the robot's head; negative: none
};

struct FieldPictureOptions {
  int pixels_per_meter = 160;
  std::string title;  ///< UTF-8, one line
  Overlay overlay{};  ///< over everything else
};

/// A PNG file, as bytes, of 2 half_length by 2 half_width of ground, x to the right and y up. An open stroke that
/// reaches beyond all closed ones is drawn as a goal. Throws SetupError if the picture cannot be drawn, or if this
/// build has no pictures.
[[nodiscard]] std::string field_picture_png(const Markings& markings, const std::vector<Path>& paths,
                                            const FieldPictureOptions& options = {});

}  // namespace murosimf::render
