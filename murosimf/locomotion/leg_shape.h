/// leg_shape.h - finds hip, knee and ankle in a chain of hinges.
///
/// The knee is the hinge with the axis at the greatest distance from both ends of the leg: the larger of the smaller of
/// its distances from the first hinge and from the sole. Hinges before it are the hip's, those behind it the ankle's;
/// their centers are the points nearest to their axes (a leg without an ankle has its sole there). All at angles 0.
#pragma once

#include <string>

#include "murosimf/locomotion/leg_chain.h"

namespace murosimf::locomotion {

struct LegShape {
  std::size_t knee = 0;
  Vec3d hip, ankle;            ///< [m] centers at angles 0, in the frame of the base
  double thigh = 0, shin = 0;  ///< [m] from the knee's axis to the two centers
  double straight = 0;         ///< [rad] angle of the knee with a straight leg
  double bend = 1;  ///< sign in which the knee bends: the wider side of its range, or the one that bends it forward
};

/// `problem` receives the reason if there is no such leg, and stays empty otherwise.
[[nodiscard]] LegShape shape_of(const LegChain& chain, std::string& problem);

}  // namespace murosimf::locomotion
