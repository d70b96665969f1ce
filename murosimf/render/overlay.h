/// overlay.h - estimates of control software, drawn over the picture of a field: arrows, circles, lines.
#pragma once

#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

/// All lengths in meters on the field; each kind is drawn in the order of its list.
struct OverlayCircle {
  Vec3d center;
  double radius = 0.1;
  Color color;
  bool filled = false;
};
struct OverlayLine {
  std::vector<Vec3d> points;
  Color color;
  bool arrow = false;  ///< with a head at its end
  double width = 0.03;
};
/// A pose: its tail at (x, y), pointing along the heading z [rad].
struct OverlayArrow {
  Vec3d pose;
  double length = 0.3;
  Color color;
};

struct Overlay {
  std::vector<OverlayCircle> circles{};
  std::vector<OverlayLine> lines{};
  std::vector<OverlayArrow> arrows{};
};

}  // namespace murosimf::render
