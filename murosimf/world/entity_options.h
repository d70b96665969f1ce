/// entity_options.h - how an entity is placed, shown and takes part in collision; the scene decides.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/model/shape.h"

namespace murosimf {

/// How an entity takes part in collision detection (collision/compound.h).
struct CollisionOptions {
  std::string volume = "sphere";                           ///< bounding volumes of its tree, by name
  bool self_collision = false;                             ///< its own limbs may touch each other
  std::vector<std::pair<std::string, std::string>> never;  ///< objects of it that never touch each other
};

struct EntityOptions {
  Vec3d position;           ///< [m] of the base on the ground plane: z is added to what the level finds
  double heading = 0;       ///< [rad] about the vertical
  Mat3d attitude;           ///< turns the level robot before it gets its heading; ignored by kinematic_walking
  bool base_level = false;  ///< a robot is level when its base is; else when its first sole is, if it has one
  std::string team;         ///< empty for none
  Color color;              ///< of the team or of the thing
  CollisionOptions collision;
  bool present = true;    ///< at the start (Simulation::enter, leave)
  int step_multiple = 1;  ///< factor of the step length of its motion and ground contact while no entity is near
};

}  // namespace murosimf
