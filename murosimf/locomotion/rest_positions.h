/// rest_positions.h - where joints are held that neither a walk nor a motion moves: arms of a robot whose zero stretches them to the sides.
#pragma once

#include <vector>

#include "murosimf/model/model.h"

namespace murosimf::locomotion {

/// [rad | m] by object: `rest_position`, 0 where the robot's file has none.
[[nodiscard]] std::vector<double> rest_positions(const Model& model);

}  // namespace murosimf::locomotion
