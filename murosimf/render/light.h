/// light.h - lamps, ambient light and surroundings of a scene, by name: how it looks in pictures, in the window and in browsers.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

/// A lamp far away without a shadow.
struct Lamp {
  Vec3d toward{0, 0, 1};  ///< from the scene to the lamp, any length, z > 0
  Color lamp{0, 0, 0};    ///< [1] brightness, linear
};

/// What ends the view behind the field. Colors are sRGB: of floor and walls under light of brightness 1, all others as they are shown.
struct Surroundings {
  enum class Kind { nothing, hall, outdoors };
  Kind kind = Kind::nothing;
  Color floor{0.48, 0.48, 0.47};
  // hall
  Color wall{0.80, 0.80, 0.78}, dado{0.36, 0.43, 0.50}, ceiling{0.52, 0.54, 0.56};
  Color window{0.80, 0.88, 0.95}, tube{1.0, 0.99, 0.95};  ///< windows, and lamps below the ceiling
  double clear = 3.5, height = 4.5;                       ///< [m] from the field to the walls, from floor to ceiling
  // outdoors
  Color zenith{0.28, 0.50, 0.80}, horizon{0.78, 0.86, 0.92}, hedge{0.30, 0.40, 0.30}, sun{1.0, 0.97, 0.86};
};

/// What the field looks like. Colors are sRGB under light of brightness 1.
struct FieldLook {
  Color grass{0.21, 0.50, 0.24}, paint{0.93, 0.94, 0.93};  ///< of field and lines
  // with patterns
  double stripe_width = 0.5;      ///< [m] of mown stripes
  double stripe_contrast = 0.05;  ///< [1] by which they are lighter and darker
};

/// A lamp that may cast shadows, others that do not, and light from everywhere. A surface of color c with the unit normal n shows
///
///     c (sky (1 + n_z) / 2 + ground (1 - n_z) / 2 + sum of lamp max(0, n . toward))
///
/// (Lambert's law; hemisphere light) and, with `gloss`, mirrors of lamps (Blinn, "Models of light reflection", SIGGRAPH 1977), where
/// brightness is counted linearly and shown as sRGB.
struct Light {
  Vec3d toward{-0.35, -0.25, 0.9};     ///< from the scene to the lamp, any length, z > 0
  Color lamp{0.75, 0.74, 0.70};        ///< [1] brightness, linear
  Color sky{0.42, 0.44, 0.47};         ///< [1] from above
  Color ground{0.20, 0.22, 0.20};      ///< [1] from below
  Color background{0.70, 0.74, 0.78};  ///< where nothing is, as it is shown (sRGB)
  bool shadows = true;
  std::array<Lamp, 2> others{};
  double gloss = 0;       ///< [1] share of a lamp's light that smooth bodies mirror
  double pool = 0;        ///< [m] from the middle of the field, where a quarter of the light is left; 0: it is even
  bool patterns = false;  ///< grass, worn lines, panels of balls, nets, contact shadows
  Surroundings surroundings{};  ///< drawn with patterns
  FieldLook field{};
};

// Of every renderer of pictures:
inline constexpr double nearest_drawn = 0.01;  ///< [m] along the optical axis; what is closer is not drawn
inline constexpr double soft_edge = 0.012;     ///< [m] half of the edge of shadows for people
inline constexpr double floor_reach = 500;     ///< [m] along x and y from the eye; the ground ends there
inline constexpr double ground_darkness =
    0.45;  ///< [1] of light from everywhere that is missing just above the ground, with patterns

struct NamedLight {
  std::string_view name, meaning;
  Light light;
};

/// "hall", "day", "evening", "spots", "night", "plain".
[[nodiscard]] std::span<const NamedLight> lights();

/// [1] Linear brightness that a level surface shows for each of red, green and blue; `lit`: also from the lamp that casts shadows.
[[nodiscard]] std::array<double, 3> brightness_upwards(const Light& light, bool lit);
/// The sRGB color of a surface in that much light.
[[nodiscard]] Color shown_in(const Color& surface, const std::array<double, 3>& brightness);

}  // namespace murosimf::render
