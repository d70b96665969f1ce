/// arrangement.h - one picture before it is drawn: places, postures and colors of everything in it, and the camera.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/dataset/stage.h"
#include "murosimf/sensors/camera_model.h"

namespace murosimf::dataset {

struct Arrangement {
  PoseFrame frame;
  std::vector<double>
      reach;  ///< [m] by entity of the world: radius about its base that it takes on the ground, without joint_jitter
  std::vector<std::optional<Color>> colors;  ///< by entity of the world
  bool panels = true;                        ///< of balls
  std::string camera;                        ///< "blue1.camera"; empty: a free one
  sensors::CameraMotion motion;
};

/// Of picture `number`, seen through `lens`. Actors do not overlap, except for those of the scene that stay; an actor that finds no place is
/// left out, and so is a robot without a recorded posture. A robot whose camera looks does not lie.
[[nodiscard]] Arrangement arrange(const Stage& stage, const Randomisation& randomisation, const imaging::Lens& lens,
                                  std::uint64_t seed, std::uint64_t number);

}  // namespace murosimf::dataset
