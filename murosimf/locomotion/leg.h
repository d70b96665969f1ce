/// leg.h - the legs of a model, as walking needs them, and their inverse kinematics.
///
/// A leg is a chain of hinges between the base and a sole, without those that all legs share (a waist), which stay at zero, in any order and direction. Where it has six of them, hip yaw,
/// roll, pitch with intersecting axes (z, x, y), knee pitch (y), ankle pitch and roll with intersecting axes (y, x), its
/// angles are found in closed form (leg_ik.h), otherwise by damped least squares (leg_solver.h).
#pragma once

#include <array>
#include <optional>

#include "murosimf/locomotion/leg_chain.h"
#include "murosimf/math/mat3.h"
#include "murosimf/model/model.h"

namespace murosimf::locomotion {

struct Leg {
  std::vector<int> joints;     ///< objects: its hinges from the base, or from where the legs part, outwards
  std::size_t knee = 0;        ///< among them
  Vec3d hip;                   ///< [m] hip center in the base frame
  Vec3d ankle;                 ///< [m] ankle center in the base frame, at joint positions 0
  double thigh = 0, shin = 0;  ///< [m]
  double ankle_height = 0;     ///< [m] ankle above the sole
  /// With the closed form: -1 where the model's axis points against the positive direction of leg_ik.h.
  std::optional<std::array<double, 6>> signs;
  LegChain chain;            ///< its tip is the ankle center; the knee stays a little bent
  double weight = 0;         ///< [m] how much a radian of the sole counts in damped least squares; 0: nothing
  std::vector<double> home;  ///< [rad] of the hinges: stands with a bent knee
};

/// Throws SetupError, with the reason, if the chain to `sole` is no leg. Five hinges and more also turn the sole. The first `shared` of
/// its hinges do not belong to it.
[[nodiscard]] Leg find_leg(const Model& model, int sole, std::size_t shared = 0);

/// Left leg first (the one with the greater y at rest). Throws SetupError if the model does not have two soles, or a leg
/// has less than five hinges.
[[nodiscard]] std::array<Leg, 2> find_legs(const Model& model);
/// The same; the model keeps them, for all robots and algorithms.
[[nodiscard]] const std::array<Leg, 2>& legs_of(const Model& model);

/// Of a quadruped: front left, front right, hind left, hind right, by their soles at rest. Throws SetupError if the model
/// does not have four soles.
[[nodiscard]] std::array<Leg, 4> find_four_legs(const Model& model);

/// Desired place of a foot.
struct FootTarget {
  Vec3d ankle;      ///< [m] from the hip center, base axes
  Mat3d sole;       ///< its axes in base axes
  double roll = 0;  ///< [rad] added at the hip, about the forward axis
};

/// Writes the positions [rad] of the leg's joints; the values in `q` on entry are where damped least squares begin. False if
/// the target is out of reach: then the foot is as near as possible.
bool bend(const Leg& leg, const FootTarget& target, std::span<double> q) noexcept;

}  // namespace murosimf::locomotion
