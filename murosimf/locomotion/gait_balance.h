/// gait_balance.h - place of a robot's mass in the middle of its walk, between two steps, both feet on the ground.
#pragma once

#include "murosimf/locomotion/gait.h"

namespace murosimf::locomotion {

/// All in the level frame of the pelvis: x forward, z up, origin at the base.
struct Balance {
  double mass = 0;            ///< [kg]
  Vec3d center;               ///< [m] of mass
  std::array<Vec3d, 2> sole;  ///< [m] middles of the soles, left first
};

/// Legs as at phase 0 of a walk on the spot with these parameters, displaced sideways by `sway` [m] (the pelvis to the left); other
/// joints at their start. The model must have mass.
[[nodiscard]] Balance balance_of(const Model& model, const std::array<Leg, 2>& legs, const WalkParameters& parameters,
                                 double sway = 0);

}  // namespace murosimf::locomotion
