#include "murosimf/scene/frame_completion.h"

#include <span>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/world/world.h"

namespace murosimf::scene {

void work_out_poses(const World& world, PoseFrame& frame) {
  MUROSIMF_ASSERT(frame.first.size() > world.entities().size());
  for (std::size_t i = 0; i < world.entities().size(); ++i) {
    const Entity& entity = *world.entities()[i];
    const Column<Quaterniond>* base = entity.find(properties::base_quaternion);
    if (!base) continue;  // static
    const std::size_t first = frame.first[i], size = frame.first[i + 1] - first;
    MUROSIMF_ASSERT(size > 0 && first + size <= frame.position.size() && first + size <= frame.joint_position.size());
    const auto r = std::span(frame.position).subspan(first, size);
    const auto R = std::span(frame.orientation).subspan(first, size);
    R[0] = to_matrix(base->values[0]);
    multibody::poses<double>(entity.model().tree(), std::span(frame.joint_position).subspan(first, size), r, R);
  }
}

}  // namespace murosimf::scene
