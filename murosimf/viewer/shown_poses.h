/// shown_poses.h - where everything is at the moment that is shown: the last frame of poses that has come.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "murosimf/session/session.h"
#include "murosimf/viewer/scene_outline.h"

namespace murosimf::viewer {

class ShownPoses {
 public:
  ShownPoses() = default;
  explicit ShownPoses(PoseFeed& feed);

  /// Takes over the newest frame. Whether there was a new one.
  bool refresh() noexcept;
  /// Null: none has come yet.
  [[nodiscard]] const PoseFrame* frame() const noexcept { return frame_; }
  /// Frames come at intervals: whether one must be asked for, since a session that stands still stands elsewhere than the last frame. Says so
  /// once for each place.
  [[nodiscard]] bool must_ask(const session::SessionStatus& status) noexcept;

  [[nodiscard]] bool has(int entity) const noexcept;
  /// [m] world, of the base for object 0; nothing if the entity is not there.
  [[nodiscard]] std::optional<Vec3d> place_of(const ObjectPath& path) const noexcept;

 private:
  std::shared_ptr<PoseReader> reader_;
  const PoseFrame* frame_ = nullptr;  // the reader's
  Duration asked_at_ = Duration::min();
};

/// Notices a ball that comes into a goal.
class GoalWatch {
 public:
  /// "goal on the left", once for each time that it is there; nothing: there is none.
  [[nodiscard]] std::optional<std::string> look(const PoseFrame& frame, const SceneOutline& outline);

 private:
  bool in_goal_ = false;
};

}  // namespace murosimf::viewer
