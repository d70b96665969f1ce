#include "murosimf/dynamics/velocity_joints.h"

#include <cmath>
#include <limits>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {

VelocityJoints::VelocityJoints(Setup& setup)
    : turns_(static_cast<std::size_t>(setup.model().size())),
      lowest_(turns_.size(), -std::numeric_limits<double>::infinity()),
      highest_(turns_.size(), std::numeric_limits<double>::infinity()) {
  const Model& model = setup.model();
  for (const int i : model.joints()) {
    const Servo* servo = model.find(properties::servo, i);
    const bool turns = servo && follows_rate(*servo);
    turns_[i] = turns;
    if (const Vec3d* range = model.find(properties::joint_target_range, i); turns && range) {
      lowest_[i] = range->x;
      highest_[i] = range->y;
    }
    (turns ? joints_ : others_).push_back(i);
    // only hinges without ends can turn for ever; sliders and limited hinges keep their position
    const bool hinge = model.objects()[i].kind == Kind::revolute;
    if (turns && hinge && !model.find(properties::joint_range, i)) endless_.push_back(i);
  }
  if (!joints_.empty()) target_ = setup.input(properties::joint_velocity_target, 0.0);
  MUROSIMF_ASSERT(joints_.size() + others_.size() == model.joints().size());
}

void VelocityJoints::wrap(std::span<double> q) const noexcept {
  MUROSIMF_ASSERT(q.size() == turns_.size());
  for (const int i : endless_) {
    if (std::abs(q[i]) > pi) q[i] = std::remainder(q[i], 2 * pi);
  }
}

}  // namespace murosimf::dynamics
