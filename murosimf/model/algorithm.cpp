#include "murosimf/model/algorithm.h"

#include "murosimf/model/lane_group.h"

namespace murosimf {

std::unique_ptr<LaneGroup> Algorithm::join(std::span<Algorithm* const>) const { return nullptr; }

}  // namespace murosimf
