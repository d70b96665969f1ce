/// solid_shading.h - light on solids and on what is only looked at (render/light.h has the law).
#pragma once

#include <array>
#include <span>

#include "murosimf/render/light.h"
#include "murosimf/render/software/look_values.h"
#include "murosimf/render/software/pixel_rays.h"
#include "murosimf/render/software/shadow_map.h"
#include "murosimf/render/software/surface_buffer.h"

namespace murosimf::render::software {

/// Light in the optical frame of a view.
class SolidShading {
 public:
  /// `grounded`: the ground darkens what is close to it. `shadows`: null if none are cast.
  SolidShading(const Light& light, const LookValues& look, const sensors::Perspective& view, bool grounded,
               const ShadowLookup* shadows);

  /// The colors [1, sRGB] of pixels u, u + 1, ... of the row v that show these surfaces, at 1 / z.
  [[nodiscard]] Floats3 colors(const PixelRays& rays, std::span<const Surface> surfaces, const Ints& numbers,
                               const Ints& seen, int v, int u, const Floats& per_z) const;
  /// The same of one surface.
  [[nodiscard]] Floats3 colors(const PixelRays& rays, const Surface& surface, int v, int u, const Floats& per_z) const;

 private:
  [[nodiscard]] Floats3 shown(const Floats3& base, const Floats3& normal, const Floats& tangent_x, float tangent_y,
                              const Floats& per_z) const;

  const LookValues& look_;
  const ShadowLookup* shadows_;
  std::array<Float3, 3> toward_, lamp_;
  Float3 up_, sky_, earth_, pool_center_;
  float gloss_, eye_height_, grounded_, pool_size_;
};

/// The share of pixels u, u + 1, ... of the row v that is covered by threads of a net, at 1 / z.
[[nodiscard]] Floats net_cover_of(const Surface& net, int v, int u, const Floats& per_z);

}  // namespace murosimf::render::software
