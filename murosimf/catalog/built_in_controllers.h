/// built_in_controllers.h - the controllers of the library, by name, with functions that attach them to a robot.
#pragma once

#include <vector>

#include "murosimf/catalog/algorithm_catalog.h"

namespace murosimf::catalog {

[[nodiscard]] std::vector<ControllerType> built_in_controllers();

}  // namespace murosimf::catalog
