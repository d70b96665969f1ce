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

template <class S>
void stop(DriveOf<S>& drive, const JointStop& end, const S& q, const S& qd, double dt) {
  const S next = q + dt * qd;
  const S beyond = next - multibody::clamped<S>(next, end.lowest, end.highest);
  const auto inside = beyond == S(0.0);
  if (all(inside)) return;
  const S torque = drive.torque - (end.stiffness * beyond + end.damping * qd);
  const S inertia = drive.inertia + (dt * end.damping + dt * dt * end.stiffness);
  drive.torque = select(inside, drive.torque, torque);
  drive.inertia = select(inside, drive.inertia, inertia);
}

}  // namespace murosimf::motion
