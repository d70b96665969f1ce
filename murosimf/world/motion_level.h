/// motion_level.h - a level of detail as an algorithm: it moves one entity, and another level can take over from it.
///
/// Levels are exchanged between two steps (runtime/simulation.h, exchange). Their common state is in the columns: poses,
/// velocities, joint positions and rates are kept there. Only momentum is passed separately, since its definition
/// differs: for simplified_dynamics it is that of a rigid body that turns as the base does, whatever the limbs
/// do; for levels with masses in every link it is the sum over the links.
#pragma once

#include <string>

#include "murosimf/math/vec3.h"
#include "murosimf/world/algorithm.h"

namespace murosimf {

/// Of a whole entity, world axes.
struct Momentum {
  Vec3d linear;   ///< [N s]
  Vec3d angular;  ///< [N m s] about the common center of mass
};

/// Traits of a level. Code that depends on them reads these, never the level's name: plug-ins add levels.
struct LevelTraits {
  bool dynamic = false;       ///< forces move the entity: gravity, contacts, pushes
  bool joint_torque = false;  ///< it works out the torques of driven joints
  bool servos = false;        ///< servo models drive the joints: they draw current, get warm and are stiff to step
};

class MotionLevel : public Algorithm {
 public:
  [[nodiscard]] Phase phase() const noexcept final { return Phase::motion; }
  [[nodiscard]] virtual LevelTraits traits() const = 0;
  /// Reason why the level cannot continue from the columns, without the entity's name; empty if it can. Changes nothing.
  [[nodiscard]] virtual std::string refusal() const { return {}; }
  /// Last call of a level: detaches from the entity. Returns the momentum of its equations of motion.
  [[nodiscard]] virtual Momentum hand_over() noexcept = 0;
  /// First call, instead of initialize(), in a running simulation: keeps the pose and the joints, and
  /// continues with `momentum`. Throws SetupError if the model is impossible at this level.
  virtual void take_over(const Momentum& momentum) = 0;
};

}  // namespace murosimf
