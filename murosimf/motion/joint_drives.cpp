#include "murosimf/motion/joint_drives.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/motion/torque_watch.h"

namespace murosimf::motion {
namespace {

constexpr double stop_bend = 0.25 * pi / 180;  // [rad]
constexpr double stop_shift = 0.5e-3;          // [m]
constexpr double stop_damping_time = 5e-3;     // [s] damper over spring

double value_or_zero(const double* number) { return number ? *number : 0; }

bool has_dry_part(const GearFriction& k) {
  return k.coulomb > 0 || k.stribeck > 0 || k.motor_load > 0 || k.external_load > 0 || k.stribeck_motor_load > 0 ||
         k.stribeck_external_load > 0 || k.quadratic_motor_load > 0 || k.quadratic_external_load > 0;
}

void damp(JointDrive& drive, double damping, double qd, double dt) {
  drive.torque -= damping * qd;
  drive.inertia += dt * damping;
}

}  // namespace

JointDrives::JointDrives(Setup& setup)
    : joints_(static_cast<std::size_t>(setup.model().size())),
      turning_(setup),
      objects_(setup.model().joints()),
      target_(setup.input(properties::joint_target, 0.0)),
      delayed_(setup.write(delayed_target)),
      present_(joints_.size()) {
  const double weight = setup.model().tree().mass * 9.81;
  for (const int i : objects_) {
    joints_[i] = make_joint(setup.model(), i, weight);
    delayed_[i].reset(static_cast<std::size_t>(std::lround(joints_[i].command_delay / seconds(setup.period()))), 0);
  }
}

JointDrives::Joint JointDrives::make_joint(const Model& model, int i, double weight) {
  Joint joint;
  joint.rotor = rotor_inertia(model, i);
  joint.damping = value_or_zero(model.find(properties::joint_damping, i));
  joint.coulomb = value_or_zero(model.find(properties::joint_friction, i));
  const Servo* servo = model.find(properties::servo, i);
  if (servo) {
    joint.law = make_servo_law(*servo);
    joint.command_delay = servo->command_delay;
    joint.viscous = servo->friction.viscous;
    if (has_dry_part(servo->friction)) joint.gear = &servo->friction;
  }
  if (const Vec3d* range = model.find(properties::joint_range, i)) {
    joint.lowest = range->x;
    joint.highest = range->y;
    const double stall = servo ? servo->stall_torque : 0;
    const bool slider = model.objects()[i].kind == Kind::prismatic;
    joint.stop_stiffness = slider ? std::max(stall, weight) / stop_shift : std::max(stall, 0.1 * weight) / stop_bend;
  }
  return joint;
}

void JointDrives::initialize(std::span<double> q, std::span<double> qd) noexcept {
  for (const int i : objects_) {
    const Joint& joint = joints_[i];
    q[i] = joint.stop_stiffness > 0 ? std::clamp(target_[i], joint.lowest, joint.highest) : target_[i];
    qd[i] = 0;
  }
  take_over();
}

void JointDrives::take_over() noexcept {
  for (const int i : objects_) {
    present_[i] = target(i);
    delayed_[i].fill(present_[i]);
  }
}

bool JointDrives::take_targets() noexcept {
  constexpr double largest = 1e4;  // [rad | m | rad/s | m/s]
  bool sane = true;
  for (const int i : objects_) {
    const double wanted = target(i);
    sane &= std::abs(wanted) < largest;  // NaN is not less
    present_[i] = delayed_[i].pass(wanted);
  }
  return sane;
}

JointDrives::Answer JointDrives::drive(int i, double q, double qd, double dt) const noexcept {
  const Joint& joint = joints_[i];
  Answer answer{.gear = joint.gear, .coulomb = joint.coulomb};
  if (joint.law) {
    answer.servo = joint.law->drive(present_[i], q, qd, dt);
    answer.motor_torque = answer.servo.torque;
    damp(answer.servo, joint.viscous, qd, dt);
  }
  JointDrive& all = answer.all;
  all = {answer.servo.torque, answer.servo.inertia + joint.rotor};
  damp(all, joint.damping, qd, dt);
  if (joint.stop_stiffness > 0) {
    const double next = q + dt * qd;
    const double beyond = next - std::clamp(next, joint.lowest, joint.highest);
    if (beyond != 0) {
      const double d = joint.stop_stiffness * stop_damping_time;
      all.torque -= joint.stop_stiffness * beyond + d * qd;
      all.inertia += dt * d + dt * dt * joint.stop_stiffness;
    }
  }
  return answer;
}

}  // namespace murosimf::motion
