#include "murosimf/render/opengl/gl_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/render/opengl/gl_matrix.h"
#include "murosimf/render/opengl/gl_objects.h"
#include "murosimf/render/opengl/gl_uniforms.h"

namespace murosimf::render {
namespace {

constexpr std::size_t most_targets = 8;

}  // namespace

GlDrawing::GlDrawing(const RenderScene& render_scene)
    : render_scene_(render_scene), catalog_(solid_catalog(render_scene.meshes())) {
  const GlContext::Current current(context_);
  objects_ = std::make_unique<Objects>();
  objects_->meshes.fill(catalog_);
  objects_->pictures.fill(catalog_);
  if (render_scene.markings()) objects_->strokes.fill(*render_scene.markings());
}

GlDrawing::~GlDrawing() {
  const GlContext::Current current(context_);
  objects_.reset();
}

GlTarget& GlDrawing::target(int width, int height, int samples) {
  MUROSIMF_ASSERT(width > 0 && height > 0 && samples >= 1);
  auto& targets = objects_->targets;
  const auto known =
      std::find_if(targets.begin(), targets.end(), [&](const GlTarget& t) { return t.fits(width, height, samples); });
  if (known != targets.end()) {
    targets.splice(targets.begin(), targets, known);
  } else {
    targets.emplace_front(width, height, samples);
    if (targets.size() > most_targets) targets.pop_back();  // the least recently used one
  }
  return targets.front();
}

DrawCount GlDrawing::draw(const Projection& wanted, const sensors::Layers& layers, const RendererOptions& options,
                          double ahead, sensors::View& into) {
  const GlContext::Current current(context_);
  Projection projection = wanted;
  sensors::Perspective& view = projection.window;
  const Light& light = options.light;
  const int samples = options.samples;
  if (view.rows == 0) view.rows = view.height - view.first_row;
  MUROSIMF_ASSERT(view.first_row >= 0 && view.rows > 0 && view.first_row + view.rows <= view.height);
  if (light.shadows && layers.color) draw_shadows(view, options, ahead);
  list_.fill(render_scene_, projection, layers.depth, ahead, catalog_);
  const GlMatrix clip =
      projection.parallel ? parallel_clip_of(view, render_scene_, ahead) : clip_of(view, nearest_drawn);
  // Several samples to a pixel apply to colors only: a mean of depths or labels is meaningless.
  std::vector<std::pair<sensors::Layers, int>> passes{{layers, 1}};
  if (samples > 1 && layers.color) {
    passes = {{{true, false, false}, samples}};
    if (layers.depth || layers.labels) passes.push_back({{false, layers.depth, layers.labels}, 1});
  }
  for (const auto& [part, count] : passes) {
    GlTarget& to = target(view.width, view.height, count);
    to.begin(view, part, light.background);
    draw_scene(projection, clip, part, options, ahead, to);
    to.read(view, part, into);
  }
  DrawCount drawn{list_.instances().size(), 0};
  for (const InstanceGroup& group : list_.groups()) {
    drawn.triangles += group.count * catalog_.meshes[group.solid].triangle_count();
  }
  return drawn;
}

/// Sets what programs with light need to know of the view.
void GlDrawing::set_light(GlProgram& program, const Projection& projection, const GlMatrix& clip,
                          const RendererOptions& options) {
  const sensors::Perspective& view = projection.window;
  const Light& light = options.light;
  const Mat3d to_optical = transpose(view.axes);
  const std::array<Lamp, 3> lamps{Lamp{light.toward, light.lamp}, light.others[0], light.others[1]};
  std::array<Float3, 3> toward{}, lamp{};
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    toward[i] = floats((1 / norm(lamps[i].toward)) * (to_optical * lamps[i].toward));
    lamp[i] = floats(lamps[i].lamp);
  }
  program.use();
  set(program, "clip", clip);
  set(program, "up", floats(to_optical.z));
  glUniform3fv(program.uniform("toward"), 3, toward.front().data());
  glUniform3fv(program.uniform("lamp"), 3, lamp.front().data());
  set(program, "sky", floats(light.sky));
  set(program, "earth", floats(light.ground));
  set(program, "gloss", light.gloss);
  set(program, "eye_height", view.eye.z);
  set(program, "eye_behind", projection.parallel ? 1e6 : 0.0);
  set(program, "grounded", options.ground && light.patterns ? ground_darkness : 0);
  set(program, "pool_center", floats(transposed_times(view.axes, -1.0 * view.eye)));
  set(program, "pool_size", light.pool > 0 ? 1 / (light.pool * light.pool) : 0);
  if (!objects_->shadows) return;
  const ShadowMap& shadows = *objects_->shadows;
  set(program, "to_lamp", shadows.to_lamp);
  set(program, "shadow_gap", 1.5 * shadows.texel);
  set(program, "softness", soft_edge / (2 * shadows.half_side));
}

