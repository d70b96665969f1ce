/// chosen_results.h - single numbers that say how a run has ended, chosen by name.
///
///     walker.distance           [m] that it has gone; also falls, frozen, present, x, y, z of its base
///     robot.imu.gyroscope.x     the last sample of a sensor, or a property: as --log names them
///     *.falls                   * and ? match within a part
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene/scene.h"

namespace murosimf::studies {

struct ChosenResult {
  std::string name;  ///< with unit: "walker.distance [m]"
  double value = 0;  ///< NaN: it is not there any more
};

/// What is shown of a run if nobody chooses: how far everybody has come, and falls.
[[nodiscard]] const std::vector<std::string>& usual_results();

/// In the order of the patterns. Throws SetupError for a pattern that means nothing, with the nearest name.
[[nodiscard]] std::vector<ChosenResult> results_of(scene::Scene& scene, const std::vector<std::string>& patterns);

}  // namespace murosimf::studies
