/// automatic_rate.h - what `rate = "auto"` comes to: the longest steps that change little of what comes out.
///
/// How much steps of each length change walks, kicks and pushes at each level and under each law is measured by
/// benchmarks/step_sizes.py (docs/scenes.md, "Long steps"); the laws in the catalog have what follows from it.
#pragma once

#include <string>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

struct AutomaticRate {
  double hz = 0;
  std::string because;  ///< who does not allow longer steps: "walker at full_dynamics under paper"
};

/// For all levels and laws that the scene and its events name. Throws SetupError for a law that the catalog has not.
[[nodiscard]] AutomaticRate automatic_rate(const SceneSpec& scene);

}  // namespace murosimf::scene_file
