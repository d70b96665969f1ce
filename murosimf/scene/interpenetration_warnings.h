/// interpenetration_warnings.h - who has gone deep into somebody or through somebody while a scene ran (collision/interpenetration.h).
#pragma once

#include <string>
#include <vector>

#include "murosimf/model/world.h"

namespace murosimf::scene {

/// One line for each pair of entities, in the order of time; those after the fifth in one line.
[[nodiscard]] std::vector<std::string> interpenetration_warnings(const World& world);

}  // namespace murosimf::scene
