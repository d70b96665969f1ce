/// shadow_map.h - how far the light of the lamp that casts shadows reaches.
///
/// Depths of the far sides of all pieces as the lamp sees them (Williams, "Casting curved shadows on curved surfaces", SIGGRAPH 1978): near
/// sides cannot darken themselves. A place is lit by the share of the four nearest depths that lie behind it (Reeves, Salesin, Cook,
/// "Rendering antialiased shadows with depth maps", SIGGRAPH 1987).
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "murosimf/render/instances.h"
#include "murosimf/render/lamp_view.h"
#include "murosimf/render/software/float_lanes.h"
#include "murosimf/render/software/seen_corner.h"

namespace murosimf::render::software {

class ShadowMap {
 public:
  explicit ShadowMap(int side);

  /// Draws these pieces, seen from the lamp.
  void draw(const LampView& lamp, const MeshCatalog& catalog, const InstanceList& list);

  [[nodiscard]] const LampView& lamp() const { return lamp_; }
  [[nodiscard]] double texel() const { return texel_; }  ///< [m]
  [[nodiscard]] int side() const { return side_; }       ///< [texels]
  /// Whether anything may cast a shadow at texels u, v or at their right and lower neighbors. u and v are from -2 to side() + 1.
  [[nodiscard]] bool has_content(const Ints& u, const Ints& v) const;
  /// [m] Depth along the light at a texel; infinite where nothing is, or outside.
  [[nodiscard]] float depth(int u, int v) const {
    if (u < 0 || v < 0 || u >= side_ || v >= side_) return nothing;
    return -nearness_[row(v) + static_cast<std::size_t>(u)];
  }

 private:
  static constexpr int tile = 32;  // [texels]; a tile to each side lies outside
  static constexpr float nothing = 1e30F;
  void clear();
  void mark(const PixelBox& box);
  [[nodiscard]] std::size_t row(int v) const { return static_cast<std::size_t>(v) * stride_; }

  int side_, tiles_;
  std::size_t stride_;
  LampView lamp_;
  double texel_ = 1;
  std::vector<float> nearness_;       // minus the depth
  std::vector<std::uint8_t> marked_;  // tiles with content
  std::vector<SeenCorner> corners_;
};

/// Places in the optical frame of a view, in a shadow map.
class ShadowLookup {
 public:
  /// `edge` [m]: half of the width of a shadow's edge; 0: that of a texel.
  ShadowLookup(std::shared_ptr<const ShadowMap> map, const sensors::Perspective& view, double edge);

  /// [1] Share of the lamp's light at places p of the optical frame.
  [[nodiscard]] Floats lit_at(const Floats3& p) const;
  /// The same on a surface with the unit normal n: a little before it, so that it does not darken itself.
  [[nodiscard]] Floats lit_at(const Floats3& p, const Floats3& n) const { return lit_at(p + n * all_lanes(gap_)); }

 private:
  /// A place in the map.
  struct Spot {
    Floats u, v, depth;
  };
  [[nodiscard]] Floats lit_at(const Spot& spot) const;
  [[nodiscard]] bool may_be_shaded(const Spot& spot) const;
  struct Row {
    Float3 turn;
    float shift = 0;
  };
  std::shared_ptr<const ShadowMap> map_;
  Row u_, v_, depth_;
  float gap_;              // [m]
  float edge_u_, edge_v_;  // [texels]
};

/// The map of an instant, which all views of it share. Several threads may ask.
class ShadowMaps {
 public:
  [[nodiscard]] std::shared_ptr<const ShadowMap> at(const RenderScene& scene, const MeshCatalog& catalog,
                                                    const Vec3d& toward, int side, double ahead);

 private:
  /// Maps that no view looks into.
  struct Spare {
    std::mutex mutex;
    std::vector<std::unique_ptr<ShadowMap>> maps;
  };
  [[nodiscard]] std::shared_ptr<ShadowMap> take(int side);

  std::shared_ptr<Spare> spare_ = std::make_shared<Spare>();
  std::mutex mutex_;  // of the others
  InstanceList list_;
  std::vector<Instance> drawn_;
  std::shared_ptr<ShadowMap> latest_;
};

}  // namespace murosimf::render::software
