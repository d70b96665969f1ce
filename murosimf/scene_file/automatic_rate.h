/// automatic_rate.h - the rate that `rate = "auto"` selects: the longest steps with accurate results.
///
/// The effect of each step length on walks, kicks and pushes at each level and under each law is measured by
/// benchmarks/step_sizes.py (docs/scenes.md, "Long steps"); the laws in the catalog have the resulting limits. In addition
///
///     v dt <= r / 5                      for a ball or sphere of radius r with the initial velocity v: the penetration depth into a post or a limb
///                                        turns the normal, and so the direction after the bounce
///     dt^2 k / m_p <= 0.02               for a given stiffness k of a pair of materials, under an explicit law (contact_parameters.h)
///
/// but with steps of at least 0.5 ms for the first, 0.1 ms for the second.
#pragma once

#include <string>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

struct AutomaticRate {
  double hz = 0;
  std::string because;  ///< the entity that limits the step: "walker at full_dynamics under paper"
};

/// Longest step [s] that is stable under the law with the given stiffness of the pair of `material` and the ground, for a body of `mass` [kg]
/// that is not round; infinite for implicit laws and pairs with a stiffness that follows from the weight.
[[nodiscard]] double longest_stiff_step(const SceneSpec& scene, const std::string& contact, const std::string& material,
                                        double mass);

/// For all levels and laws that the scene and its events name. Throws SetupError for a law that is not in the catalog.
[[nodiscard]] AutomaticRate automatic_rate(const SceneSpec& scene);

}  // namespace murosimf::scene_file
