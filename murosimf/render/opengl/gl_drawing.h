/// gl_drawing.h - draws views of a scene in one OpenGL context.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "murosimf/render/instances.h"
#include "murosimf/render/opengl/gl_context.h"
#include "murosimf/render/opengl/gl_matrix.h"
#include "murosimf/render/opengl/gl_target.h"
#include "murosimf/render/renderer.h"

namespace murosimf::render {

class GlProgram;
struct SurfaceBuffers;

class GlDrawing {
 public:
  /// Throws SetupError: no device, or one without the necessary features.
  explicit GlDrawing(const RenderScene& render_scene);
  ~GlDrawing();
  GlDrawing(const GlDrawing&) = delete;
  GlDrawing& operator=(const GlDrawing&) = delete;

  [[nodiscard]] const GlContext& context() const { return context_; }
  /// Draws a view. Throws SetupError if the picture is too large for the device.
  DrawCount draw(const Projection& wanted, const sensors::Layers& layers, const RendererOptions& options, double ahead,
                 sensors::View& into);

 private:
  struct Objects;  // objects of the context; made and removed while it is current

  void prepare(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
               const RendererOptions& options);
  void prepare_look(const RendererOptions& options);
  void set_light(GlProgram& program, const Projection& projection, const GlMatrix& clip,
                 const RendererOptions& options);
  void draw_scene(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                  const RendererOptions& options, double ahead, GlTarget& to);
  void draw_ground(const Projection& projection, const sensors::Layers& layers, const Light& light, GlTarget& to);
  void draw_areas(const Projection& projection, const sensors::Layers& layers, const Light& light, GlTarget& to);
  void draw_earth(const sensors::Perspective& view, const Light& light);
  void draw_rectangle(const std::array<Vec3d, 4>& corners, const sensors::Perspective& view, const Color& color,
                      const Light& light, GlProgram& program);
  void draw_strokes(const Projection& projection, const sensors::Layers& layers, const Light& light, GlTarget& to);
  void draw_strokes_by(GlProgram& program, const Projection& projection, const Light& light, double least);
  void draw_contacts(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                     const RendererOptions& options, double ahead, GlTarget& to);
  void draw_scenery(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                    const RendererOptions& options, GlTarget& to);
  void draw_sky(const Projection& projection);
  void draw_surface(GlProgram& program, SurfaceBuffers& surface, const Projection& projection, const GlMatrix& clip);
  void draw_pieces(std::span<const InstanceGroup> groups);
  void draw_clear(const sensors::Layers& layers, GlTarget& to);
  void draw_shadows(const sensors::Perspective& view, const RendererOptions& options, double ahead);
  GlTarget& target(int width, int height, int samples);

  const RenderScene& render_scene_;
  GlContext context_;
  MeshCatalog catalog_;
  InstanceList list_;
  std::unique_ptr<Objects> objects_;
};

}  // namespace murosimf::render
