/// software_drawing.h - draws views of a scene, one at a time.
#pragma once

#include <optional>

#include "murosimf/render/instances.h"
#include "murosimf/render/renderer.h"
#include "murosimf/render/software/far_eye.h"
#include "murosimf/render/software/ground_shading.h"
#include "murosimf/render/software/look_values.h"
#include "murosimf/render/software/samples.h"
#include "murosimf/render/software/seen_solids.h"
#include "murosimf/render/software/shadow_map.h"
#include "murosimf/render/software/solid_shading.h"
#include "murosimf/render/software/surface_buffer.h"

namespace murosimf::render::software {

/// What is equal for all views of a scene in a light.
struct Stage {
  Stage(const RenderScene& scene, const RendererOptions& options, ShadowMaps& maps);
  LookValues look;
  Light light;
  bool fine;
  bool ground;
  LookSurface walls, ceiling, nets;  ///< empty where there are none
  int shadow_side, samples;
  ShadowMaps& shadows;  ///< shared by all views, and kept when the light changes
};

class SoftwareDrawing {
 public:
  explicit SoftwareDrawing(const RenderScene& scene);

  /// Returns the number of all pieces that may be visible, and of their triangles.
  DrawCount draw(const Stage& stage, const Projection& wanted, const sensors::Layers& layers, double ahead,
                 sensors::View& into);

 private:
  struct Picture;
  void draw_part(const Stage& stage, const FarEye& eye, const sensors::Layers& layers, double ahead,
                 const Samples* samples, sensors::View& into);
  void begin(const Picture& picture, bool strokes, double ahead);
  void draw_solids(const Picture& picture);
  void draw_scenery(const Picture& picture, const LookSurface& surface, Surface::Kind kind);
  void draw_nets(const Picture& picture);
  void paint_row(const Picture& picture, int v, imaging::ColorImage& into);
  void paint_background(const Picture& picture, int v);
  void paint_solids(const Picture& picture, int v);
  void lay_nets(const Picture& picture, int v);
  void lay_clear(const Picture& picture, imaging::ColorImage& into);
  void measure_row(const Picture& picture, const sensors::Layers& layers, int v, sensors::View& into);
  void measure_clear(const Picture& picture, const sensors::Layers& layers, sensors::View& into);

  const RenderScene& scene_;
  MeshCatalog catalog_;
  InstanceList list_;
  SeenSolids solids_;
  std::vector<SeenCorner> corners_;
  SurfaceBuffer surfaces_;
  GroundShading ground_;
  RowColors colors_;
  std::vector<float> through_nets_;     // [1] share of light that passes the nets, by pixel
  std::vector<std::uint8_t> has_nets_;  // by row that is drawn
  std::size_t net_stride_ = 0;
  sensors::View fine_;  // with several samples to a pixel, where edges are
};

}  // namespace murosimf::render::software
