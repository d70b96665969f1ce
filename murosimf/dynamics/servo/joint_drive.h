/// joint_drive.h - torques in a joint, linearly implicit in its acceleration of this step: tau = torque - inertia qdd
/// (joint_drives.h).
#pragma once

#include "murosimf/dynamics/joint_stop.h"
#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/math/assert.h"
#include "murosimf/multibody/servo/servo_motor.h"
#include "murosimf/multibody/servo/torque_line.h"

namespace murosimf::dynamics {

template <class S>
using DriveOf = multibody::TorqueLine<S>;

using JointDrive = DriveOf<double>;

/// Adds a damper [N m s/rad | N s/m].
template <class S>
void damp(DriveOf<S>& drive, double damping, const S& qd, double dt) {
  MUROSIMF_ASSERT(dt >= 0);
  drive.torque = drive.torque - damping * qd;
  drive.inertia = drive.inertia + dt * damping;
}

/// Adds a spring: its torque of this instant, and the inertia that makes the step that of the average force (joint_drives.h).
template <class S>
void pull(DriveOf<S>& drive, const PassiveJoint& spring, const S& q, double dt) {
  MUROSIMF_ASSERT(dt >= 0);
  const S stretch = spring.stretch_as(q);
  drive.torque = drive.torque - spring.stiffness * stretch;
  const S stiffer = S(0.25 * dt * dt * spring.stiffness);
  drive.inertia = drive.inertia + (spring.slack > 0 ? select(stretch == S(0.0), S(0.0), stiffer) : stiffer);
}

/// The end of the range that the joint approaches in a step of `dt` [s] > 0.
template <class S>
[[nodiscard]] multibody::RangeEnd<S> end_ahead(const JointStop& stop, const S& q, const S& qd, double dt) {
  MUROSIMF_ASSERT(dt > 0 && stop.lowest <= stop.highest);
  const S next = q + dt * qd;
  const auto up = next > S(0.5 * (stop.lowest + stop.highest));
  multibody::RangeEnd<S> end;
  end.direction = select(up, S(1.0), S(-1.0));
  end.gap = select(up, stop.highest - next, next - stop.lowest);
  const auto& [k, d] = stop.implicit;
  end.line = {end.direction * (k * end.gap) - d * qd, dt * d + dt * dt * k};
  return end;
}

/// Adds the present torque of an end, explicitly.
template <class S>
void stop(DriveOf<S>& drive, const JointStop& stop, const S& q, const S& qd) {
  const S beyond = q - multibody::clamped<S>(q, stop.lowest, stop.highest);
  const auto inside = beyond == S(0.0);
  if (all(inside)) return;
  const S torque = drive.torque - (stop.explicitly.stiffness * beyond + stop.explicitly.damping * qd);
  drive.torque = select(inside, drive.torque, torque);
}

}  // namespace murosimf::dynamics
