#include "murosimf/dynamics/servo/joint_drive_lanes.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::dynamics {

JointDriveLanes::JointDriveLanes(std::vector<const JointDrives*> robots)
    : robots_(std::move(robots)),
      target_(robots_.front()->objects_.size() + 1),
      supply_(target_.size()),
      enabled_(target_.size()) {
  MUROSIMF_ASSERT(robots_.size() <= Pack8::lanes);
  const auto tunes = [](const JointDrives* robot) { return robot->condition_.tunes(); };
  if (std::ranges::any_of(robots_, tunes)) tuning_.resize(target_.size());
}

void JointDriveLanes::take_inputs(PoseLanes& poses, LaneMask lanes) noexcept {
  const auto robot = [&](int lane) -> const JointDrives& { return *robots_[static_cast<std::size_t>(lane)]; };
  const auto take = [&](std::vector<Pack8>& numbers, const auto& column) {
    poses.take(
        poses.joints(), lanes, [&](std::size_t k) -> Pack8& { return numbers[k + 1]; }, column);
  };
  take(target_, [&](int lane) { return robot(lane).bus_.targets().data(); });
  if (robots_.front()->condition_.supply().empty()) return;  // the model has no servos
  take(supply_, [&](int lane) { return robot(lane).condition_.supply().data(); });
  take(enabled_, [&](int lane) { return robot(lane).condition_.enabled().data(); });
  if (!tuning_.empty()) take_tuning(poses, lanes);
}

void JointDriveLanes::take_tuning(PoseLanes& poses, LaneMask lanes) noexcept {
  MUROSIMF_ASSERT(tuning_.size() == poses.joints().size() + 1);
  for (std::size_t k = 0; k < poses.joints().size(); ++k) {
    Tuning& tuning = tuning_[k + 1];
    for_lanes(lanes, [&](int lane) {
      MotorInput input;
      robots_[static_cast<std::size_t>(lane)]->condition_.tune(static_cast<int>(poses.joints()[k]), input);
      tuning.gain.set_lane(lane, input.gain);
      tuning.damping.set_lane(lane, input.damping);
      tuning.limit.set_lane(lane, input.limit);
      tuning.target_rate.set_lane(lane, input.target_rate);
      tuning.feed_forward.set_lane(lane, input.feed_forward);
    });
  }
}

DriveOf<Pack8> JointDriveLanes::drive(std::size_t link, int object, const Pack8& q, const Pack8& qd, double dt,
                                      multibody::FrictionalJoint<Pack8>& to) const noexcept {
  MUROSIMF_ASSERT(link > 0 && link < target_.size() && dt > 0);
  const JointDrives& first = *robots_.front();
  const JointDrives::Joint& joint = first.joints_[static_cast<std::size_t>(object)];
  DriveOf<Pack8> viscous, rest;
  to.coulomb = joint.coulomb;
  to.rate = qd;
  if (joint.law) {
    // numbers of the servo are those of the first robot: the robots are equal, only their inputs differ
    multibody::MotorInput<Pack8> input{.target = target_[link], .q = q, .rate = qd, .enabled = enabled_[link]};
    const double per_volt = first.condition_.per_volt(static_cast<std::size_t>(object));
    if (per_volt > 0) input.supply = supply_[link] * per_volt;
    if (!tuning_.empty()) {
      const Tuning& tuning = tuning_[link];
      input.gain = tuning.gain;
      input.damping = tuning.damping;
      input.limit = tuning.limit;
      input.target_rate = tuning.target_rate;
      input.feed_forward = tuning.feed_forward;
    }
    to.motor = joint.law->torque_in_lanes(input, dt);
    limit_rate(joint.rate_limit, input.enabled, qd, dt, to.motor);
    to.gear = joint.gear;
    damp(viscous, joint.viscous, qd, dt);
    rest = viscous;
  }
  rest.inertia = rest.inertia + joint.rotor;
  JointDrives::add_passive(joint, q, qd, dt, rest, to.end);
  to.torque = rest.torque;
  to.inertia = rest.inertia;
  return viscous;
}

}  // namespace murosimf::dynamics
