#include "murosimf/robot/tendon_properties.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/tendon_path.h"

namespace murosimf::robot {

SpatialTendon spatial_tendon_of(const robot_formats::RobotDescription& description,
                                const robot_formats::TendonDescription& tendon,
                                const std::function<std::string(const std::string&)>& object_of) {
  const auto on = [&](std::size_t body, const Transformd& place) {
    return SpatialTendon::Place{object_of(description.bodies[body].name), place};
  };
  SpatialTendon path;
  for (const robot_formats::TendonBranchDescription& branch : tendon.path) {
    auto& parts = path.branches.emplace_back(branch.divisor).parts;
    for (const robot_formats::TendonPartDescription& one : branch.parts) {
      const auto found = robot_formats::find_part(description, one);
      MUROSIMF_ASSERT(found.has_value());
      SpatialTendon::Part part{on(found->body, found->part.place)};
      part.radius = found->part.obstacle.radius;
      part.cylinder = found->part.obstacle.cylinder;
      if (found->side_body >= 0) {
        part.side = on(static_cast<std::size_t>(found->side_body), {found->side, {}});
      }
      parts.push_back(part);
    }
  }
  return path;
}

TendonTie tie_of(const robot_formats::RobotDescription& description, const robot_formats::TendonDescription& tendon) {
  MUROSIMF_ASSERT(tendon.tie.has_value());
  const auto other =
      std::ranges::find(description.tendons, tendon.tie->other, [](const auto& one) { return one.joint.name; });
  const double other_start = other == description.tendons.end() ? 0 : other->joint.reference;
  return {tendon.tie->other, tendon.joint.reference, other_start, tendon.tie->polynomial};
}

}  // namespace murosimf::robot
