// What is only looked at: contact shadows, walls, sky and nets.
#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/contact_shadows.h"
#include "murosimf/render/opengl/gl_matrix.h"
#include "murosimf/render/opengl/gl_objects.h"
#include "murosimf/render/opengl/gl_uniforms.h"

namespace murosimf::render {
namespace {

void add_corners(const ContactShadow& shadow, const sensors::Perspective& view, std::vector<ContactCorner>& corners) {
  const double x = shadow.half_length + shadow.reach, y = shadow.half_width + shadow.reach;
  const Vec3d across{-shadow.along.y, shadow.along.x, 0};
  for (const auto& [u, v] :
       {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
    const Vec3d place = shadow.middle + (u * x) * shadow.along + (v * y) * across;
    corners.push_back({floats(transposed_times(view.axes, place - view.eye)),
                       {static_cast<float>(u * x), static_cast<float>(v * y)},
                       {static_cast<float>(shadow.half_length), static_cast<float>(shadow.half_width),
                        static_cast<float>(shadow.reach), static_cast<float>(shadow.darkness)}});
  }
}

}  // namespace

/// Makes what all programs with patterns share, and follows a change of light.
void GlDrawing::prepare_look(const RendererOptions& options) {
  Objects& objects = *objects_;
  if (!objects.scenery) {
    objects.scenery.emplace();
    fill_pile(*objects.pile);
    objects.nets.fill(hanging_nets(render_scene_.nets()));
  }
  if (objects.light == options.light_number) return;
  objects.light = options.light_number;
  objects.numbers = look_numbers(options.light, render_scene_.markings());
  objects.walls.fill(hall_walls(options.light.surroundings, render_scene_.markings()));
  objects.ceiling.fill(hall_ceiling(options.light.surroundings, render_scene_.markings()));
  for (GlProgram* program : objects.scenery->all()) {
    program->use();
    set(*program, objects.numbers);
    glUniform1i(program->uniform("pile"), 1);
  }
}

/// Darkens the ground below what is close to it.
void GlDrawing::draw_contacts(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                              const RendererOptions& options, double ahead, GlTarget& to) {
  const sensors::Perspective& view = projection.window;
  const bool from_above = projection.parallel ? view.axes.z.z < -0.05 : view.eye.z > 0;
  if (!from_above) return;
  std::vector<ContactCorner>& corners = objects_->contact_corners;
  corners.clear();
  for (const ContactShadow& shadow : contact_shadows(render_scene_, ahead, view.without)) {
    add_corners(shadow, view, corners);
  }
  if (corners.empty()) return;
  to.draw_layers({true, false, false});
  GlProgram& program = objects_->scenery->contact;
  set_light(program, projection, clip, options);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_ALWAYS);
  glEnablei(GL_BLEND, 0);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  objects_->contacts.draw(corners);
  glDisablei(GL_BLEND, 0);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glEnable(GL_CULL_FACE);
  to.draw_layers(layers);
}

/// Draws one surface in the world by its program.
void GlDrawing::draw_surface(GlProgram& program, SurfaceBuffers& surface, const Projection& projection,
                             const GlMatrix& clip) {
  const sensors::Perspective& view = projection.window;
  program.use();
  set(program, "clip", clip);
  set(program, "to_optical", matrix_of(transpose(view.axes), transposed_times(view.axes, -1.0 * view.eye)));
  surface.draw();
}

/// Draws the sky behind everything.
void GlDrawing::draw_sky(const Projection& projection) {
  const sensors::Perspective& view = projection.window;
  GlProgram& program = objects_->scenery->sky;
  program.use();
  glUniform4f(program.uniform("window"), static_cast<float>(0.5 * (view.left + view.right)),
              static_cast<float>(0.5 * (view.top + view.bottom)), static_cast<float>(0.5 * (view.right - view.left)),
              static_cast<float>(0.5 * (view.bottom - view.top)));
  const std::array<Float3, 3> axes{floats(view.axes.x), floats(view.axes.y), floats(view.axes.z)};
  glUniformMatrix3fv(program.uniform("to_world"), 1, GL_FALSE, axes.front().data());
  glDisable(GL_CULL_FACE);
  glDepthFunc(GL_LEQUAL);
  objects_->whole.draw();
  glDepthFunc(GL_LESS);
  glEnable(GL_CULL_FACE);
}

/// Draws walls or sky, then nets over all that is behind them. Parallel rays come from outside of any hall.
void GlDrawing::draw_scenery(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                             const RendererOptions& options, GlTarget& to) {
  SceneryPrograms& programs = *objects_->scenery;
  to.draw_layers({true, false, false});
  glDepthMask(GL_FALSE);
  if (!projection.parallel) {
    const Surroundings::Kind kind = options.light.surroundings.kind;
    if (kind == Surroundings::Kind::outdoors) draw_sky(projection);
    if (kind == Surroundings::Kind::hall) {
      draw_surface(programs.wall, objects_->walls, projection, clip);
      draw_surface(programs.ceiling, objects_->ceiling, projection, clip);
    }
  }
  if (objects_->nets.count > 0) {
    glDisable(GL_CULL_FACE);
    glEnablei(GL_BLEND, 0);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    programs.net.use();
    set(programs.net, "in_light", floats(shown_in(thread, brightness_upwards(options.light, true))));
    draw_surface(programs.net, objects_->nets, projection, clip);
    glDisablei(GL_BLEND, 0);
    glEnable(GL_CULL_FACE);
  }
  glDepthMask(GL_TRUE);
  to.draw_layers(layers);
}

}  // namespace murosimf::render
