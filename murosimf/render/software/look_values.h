/// look_values.h - light, field and surroundings as numbers for shading in lanes.
#pragma once

#include <array>

#include "murosimf/render/light.h"
#include "murosimf/render/look.h"
#include "murosimf/render/software/float_lanes.h"

namespace murosimf::render::software {

[[nodiscard]] inline Float3 floats(const Color& color) {
  return {static_cast<float>(color.red), static_cast<float>(color.green), static_cast<float>(color.blue)};
}

/// A color of the ground as it is shown, sRGB: where the lamp that casts shadows shines, and where it does not.
struct GroundColor {
  Float3 lit, shaded;
  /// `light`: share of the lamp's light, if there are shadows.
  [[nodiscard]] Floats3 at(const Floats& light, bool shadows) const {
    return shadows ? mixed(all_lanes(shaded), all_lanes(lit), light) : all_lanes(lit);
  }
};

/// All of the light that does not depend on the view. Names as in look_patterns.h.
struct LookValues {
  LookValues(const Light& light, const Markings* markings, bool fine);

  bool patterns = false;
  bool fine = false;  ///< pile of short fibers, as render/software/fine_pile.h has them
  Surroundings::Kind kind = Surroundings::Kind::nothing;
  Float3 background;  ///< as shown
  GroundColor floor, grass, paint;
  Float3 net;                             ///< as shown
  float half_length = 0, half_width = 0;  ///< [m] of the field; 0: there is none
  std::array<float, 2> lines_reach{}, stripe{};
  float pool = 0, haze = 0, wall_height = 0;
  Float3 wall, dado, ceiling, pane, tube, zenith, horizon, hedge, sun, sun_toward;
};

}  // namespace murosimf::render::software
