/// sensor_refs.h - sensors and cameras as Python holds them.
#pragma once

#include <memory>
#include <string>

#include "murosimf/sensors.h"
#include "scene_state.h"

namespace murosimf::python {

struct SensorRef {
  std::shared_ptr<SceneState> state;
  Sensor sensor;
  std::string robot;
};

struct CameraRef {
  std::shared_ptr<SceneState> state;
  Camera camera;
};

}  // namespace murosimf::python
