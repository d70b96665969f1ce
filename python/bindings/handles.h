/// handles.h - entities and robots as Python holds them: a handle of the library, and the state of its scene.
#pragma once

#include <array>
#include <memory>

#include "murosimf/scene.h"
#include "scene_state.h"

namespace murosimf::python {

struct EntityRef {
  std::shared_ptr<SceneState> state;
  EntityHandle handle;
};

struct RobotRef : EntityRef {
  Robot robot;
  RobotRef(std::shared_ptr<SceneState> of, const Robot& found) : EntityRef{std::move(of), found}, robot(found) {}
};

[[nodiscard]] inline Vector3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
[[nodiscard]] inline std::array<double, 3> array_of(const Vector3& v) { return {v.x, v.y, v.z}; }

}  // namespace murosimf::python
