/// scene_ref.h - a scene as Python holds it, and how it is stepped.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "scene_state.h"

namespace murosimf::python {

struct SceneRef {
  std::shared_ptr<SceneState> state;

  SceneRef(Scene scene, bool threads) : state(std::make_shared<SceneState>(std::move(scene), threads)) {}
  explicit SceneRef(std::shared_ptr<SceneState> of) : state(std::move(of)) {}

  // Without the lock of the interpreter, but for signals and controllers. Raise what these raise.
  void step(std::int64_t steps);
  void run(double seconds);
};

}  // namespace murosimf::python
