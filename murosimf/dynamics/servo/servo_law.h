/// servo_law.h - torque of a servo for its target: the exchangeable part of articulated dynamics.
///
/// Everything on the output side of the gear. A law is linearly implicit in the joint's acceleration of this step,
///
///     tau = torque - inertia qdd
///
/// that is, implicit Euler of the linearized servo: with e = target - q - h qd the error that would remain at the end of
/// the step without acceleration, a spring kp and a damper b give torque = kp e - b qd, inertia = h b + h^2 kp. Its limits are lines of
/// their own, between which the joint's inertia decides (multibody/servo/torque_line.h): if decided at the beginning of the step, a stiff servo
/// would drive a light limb from one limit to the other, for ever. With h = 0 `now` is the torque of this instant.
///
/// ideal_pd:   tau = kp (target - q) + kd (target rate - qd) + feed-forward, between its shares of stall_torque if that is given; target rate and
///             feed-forward torque are 0 until software sets them (ServoCondition). Without kp, as a wheel's drive:
///             tau = kd (rate target - qd). No motor: neither supply nor heat matter
/// dc_motor:   firmware and motor of multibody/servo/servo_motor.h
///
/// Both quantize positions to the encoder's steps and have the dead band; both produce exactly no torque while it is switched
/// off.
/// Friction of the gear is not included: joint_drives.h, multibody/friction_solver.h.
/// Source: textbook permanent-magnet DC motor (stall = k_t V/R, stall/no_load = k_t^2/R); order of the two limits as
/// firmware has it: it can only move the duty.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "murosimf/math/pack.h"
#include "murosimf/multibody/servo/servo_motor.h"

namespace murosimf::dynamics {

using MotorInput = multibody::MotorInput<double>;
using MotorTorque = multibody::MotorTorque<double>;

class ServoLaw {
 public:
  virtual ~ServoLaw() = default;

  /// Torque at the beginning of a step of `dt` [s]; the target is a rate [rad/s] if the servo follows one. Rotor inertia and
  /// friction are not included.
  [[nodiscard]] virtual MotorTorque torque(const MotorInput& input, double dt) const noexcept = 0;
  /// The same for eight servos with the numbers of this one, each in its lane, with the same bits.
  [[nodiscard]] virtual multibody::MotorTorque<Pack8> torque_in_lanes(const multibody::MotorInput<Pack8>& input,
                                                                      double dt) const noexcept;
  /// Largest torque [N m] of the servo on a joint that it drives, without friction of its gear, in the direction of `direction` (+1 or -1) at rate `qd` [rad/s].
  [[nodiscard]] virtual double available(double qd, double direction) const noexcept = 0;
};

/// True for a servo without position gain but with velocity gain: its joint follows joint_velocity_target.
[[nodiscard]] bool follows_rate(const Servo& servo);

/// The servo with another law; empty: with its own. A motor that becomes an ideal_pd keeps the damping of its back-EMF.
[[nodiscard]] Servo with_law(const Servo& servo, std::string_view law);

struct ServoLawEntry {
  std::string_view name, meaning;
  std::unique_ptr<ServoLaw> (*make)(const Servo&);
};

[[nodiscard]] std::span<const ServoLawEntry> servo_laws();

/// The law that the servo names. Throws SetupError if there is none, or if a number is missing.
[[nodiscard]] std::unique_ptr<ServoLaw> make_servo_law(const Servo& servo);

}  // namespace murosimf::dynamics
