#include "murosimf/world/algorithm.h"

#include "murosimf/world/lane_group.h"

namespace murosimf {

std::unique_ptr<LaneGroup> Algorithm::join(std::span<Algorithm* const>) const { return nullptr; }

}  // namespace murosimf
