/// automatic_rate.h - what `rate = "auto"` comes to: the longest steps that change little of what comes out.
///
/// How much steps of each length change walks, kicks and pushes at each level and under each law is measured by
/// benchmarks/step_sizes.py (docs/scenes.md, "Long steps"); the laws in the catalog have what follows from it. Besides
///
///     v dt <= r / 5                      a ball or sphere of radius r that begins with the velocity v: what it has come into a post or a limb by
///                                        turns the normal, and so the way that it leaves
///     dt^2 k / m_p <= 0.02               a stiffness k that a pair of materials was given, under a law that is explicit (contact_parameters.h)
///
/// though no steps shorter than 0.5 ms for the one, 0.1 ms for the other.
#pragma once

#include <string>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

struct AutomaticRate {
  double hz = 0;
  std::string because;  ///< who does not allow longer steps: "walker at full_dynamics under paper"
};

/// Longest step [s] in which the law bears the stiffness that the pair of `material` and the ground was given, on a body of `mass` [kg]
/// that is not round; infinite for implicit laws and pairs whose stiffness goes by the weight.
[[nodiscard]] double longest_stiff_step(const SceneSpec& scene, const std::string& contact, const std::string& material,
                                        double mass);

/// For all levels and laws that the scene and its events name. Throws SetupError for a law that the catalog has not.
[[nodiscard]] AutomaticRate automatic_rate(const SceneSpec& scene);

}  // namespace murosimf::scene_file
