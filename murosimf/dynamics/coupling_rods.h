/// coupling_rods.h - what coupled joints follow by, as coupling_forces.h settles it: q_f = offset + sum r_l q_l.
///
/// One rod per coupled joint (joint_coupling), tendon (joint_tendon, spatial_tendon) and tie of tendons (tendon_tie). Of curves, the length
/// of a spatial tendon and the polynomial of a tie, r and offset are those of the tangent where they were followed last.
#pragma once

#include <span>
#include <vector>

#include "murosimf/dynamics/mimic_joints.h"

namespace murosimf::dynamics {

inline constexpr double bend_under_load = 0.2e-3;  // [rad] deflections that stiffnesses follow from (coupling_forces.h)
inline constexpr double shift_under_load = 0.02e-3;  // [m]

struct CouplingRod {
  struct Joint {
    int object = 0, link = 0;
    double share = 1;  ///< r
  };
  Joint follower;
  std::vector<Joint> leaders;
  double offset = 0;       ///< [rad | m]
  double stiffness = 0;    ///< [N m/rad | N/m] k
  double lightest = 0;     ///< [1] trace over the inertia that it takes along
  double trace = 0;        ///< [kg m^2 | kg] inertia of a follower that moves none
  double taken_along = 0;  ///< [kg m^2 | kg] by the slider of a tendon
  const MimicJoints::Tendon* tendon = nullptr;
  const TendonTie* tie = nullptr;

  /// [rad | m] Where the follower is to be, for positions by object.
  [[nodiscard]] double place(std::span<const double> q) const noexcept;
  /// The tangent of a curve at q; of one that is none nothing changes.
  void follow(std::span<const double> q) noexcept;
  /// [1/(kg m^2) | 1/kg] Of the leaders along it. `moved` [kg m^2 | kg]: inertia that each joint moves by itself, by link; `mass` [kg] of the
  /// robot, which no spatial tendon exceeds.
  [[nodiscard]] double mobility(std::span<const double> moved, double mass) const noexcept;
  /// What a spatial tendon's slider takes along at the present tangent, and its trace.
  void weigh(std::span<const double> moved, double mass) noexcept;
};

/// Of each pair, then of each tendon, then of each tie. They refer to `joints`.
[[nodiscard]] std::vector<CouplingRod> coupling_rods(const Model& model, const MimicJoints& joints);

}  // namespace murosimf::dynamics
