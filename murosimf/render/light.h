/// light.h - the lamp, the ambient light and the background of a scene.
#pragma once

#include <span>
#include <string_view>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

/// A lamp far away, and light from everywhere. A surface of color c with the unit normal n shows
///
///     c (sky (1 + n_z) / 2 + ground (1 - n_z) / 2 + lamp max(0, n . toward))
///
/// (Lambert's law; hemisphere light), where brightness is counted linearly and shown with an exponent of 1/2, which is
/// near to sRGB's.
struct Light {
  Vec3d toward{-0.35, -0.25, 0.9};     ///< from the scene to the lamp, any length, z > 0
  Color lamp{0.75, 0.74, 0.70};        ///< [1] brightness, linear
  Color sky{0.42, 0.44, 0.47};         ///< [1] from above
  Color ground{0.20, 0.22, 0.20};      ///< [1] from below
  Color background{0.70, 0.74, 0.78};  ///< where nothing is, as it is shown (sRGB)
  bool shadows = true;
};

struct NamedLight {
  std::string_view name, meaning;
  Light light;
};

/// "day", "hall", "night".
[[nodiscard]] std::span<const NamedLight> lights();

}  // namespace murosimf::render
