/// unsettled_warning.h - contacts for which the step of a scene is too long (collision/body_pairs.h, UnsettledSteps).
///
/// Gauss-Seidel sweeps propagate a heavy load through a light body, or through a tall stack, the more slowly the longer the step is. There is a
/// warning if in half of the steps of some second the sweeps were exhausted with residual velocities of 0.1 m/s and more on average, unless the
/// body has penetrated deeply (interpenetration_warnings.h), which shorter steps do not cure. The number of sweeps
/// required in a step grows about with its length, so the rate that settles them is the present one times the ratio of required
/// to available sweeps.
/// Source: measured, two to twelve cubes of 0.1 m, 1 to 1,000 kg on 1 kg, at 0.5 to 10 ms.
#pragma once

#include <string>

#include "murosimf/world/world.h"

namespace murosimf::scene {

/// Empty if contacts settle, or nearly so.
[[nodiscard]] std::string unsettled_warning(const World& world);

}  // namespace murosimf::scene
