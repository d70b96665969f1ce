/// movable_joints.h - joints of an entity that people can move, and where they are.
#pragma once

#include <string>
#include <vector>

#include "murosimf/viewer/scene_outline.h"
#include "murosimf/viewer/shown_poses.h"

namespace murosimf::viewer {

/// A joint that people can move.
struct MovableJoint {
  ObjectPath path;
  std::string name;
  double lowest = 0, highest = 0, position = 0;  ///< [rad | m]
};

/// In the order of the model.
[[nodiscard]] std::vector<MovableJoint> movable_joints(const SceneOutline& outline, const ShownPoses& poses,
                                                       int entity);

}  // namespace murosimf::viewer