/// Chooses the programs of this pass, and sets their numbers.
void GlDrawing::prepare(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                        const RendererOptions& options) {
  const bool shaded = options.light.shadows && layers.color, fine = options.fine;
  Objects& objects = *objects_;
  objects.lit = &objects.lit_programs.of(shaded, fine);
  for (GlProgram* program : objects.lit->all()) set_light(*program, projection, clip, options);
  objects.pictured = objects.pictures.empty() ? nullptr : &objects.pictured_programs.of(shaded, fine);
  if (objects.pictured) {
    set_light(objects.pictured->solid, projection, clip, options);
    glUniform1i(objects.pictured->solid.uniform("picture"), 2);
  }
  objects.patterns = nullptr;
  if (options.light.patterns && layers.color) {
    prepare_look(options);
    objects.patterns = &objects.pattern_programs.of(shaded, fine, fine ? fine_pile : quick_pile);
    const bool news = objects.patterns->light != options.light_number;
    objects.patterns->light = options.light_number;
    for (GlProgram* program : objects.patterns->all()) {
      set_light(*program, projection, clip, options);
      if (news) set(*program, objects.numbers);
      glUniform1i(program->uniform("pile"), 1);
    }
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, *objects.pile);
  }
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, shaded ? *objects.shadows->texture : 0);
}

void GlDrawing::draw_scene(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                           const RendererOptions& options, double ahead, GlTarget& to) {
  prepare(projection, clip, layers, options);
  glFrontFace(GL_CW);  // rows count downwards
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glEnable(GL_DEPTH_TEST);
  if (options.ground) draw_ground(projection, layers, options.light, to);
  const bool looked_at = objects_->patterns != nullptr && options.ground;
  if (looked_at) draw_contacts(projection, clip, layers, options, ahead, to);
  const auto solids = list_.solid_groups();
  const std::size_t balls = objects_->patterns ? list_.ball_groups() : 0;
  objects_->meshes.load(list_.instances());
  draw_pieces(solids.first(solids.size() - balls));
  if (balls > 0) {
    objects_->patterns->ball.use();
    objects_->meshes.draw(solids.last(balls));
  }
  if (looked_at) draw_scenery(projection, clip, layers, options, to);
  if (!list_.clear_groups().empty()) draw_clear(layers, to);
}

/// Draws pieces in their order, by the program that each needs.
void GlDrawing::draw_pieces(std::span<const InstanceGroup> groups) {
  const auto picture_of = [&](const InstanceGroup& group) { return catalog_.meshes[group.solid].picture.get(); };
  while (!groups.empty()) {
    const imaging::MipPicture* picture = picture_of(groups.front());
    const auto end = std::ranges::find_if(groups, [&](const auto& group) { return picture_of(group) != picture; });
    const auto count = static_cast<std::size_t>(end - groups.begin());
    if (picture) {
      objects_->pictured->solid.use();
      glActiveTexture(GL_TEXTURE2);
      objects_->pictures.bind(picture);
      glActiveTexture(GL_TEXTURE0);
    } else {
      objects_->lit->solid.use();
    }
    objects_->meshes.draw(groups.first(count));
    groups = groups.subspan(count);
  }
}

/// Draws transparent pieces: colors blend over those that are there; depths and labels replace them.
void GlDrawing::draw_clear(const sensors::Layers& layers, GlTarget& to) {
  if (layers.color) {
    to.draw_layers({true, false, false});
    glDepthMask(GL_FALSE);  // pieces behind one another must all contribute
    glEnablei(GL_BLEND, 0);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_pieces(list_.clear_groups());
    glDisablei(GL_BLEND, 0);
    glDepthMask(GL_TRUE);
  }
  if (layers.depth || layers.labels) {
    to.draw_layers({false, layers.depth, layers.labels});
    draw_pieces(list_.clear_groups());
  }
  to.draw_layers(layers);
}

/// Draws the shadow map: the lamp looks along its light, in parallel, at all that casts shadows.
void GlDrawing::draw_shadows(const sensors::Perspective& view, const RendererOptions& options, double ahead) {
  const Light& light = options.light;
  if (!objects_->shadows) objects_->shadows.emplace(options.shadow_side);
  ShadowMap& map = *objects_->shadows;
  const LampView lamp = lamp_view(render_scene_, light.toward, ahead);
  map.half_side = std::max(lamp.half_width, lamp.half_height);
  map.texel = 2 * map.half_side / map.side;
  const GlMatrix clip = clip_of(lamp);
  // From optical axes to those of the lamp, then to its picture, 0 to 1.
  const Mat3d turn = transpose(lamp.axes) * view.axes;
  const Vec3d shift = transposed_times(lamp.axes, view.eye - lamp.eye);
  map.to_lamp = half_and_half() * (clip * matrix_of(turn, shift));
  list_.fill_all(render_scene_, lamp.eye, lamp.axes, ahead, catalog_);
  if (map.remember(list_.instances(), clip)) return;  // drawn for another view of this instant
  glBindFramebuffer(GL_FRAMEBUFFER, *map.frame);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, map.side, map.side);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glFrontFace(GL_CW);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);  // the far sides cast them: near ones cannot darken themselves
  objects_->shade.use();
  set(objects_->shade, "clip", clip);
  objects_->meshes.load(list_.instances());
  objects_->meshes.draw(list_.solid_groups());
  map.is_drawn = true;
}

}  // namespace murosimf::render
