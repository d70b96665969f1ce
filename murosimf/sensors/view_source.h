/// view_source.h - source of pictures of the scene: render/ implements it, cameras use it.
///
/// Optical axes: x to the right, y down, z forward (ROS REP-103, "optical" frames).
#pragma once

#include "murosimf/imaging/image.h"
#include "murosimf/math/mat3.h"
#include "murosimf/world/setup.h"

namespace murosimf::sensors {

/// A pinhole and the part of its picture plane that is drawn. A point at (x, y, z) in its optical axes is seen at the
/// tangents x / z and y / z; the middle of the pixel (u, v) is at left + (u + 1/2) (right - left) / width, and
/// likewise downwards.
struct Perspective {
  Vec3d eye;                                          ///< [m] world
  Mat3d axes;                                         ///< optical axes to world axes
  double left = -1, right = 1, top = -1, bottom = 1;  ///< [1] tangents at the borders
  int width = 0, height = 0;                          ///< [px]
  int first_row = 0, rows = 0;                        ///< only these are drawn (rolling shutter); 0 rows: all
  const Entity* without = nullptr;                    ///< is not drawn
  bool finest = false;                                ///< finest tessellation of round shapes: for measurements
};

/// What is to be drawn.
struct Layers {
  bool color = true, depth = false, labels = false;
};

/// What was drawn; layers that were not wanted stay as they were.
struct View {
  imaging::ColorImage color;
  imaging::DepthImage depth;
  imaging::LabelImage labels;
};

/// The first labels; moving entities follow, in the order of SensorSurroundings::moving_entities.
enum Label : std::uint16_t {
  label_background = 0,
  label_ground = 1,
  label_line = 2,
  label_goal = 3,
  label_moving_entity = 4
};

class ViewSource {
 public:
  virtual ~ViewSource() = default;

  /// Draws the scene as it is at this instant, moved on by `ahead` [s] with the present velocities. A caller that draws while the
  /// simulation runs reads pose and velocity of all moving entities. Images get the size of the perspective. May be called from several threads at once; the pixels do not depend on the thread.
  virtual void draw(const Perspective& perspective, const Layers& layers, double ahead, View& view) noexcept = 0;
};

}  // namespace murosimf::sensors
