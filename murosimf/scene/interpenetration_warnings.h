/// interpenetration_warnings.h - entities that have penetrated or passed through others during a run (collision/interpenetration.h).
#pragma once

#include <string>
#include <vector>

#include "murosimf/world/world.h"

namespace murosimf::scene {

/// One line for each pair of entities, ordered by time; a single line for those after the fifth.
[[nodiscard]] std::vector<std::string> interpenetration_warnings(const World& world);

}  // namespace murosimf::scene
