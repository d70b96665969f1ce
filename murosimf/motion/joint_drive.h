/// joint_drive.h - what acts in a joint, linearly implicit in its acceleration of this step: tau = torque - inertia qdd
/// (joint_drives.h).
#pragma once

#include "murosimf/motion/joint_stop.h"
#include "murosimf/motion/passive_joint.h"
#include "murosimf/multibody/servo_motor.h"
#include "murosimf/multibody/torque_line.h"

namespace murosimf::motion {

template <class S>
using DriveOf = multibody::TorqueLine<S>;

using JointDrive = DriveOf<double>;

template <class S>
void damp(DriveOf<S>& drive, double damping, const S& qd, double dt) {
  drive.torque = drive.torque - damping * qd;
  drive.inertia = drive.inertia + dt * damping;
}

/// Torque of this instant, and the inertia that makes the step that of the average force (joint_drives.h).
template <class S>
void pull(DriveOf<S>& drive, const PassiveJoint& spring, const S& q, double dt) {
  drive.torque = drive.torque - spring.stiffness * (q - spring.rest);
  drive.inertia = drive.inertia + 0.25 * dt * dt * spring.stiffness;
}

/// The end that the joint comes near in a step of `dt` [s] > 0.
template <class S>
[[nodiscard]] multibody::RangeEnd<S> end_ahead(const JointStop& stop, const S& q, const S& qd, double dt) {
  const S next = q + dt * qd;
  const auto up = next > S(0.5 * (stop.lowest + stop.highest));
  multibody::RangeEnd<S> end;
  end.direction = select(up, S(1.0), S(-1.0));
  end.gap = select(up, stop.highest - next, next - stop.lowest);
  const auto& [k, d] = stop.implicit;
  end.line = {end.direction * (k * end.gap) - d * qd, dt * d + dt * dt * k};
  return end;
}

/// Explicitly: what the end does now.
template <class S>
void stop(DriveOf<S>& drive, const JointStop& stop, const S& q, const S& qd) {
  const S beyond = q - multibody::clamped<S>(q, stop.lowest, stop.highest);
  const auto inside = beyond == S(0.0);
  if (all(inside)) return;
  const S torque = drive.torque - (stop.explicitly.stiffness * beyond + stop.explicitly.damping * qd);
  drive.torque = select(inside, drive.torque, torque);
}

}  // namespace murosimf::motion
