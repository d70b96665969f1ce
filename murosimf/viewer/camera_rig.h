/// camera_rig.h - the viewpoint of the viewer: moved by the mouse, following the selection, through a robot's camera, or as on television.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "murosimf/runtime/pose_frame.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/viewer/orbit_camera.h"

namespace murosimf::viewer {

/// The displayed instant.
struct RigView {
  const PoseFrame* frame = nullptr;
  int selected = -1, ball = -1;                 ///< entities; -1: none
  const sensors::CameraInfo* camera = nullptr;  ///< of the selected entity; null: it has none
  const Entity* carrier = nullptr;              ///< the robot with that camera: it does not see itself
  double half_length = 3, half_width = 2;       ///< [m] of the field
};

class CameraRig {
 public:
  enum class Mode { free, robot, tv };

  OrbitCamera orbit;
  bool follows = false;  ///< the free view moves with the selected entity

  /// Number of the one of `count` named viewpoints that comes next.
  [[nodiscard]] std::size_t next_viewpoint(std::size_t count) { return viewpoint_ = (viewpoint_ + 1) % count; }

  [[nodiscard]] Mode mode() const { return mode_; }
  void set_mode(Mode mode) { mode_ = mode; }

  /// Advances by `wall` [s]; moves follow the displayed entities.
  void advance(const RigView& scene, double wall);
  [[nodiscard]] sensors::Perspective view(const RigView& scene, int width, int height) const;

 private:
  [[nodiscard]] sensors::Perspective through_camera(const RigView& scene, int width, int height) const;

  Mode mode_ = Mode::free;
  std::size_t viewpoint_ = 0;
  int followed_ = -1;
  Vec3d last_;                      // [m] last place of the followed entity
  std::optional<Vec3d> attention_;  // [m] point that the television view looks at
};

/// Limit of straight pictures to each side [rad]; real lenses may see more.
inline constexpr double widest_half_view = 1.05;

/// The picture of a camera on `link` as a pinhole takes it: without distortion, blur and noise.
[[nodiscard]] sensors::Perspective pinhole_view(const sensors::CameraInfo& camera, const Vec3d& r, const Mat3d& R,
                                                int width, int height);

}  // namespace murosimf::viewer
