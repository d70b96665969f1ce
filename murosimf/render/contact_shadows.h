/// contact_shadows.h - where the ground is dark below what is close to it: cheap shadows without a lamp, for pictures.
#pragma once

#include <vector>

#include "murosimf/render/render_scene.h"

namespace murosimf::render {

/// A rectangle on the ground with a soft border.
struct ContactShadow {
  Vec3d middle;                            ///< [m] world, z = 0
  Vec3d along;                             ///< [1] unit vector on the ground
  double half_length = 0, half_width = 0;  ///< [m] along it, and across
  double reach = 0;                        ///< [m] of the border
  double darkness = 0;                     ///< [1] 1: black
};

/// Of all opaque shapes and meshes of the scene that are less than `contact_height` above the ground, but of `without` (may be null).
[[nodiscard]] std::vector<ContactShadow> contact_shadows(const RenderScene& render_scene, double ahead,
                                                         const Entity* without);

inline constexpr double contact_height = 0.06;  ///< [m]

}  // namespace murosimf::render
