/// motion_level.h - a level of detail as an algorithm: it moves one entity, and another level can take over from it.
///
/// Levels are exchanged between two steps (runtime/simulation.h, exchange). What they share is in the columns: poses,
/// velocities, joint positions and rates stand there and stay. Only momentum is said beside them, since it means
/// different things: to simplified_dynamics it is that of a rigid body that turns as the base does, whatever the limbs
/// do; to levels with masses in every link it is the sum over the links.
#pragma once

#include <string>

#include "murosimf/math/vec3.h"
#include "murosimf/model/algorithm.h"

namespace murosimf {

/// Of a whole entity, world axes.
struct Momentum {
  Vec3d linear;   ///< [N s]
  Vec3d angular;  ///< [N m s] about the common center of mass
};

/// What a level has. Who must know asks for this, never for the level's name: there may be more levels than those here.
struct LevelTraits {
  bool dynamic = false;       ///< forces move the entity: gravity, contacts, pushes
  bool joint_torque = false;  ///< it works out the torques of driven joints
  bool servos = false;        ///< servo models drive the joints: they draw current, get warm and are stiff to step
};

class MotionLevel : public Algorithm {
 public:
  [[nodiscard]] Phase phase() const noexcept final { return Phase::motion; }
  [[nodiscard]] virtual LevelTraits traits() const = 0;
  /// Why the level cannot go on from what the columns say, without the entity's name; empty if it can. Changes nothing.
  [[nodiscard]] virtual std::string refusal() const { return {}; }
  /// Its last call: lets go of the entity. Returns the momentum that its equations have kept.
  [[nodiscard]] virtual Momentum hand_over() noexcept = 0;
  /// Its first call, instead of initialize(), in a running simulation: leaves the pose and the joints as they are, and
  /// goes on with `momentum`. Throws SetupError if the model is impossible at this level.
  virtual void take_over(const Momentum& momentum) = 0;
};

}  // namespace murosimf
