/// unsettled_warning.h - contacts that the step of a scene is too long for (collision/body_pairs.h, UnsettledSteps).
///
/// Gauss-Seidel sweeps carry a heavy load through a light body, or through a tall stack, the slower the longer the step is. There is a
/// warning where in half of the steps of some second sweeps ran out and left velocities to change by 0.1 m/s and more on average, unless the
/// body has gone deep into something (interpenetration_warnings.h), which shorter steps do not mend. The sweeps
/// that a step takes grow about with its length, so the rate that settles them is the present one times the sweeps that were needed over
/// those that there were.
/// Source: measured, two to twelve cubes of 0.1 m, 1 to 1,000 kg on 1 kg, at 0.5 to 10 ms.
#pragma once

#include <string>

#include "murosimf/model/world.h"

namespace murosimf::scene {

/// Empty if contacts settle, or nearly.
[[nodiscard]] std::string unsettled_warning(const World& world);

}  // namespace murosimf::scene
