/// chosen_results.h - single numbers that describe the end of a run, chosen by name.
///
///     walker.distance           [m] of its way; also falls, frozen, present, x, y, z of its base
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

/// The results of a run that are shown unless others are chosen: the ways of all entities, and their falls.
[[nodiscard]] const std::vector<std::string>& usual_results();

/// In the order of the patterns. Throws SetupError for a pattern that matches nothing, with the nearest name.
[[nodiscard]] std::vector<ChosenResult> results_of(scene::Scene& scene, const std::vector<std::string>& patterns);

}  // namespace murosimf::studies
