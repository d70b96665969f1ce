/// leg_solver.h - inverse kinematics of any chain of hinges, numerically: damped least squares.
///
/// The angles that bring the tip to its target, by steps
///
///     dq = J^T (J J^T + mu 1)^-1 e        e = [w theta; dr]        J = [w s_i; s_i x (tip - r_i)]
///
/// with theta the rotation vector from the sole's axes to the target's, dr the way of the tip, and w the length that
/// weighs a radian. A step under half a radian that makes |e| smaller is accepted and mu falls by ten; otherwise mu grows by ten. A hinge
/// that a step would move out of its range stops at its end and the others compensate.
/// Source:  Wampler, "Manipulator inverse kinematic solutions based on vector formulations and damped least-squares
///          methods", IEEE Trans. SMC 16 (1986); Nakamura, Hanafusa, "Inverse kinematic solutions with singularity
///          robustness", ASME J. DSMC 108 (1986); damping as by Marquardt, SIAM J. Appl. Math. 11 (1963).
/// Limits:  finds the solution near its start. Targets out of reach: the nearest in the sense of |e|.
#pragma once

#include "murosimf/locomotion/leg_chain.h"

namespace murosimf::locomotion {

/// Desired pose of the tip.
struct TipTarget {
  Vec3d tip;   ///< [m] in the frame of the base
  Mat3d sole;  ///< axes of the sole in those of the base
};

struct SolverOptions {
  double weight = 0.1;    ///< [m] w: how much a radian counts; 0: the sole turns freely
  double reached = 1e-9;  ///< [m, rad] errors up to this count as none
  int most_steps = 60;
};

struct SolverResult {
  double distance = 0;  ///< [m] of the tip from its target
  double angle = 0;     ///< [rad] of the sole from its target; 0 without weight
  int steps = 0;        ///< taken or tried
  bool reached = false;
};

/// `q` [rad]: the start, then the solution; angles outside their range begin at its end. One for each hinge.
SolverResult solve_leg(const LegChain& chain, const TipTarget& target, const SolverOptions& options,
                       std::span<double> q) noexcept;

}  // namespace murosimf::locomotion
