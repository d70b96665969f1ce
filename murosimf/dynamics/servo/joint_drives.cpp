#include "murosimf/dynamics/servo/joint_drives.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/servo/gear_friction.h"

namespace murosimf::dynamics {
namespace {

double value_or_zero(const double* number) { return number ? *number : 0; }

bool has_dry_part(const GearFriction& k) {
  return k.coulomb > 0 || k.stribeck > 0 || k.motor_load > 0 || k.external_load > 0 || k.stribeck_motor_load > 0 ||
         k.stribeck_external_load > 0 || k.quadratic_motor_load > 0 || k.quadratic_external_load > 0;
}

}  // namespace

JointDrives::JointDrives(Setup& setup, const std::string& law)
    : joints_(static_cast<std::size_t>(setup.model().size())),
      objects_(setup.model().joints()),
      bus_(setup),
      condition_(setup, law),
      backlash_(setup) {
  for (const int i : objects_) {
    joints_[i] = make_joint(setup.model(), i, law);
    const auto& [lowest, highest] = bus_.coupled().range(i);
    joints_[i].stop = joint_stop(setup.model(), i, lowest, highest, bus_.coupled().pairs());
    const Servo* servo = setup.model().find(properties::servo, i);
    if (servo) joints_[i].rate_limit = rate_limit(*servo, bus_.coupled().rate_limit(i));
    // few servos have memory: only these cost a call at the end of the step
    if (backlash_.at(i) || condition_.heats(i)) remembering_.push_back(i);
  }
}

JointDrives::Joint JointDrives::make_joint(const Model& model, int i, const std::string& law) {
  Joint joint;
  joint.rotor = rotor_inertia(model, i);
  joint.passive = passive_joint(model, i);
  joint.coulomb = value_or_zero(model.find(properties::joint_friction, i));
  const Servo* servo = model.find(properties::servo, i);
  if (servo) {
    joint.law = make_servo_law(with_law(*servo, law));
    joint.viscous = servo->friction.viscous;
    if (has_dry_part(servo->friction)) joint.gear = &servo->friction;
  }
  return joint;
}

void JointDrives::initialize(std::span<double> q, std::span<double> qd) noexcept {
  for (const int i : objects_) {
    const auto& [lowest, highest] = bus_.coupled().range(i);
    MUROSIMF_ASSERT(lowest <= highest);
    q[i] = std::clamp(bus_.position_target(i), lowest, highest);
    qd[i] = 0;
  }
  bus_.coupled().follow(q, qd);  // after all leaders are placed
  condition_.cool_down();
  take_over(qd);
}

void JointDrives::take_over(std::span<const double> qd) noexcept {
  bus_.start();
  condition_.take_over();
  backlash_.start(qd);
}

MotorTorque JointDrives::motor(int i, double q, double rate, double dt) const noexcept {
  MUROSIMF_ASSERT(i >= 0 && static_cast<std::size_t>(i) < joints_.size() && joints_[i].law && dt >= 0);
  MotorInput input{.target = bus_.target(i), .q = q, .rate = rate};
  condition_.fill(i, input);
  MotorTorque torque = joints_[i].law->torque(input, dt);
  limit_rate(joints_[i].rate_limit, input.enabled, rate, dt, torque);
  return torque;
}

JointDrive JointDrives::drive(int i, double q, double qd, double dt,
                              multibody::FrictionalJoint<double>& to) const noexcept {
  MUROSIMF_ASSERT(i >= 0 && static_cast<std::size_t>(i) < joints_.size() && dt >= 0);
  const Joint& joint = joints_[i];
  JointDrive viscous, rest;
  to.coulomb = joint.coulomb;
  to.rate = qd;
  to.gear = nullptr;
  to.motor = {};
  if (backlash_.touches(i)) {
    // between the sides of the play, the servo's motor, friction and rotor do not act on the joint
    if (joint.law) {
      to.motor = motor(i, q, qd, dt);
      to.gear = joint.gear;
      damp(viscous, joint.viscous, qd, dt);
      rest = viscous;
    }
    rest.inertia += joint.rotor;
    if (backlash_.at(i) && dt > 0) rest.torque += backlash_.arrival(i, qd, dt);
  }
  add_passive(joint, q, qd, dt, rest, to.end);
  to.torque = rest.torque;
  to.inertia = rest.inertia;
  return viscous;
}

/// Explicit steps have no budget to spend: friction becomes a damper (passive_joint.h).
void JointDrives::brake_explicitly(multibody::FrictionalJoint<double>& joint) noexcept {
  // the share of F that the damper gives at this rate: 1 but near rest
  const double share = coulomb_damping(1, joint.rate) * std::abs(joint.rate);
  joint.budget = joint.coulomb *= share;
  if (joint.gear) {
    joint.budget += share * multibody::dry_friction(*joint.gear, joint.rate, joint.motor.now, joint.load);
  }
  joint.direction = std::copysign(1.0, joint.rate);
  joint.line = {joint.motor.now};
}

void JointDrives::finish(int i, const Outcome& outcome, double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  double torque = outcome.motor_torque;
  if (backlash_.touches(i)) {
    if (backlash_.at(i)) backlash_.follow(i, outcome.torque, outcome.rate, dt);
  } else {
    // the motor side turns alone: its law is evaluated at its own rate
    const MotorTorque alone = motor(i, outcome.position, backlash_.rate(i), dt);
    torque = alone.now;
    backlash_.turn(i, alone, outcome.rate, dt);
  }
  if (condition_.heats(i)) condition_.warm(i, torque, dt);
}

}  // namespace murosimf::dynamics
