/// action_view.h - a view that follows some entities smoothly, as a person with a camera would.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/runtime/pose_frame.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::scene {

/// From the side of the scene's [view], 20 degrees up, as near as lets the box of all that is followed be in the picture, with 0.2 m (a ball
/// alone: 0.8 m) about it. The box moves by a low-pass of first order, so that steps and falls do not shake the picture.
class ActionView {
 public:
  /// The scene must be initialized and outlive it.
  explicit ActionView(Scene& scene) : scene_(scene) {}

  /// Follows these entities from the next picture on; the ball is among them where it is less than 1.5 m from the first one. `at_once`: without
  /// a pan. Throws SetupError with the nearest name if there is no such entity.
  void follow(const std::vector<std::string>& names, bool at_once);
  /// The picture of the present instant. Present entities only; without any, the whole field.
  [[nodiscard]] sensors::Perspective look(int width, int height);

 private:
  struct Box {
    Vec3d low, high;  // [m]
  };
  void add_ball();
  void take_poses();
  [[nodiscard]] std::span<const Vec3d> places_of(const Entity& entity) const;
  [[nodiscard]] std::optional<Box> box_now();

  Scene& scene_;
  std::vector<const Entity*> followed_;
  PoseFrame poses_;
  std::optional<Box> box_;
  Duration seen_{};
};

}  // namespace murosimf::scene
