/// air_options.h - the air of a scene, and what balls have in it.
#pragma once

#include "murosimf/math/vec3.h"

namespace murosimf::air {

/// What the drag of a smooth or a small soccer ball is below the drag crisis (Asai et al. 2007; Goff and Carre 2009).
inline constexpr double usual_drag = 0.5;
/// 1 / 2.32.
inline constexpr double usual_lift = 0.43;

struct AirOptions {
  double density = 1.2;  ///< [kg/m^3] at 20 degrees Celsius and sea level; 0: no air
  Vec3d wind;            ///< [m/s] world
};

}  // namespace murosimf::air
