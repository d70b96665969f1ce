/// leg.h - the geometry of one leg, read from a model: what inverse kinematics and the walk need.
///
/// A leg here has six hinges between the base and the sole: hip yaw, roll, pitch with intersecting axes (z, x, y), knee
/// pitch (y), ankle pitch and roll with intersecting axes (y, x), in this order; axes may point either way.
#pragma once

#include <array>

#include "murosimf/math/mat3.h"
#include "murosimf/model/model.h"

namespace murosimf::control {

struct Leg {
  std::array<int, 6> joints{};    ///< objects: hip yaw, roll, pitch, knee, ankle pitch, roll
  std::array<double, 6> signs{};  ///< -1 where the model's axis points against the positive direction used here
  Vec3d hip;                      ///< [m] hip center in the base frame
  double thigh = 0, shin = 0;     ///< [m]
  double ankle_height = 0;        ///< [m] ankle above the sole
};

/// Throws SetupError, naming the joint that does not fit, if the chain to `sole` is no leg as described.
[[nodiscard]] Leg find_leg(const Model& model, int sole);

/// Left leg first (the one with the greater y at rest). Throws SetupError if the model does not have two soles.
[[nodiscard]] std::array<Leg, 2> find_legs(const Model& model);

}  // namespace murosimf::control
