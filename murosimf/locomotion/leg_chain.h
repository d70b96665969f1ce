/// leg_chain.h - the hinges of one leg, from the base to its sole, and the pose of the foot.
///
/// The chain ends in a tip: a point fixed to the foot (the ankle), and the axes of the sole. With d, T the place of hinge
/// i in the one before, s its axis (multibody/kinematics.h has the same recursion for whole robots):
///
///     r_i = r_p + R_p d_i     R_i = R_p T_i rot(s_i, q_i)     tip = r_n + R_n t     sole axes = R_n F
#pragma once

#include <array>
#include <span>
#include <vector>

#include "murosimf/model/model.h"

namespace murosimf::locomotion {

inline constexpr std::size_t most_hinges = 12;  ///< of one leg

struct LegHinge {
  int object = 0;                       ///< of the model
  Vec3d offset;                         ///< [m] d
  Mat3d turn;                           ///< T
  Vec3d axis;                           ///< s, unit
  double lowest = -1e9, highest = 1e9;  ///< [rad] range
};

struct LegChain {
  std::vector<LegHinge> hinges;  ///< from the base outwards
  Vec3d tip;                     ///< [m] t, in the frame of the last hinge
  Mat3d sole;                    ///< F: axes of the sole to those of the last hinge
};

/// A chain at certain angles, in the frame of the base.
struct ChainPose {
  std::array<Vec3d, most_hinges> place;  ///< [m] of each hinge
  std::array<Vec3d, most_hinges> axis;   ///< of each hinge
  Vec3d tip;                             ///< [m]
  Mat3d sole;                            ///< axes of the sole to those of the base
};

/// The chain to the object `sole`, its tip at the sole's origin. Throws SetupError if the chain has other joints than hinges,
/// or too many. The first `shared` hinges are excluded: they stay at zero, or at the end of their range next to it.
[[nodiscard]] LegChain read_chain(const Model& model, int sole, std::size_t shared = 0);

/// Number of hinges, from the base on, that the chains to both soles share.
[[nodiscard]] std::size_t shared_hinges(const Model& model, int sole, int other_sole);

/// `q` [rad]: one angle for each hinge.
[[nodiscard]] ChainPose pose_of(const LegChain& chain, std::span<const double> q) noexcept;

/// [m] the point with the smallest sum of squared distances from the axes of hinges `first` to `end` - 1; of several, the
/// one that is nearest to `reference`.
[[nodiscard]] Vec3d center_of_axes(const ChainPose& pose, std::size_t first, std::size_t end, const Vec3d& reference);

}  // namespace murosimf::locomotion
