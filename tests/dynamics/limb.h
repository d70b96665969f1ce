/// limb.h - a bolted base and one limb on a servo.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/physics/rig.h"

namespace murosimf::test {

/// The limb "j", and "k" behind the base's other side that follows it, if it has a ratio.
struct LimbModel {
  Servo servo;
  double inertia = 0.01;               ///< [kg m^2] about its center of mass
  double arm = 0;                      ///< [m] 0: about a vertical hinge; else its mass is that far from a level one
  double mass = 1;                     ///< [kg]
  double friction = 0;                 ///< [N m] of the joint itself
  std::optional<double> rate_limit{};  ///< [rad/s]
  std::optional<Vec3d> range{};        ///< [rad]
  std::optional<double> follows{};     ///< [1] ratio of a follower of the same inertia
};

/// Its last object is the limb's joint.
inline void add_limb(Chain& chain, const LimbModel& limb, const std::string& name) {
  chain.revolute(name, limb.arm == 0 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0})
      .with(properties::mass, limb.mass)
      .with(properties::center_of_mass, {limb.arm, 0, 0})
      .with(properties::inertia, diagonal(limb.inertia));
}

inline void add_driven_limb(Chain& chain, const LimbModel& limb) {
  add_limb(chain, limb, "j");
  chain.with(properties::servo, limb.servo).with(properties::joint_friction, limb.friction);
  if (limb.rate_limit) chain.with(properties::joint_rate_limit, *limb.rate_limit);
  if (limb.range) chain.with(properties::joint_range, *limb.range);
}

inline ModelPtr make_model(const LimbModel& limb) {
  Chain base = Chain{}.base("base").with(properties::mass, 3.0).with(properties::inertia, diagonal(0.1));
  if (limb.follows) {
    Chain leader, follower;
    add_driven_limb(leader, limb);
    add_limb(follower, limb, "k");
    follower.with(properties::joint_coupling, {"j", *limb.follows, 0.0});
    base.fork(leader, follower);
  } else {
    add_driven_limb(base, limb);
  }
  return std::make_shared<const Model>("limb", base);
}

struct LimbRun {
  double steps_per_second = 1000;
  std::string level = "articulated_dynamics";
  dynamics::ReferenceKind reference = dynamics::ReferenceKind::filter;
};

struct Limb {
  explicit Limb(const LimbModel& model, const LimbRun& run = {})
      : rig(0.8, 0, run.steps_per_second), entity(rig.add("limb", make_model(model))) {
    entity.column(properties::motor_torque);  // for `motor_torque`: levels write it where it is wanted
    rig.attach_dynamics(entity, {.level = run.level,
                                 .on_ground = false,
                                 .options = {.reference = {.kind = run.reference}},
                                 .tree = {.fixed_base = run.level != "simplified_dynamics"}});
    rig.simulation.initialize();
  }
  void go_to(double target) { entity.object("j").set(properties::joint_target, target); }
  void place(double q, double qd) {
    entity.object("j").set(properties::joint_position, q);
    entity.object("j").set(properties::joint_velocity, qd);
  }
  double torque() { return entity.object("j").get(properties::joint_torque); }
  double motor_torque() { return entity.object("j").get(properties::motor_torque); }
  double q(const char* joint = "j") { return entity.object(joint).get(properties::joint_position); }
  double qd() { return entity.object("j").get(properties::joint_velocity); }
  /// visit() after each step.
  template <class Visit>
  void run(double seconds, const Visit& visit) {
    for (int i = 0; i < std::lround(seconds * rig.rate); ++i) {
      rig.simulation.step();
      visit();
    }
  }

  Rig rig;
  Entity& entity;
};

/// Steps that servos are tested at.
inline constexpr double servo_steps[] = {0.5e-3, 1e-3, 2e-3, 5e-3, 8e-3, 10e-3};  // [s]

}  // namespace murosimf::test
