#include "murosimf/render/opengl/gl_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <list>
#include <optional>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/render/opengl/gl_matrix.h"
#include "murosimf/render/opengl/gl_meshes.h"
#include "murosimf/render/opengl/gl_strokes.h"
#include "murosimf/render/opengl/shaders.h"

namespace murosimf::render {
namespace {

constexpr Color grass{0.21, 0.50, 0.24}, floor_color{0.48, 0.48, 0.47}, paint{0.93, 0.94, 0.93};
constexpr double floor_reach = 500;  // [m]
constexpr double nearest = 0.01;     // [m]
constexpr double flattest = 0.01;    // [1] sine of the lowest elevation from which parallel rays see the ground
constexpr std::size_t most_targets = 8;

using Float3 = std::array<float, 3>;

Float3 floats(const Vec3d& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }
Float3 floats(const Color& c) {
  return {static_cast<float>(c.red), static_cast<float>(c.green), static_cast<float>(c.blue)};
}

void set(GlProgram& program, const char* name, const Float3& v) { glUniform3fv(program.uniform(name), 1, v.data()); }
void set(GlProgram& program, const char* name, double v) { glUniform1f(program.uniform(name), static_cast<float>(v)); }
void set(GlProgram& program, const char* name, const GlMatrix& m) {
  glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, m.data());
}

/// Sets the displayed color of the ground, by the equation of the solids' shader (shaders.cpp), with and without the lamp.
void set_ground_color(GlProgram& program, const Color& color, const Light& light) {
  const double lamp = std::max(0.0, light.toward.z / norm(light.toward));
  const auto shown = [&](double share) {
    const auto one = [&](double base, double sky, double from_lamp) {
      return std::sqrt(std::clamp(base * base * (sky + share * from_lamp), 0.0, 1.0));
    };
    return floats(Color{one(color.red, light.sky.red, lamp * light.lamp.red),
                        one(color.green, light.sky.green, lamp * light.lamp.green),
                        one(color.blue, light.sky.blue, lamp * light.lamp.blue)});
  };
  set(program, "in_light", shown(1));
  set(program, "in_shade", shown(0));
}

/// Depths seen from the lamp: the reach of its light.
struct ShadowMap {
  explicit ShadowMap(int pixels) : side(pixels) {
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    constexpr std::array<GLfloat, 4> lit{1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit.data());
    for (const auto& [key, value] : {std::pair<GLenum, GLint>{GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER},
                                     {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER},
                                     {GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                     {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                     {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                     {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}}) {
      glTexParameteri(GL_TEXTURE_2D, key, value);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, *frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, *texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }

  int side;  // [px]
  GlTexture texture;
  GlFramebuffer frame;
  GlMatrix to_lamp{};
  double texel = 0;  // [m]
};

/// The programs that use the light, with or without shadows.
struct LitPrograms {
  explicit LitPrograms(std::string_view shadows)
      : solid({light_source, solid_vertex}, {light_source, shadows, solid_fragment}),
        ground({light_source, ground_vertex}, {light_source, shadows, ground_fragment}),
        stroke({light_source, stroke_vertex}, {light_source, shadows, stroke_fragment}) {}
  GlProgram solid, ground, stroke;
};

}  // namespace

struct GlDrawing::Objects {
  LitPrograms plain{no_shadow_source};
  std::optional<LitPrograms> shadowed;  // made when first used
  LitPrograms* lit = &plain;            // the programs of this picture
  GlProgram shade{{light_source, solid_vertex}, {shade_fragment}};
  MeshBuffers meshes;
  StrokeBuffers strokes;
  GlVertexArray ground_array;
  GlBuffer ground_buffer;
  std::optional<ShadowMap> shadows;  // made when first used
  std::list<GlTarget> targets;       // most recently used first
};

GlDrawing::GlDrawing(const RenderScene& render_scene)
    : render_scene_(render_scene), catalog_(solid_catalog(render_scene.meshes())) {
  const GlContext::Current current(context_);
  objects_ = std::make_unique<Objects>();
  objects_->meshes.fill(catalog_);
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
  const GlMatrix clip = projection.parallel ? parallel_clip_of(view, render_scene_, ahead) : clip_of(view, nearest);
  // Several samples to a pixel apply to colors only: a mean of depths or labels is meaningless.
  std::vector<std::pair<sensors::Layers, int>> passes{{layers, 1}};
  if (samples > 1 && layers.color) {
    passes = {{{true, false, false}, samples}};
    if (layers.depth || layers.labels) passes.push_back({{false, layers.depth, layers.labels}, 1});
  }
  for (const auto& [part, count] : passes) {
    GlTarget& to = target(view.width, view.height, count);
    to.begin(view, part, light.background);
    draw_scene(projection, clip, part, options, to);
    to.read(view, part, into);
  }
  DrawCount drawn{list_.instances().size(), 0};
  for (const InstanceGroup& group : list_.groups()) {
    drawn.triangles += group.count * catalog_.meshes[group.solid].triangle_count();
  }
  return drawn;
}

void GlDrawing::draw_scene(const Projection& projection, const GlMatrix& clip, const sensors::Layers& layers,
                           const RendererOptions& options, GlTarget& to) {
  const sensors::Perspective& view = projection.window;
  const Light& light = options.light;
  const Mat3d to_optical = transpose(view.axes);
  const bool shaded = light.shadows && layers.color;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, shaded ? *objects_->shadows->texture : 0);
  objects_->lit = shaded ? &*objects_->shadowed : &objects_->plain;
  for (GlProgram* program : {&objects_->lit->solid, &objects_->lit->ground, &objects_->lit->stroke}) {
    program->use();
    set(*program, "clip", clip);
    set(*program, "up", floats(to_optical.z));
    set(*program, "toward", floats((1 / norm(light.toward)) * (to_optical * light.toward)));
    set(*program, "lamp", floats(light.lamp));
    set(*program, "sky", floats(light.sky));
    set(*program, "earth", floats(light.ground));
    if (shaded) set(*program, "to_lamp", objects_->shadows->to_lamp);
    if (shaded) set(*program, "shadow_gap", 1.5 * objects_->shadows->texel);
  }
  glFrontFace(GL_CW);  // rows count downwards
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glEnable(GL_DEPTH_TEST);
  if (options.ground) draw_ground(projection, layers, light, to);
  objects_->lit->solid.use();
  objects_->meshes.load(list_.instances());
  objects_->meshes.draw(list_.solid_groups());
  if (!list_.clear_groups().empty()) draw_clear(layers, to);
}

/// Draws transparent pieces: colors blend over those that are there; depths and labels replace them.
void GlDrawing::draw_clear(const sensors::Layers& layers, GlTarget& to) {
  if (layers.color) {
    to.draw_layers({true, false, false});
    glDepthMask(GL_FALSE);  // pieces behind one another must all contribute
    glEnablei(GL_BLEND, 0);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    objects_->meshes.draw(list_.clear_groups());
    glDisablei(GL_BLEND, 0);
    glDepthMask(GL_TRUE);
  }
  if (layers.depth || layers.labels) {
    to.draw_layers({false, layers.depth, layers.labels});
    objects_->meshes.draw(list_.clear_groups());
  }
  to.draw_layers(layers);
}

/// Draws the ground. Floor, field and lines lie in one plane, so their order decides, not the depth.
void GlDrawing::draw_ground(const Projection& projection, const sensors::Layers& layers, const Light& light,
                            GlTarget& to) {
  const sensors::Perspective& view = projection.window;
  const double downwards = -view.axes.z.z;
  const bool is_cut = projection.parallel && std::abs(downwards) <= flattest;
  if (!is_cut && !(projection.parallel ? downwards > 0 : view.eye.z > 0)) return;
  if (projection.parallel) glEnable(GL_DEPTH_CLAMP);  // the depths are those of the pieces; the ground reaches farther
  glDepthFunc(GL_ALWAYS);
  if (is_cut) {
    draw_earth(view, light);
  } else {
    draw_areas(projection, light);
    glDepthMask(GL_FALSE);
    if (layers.color || layers.labels) draw_strokes(projection, layers, light, to);
    glDepthMask(GL_TRUE);
  }
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_CLAMP);
}

/// Draws floor and field.
void GlDrawing::draw_areas(const Projection& projection, const Light& light) {
  const sensors::Perspective& view = projection.window;
  const auto rectangle = [&](double x, double y, double half_length, double half_width, const Color& color) {
    std::array<Vec3d, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const double sx = i == 1 || i == 3 ? 1 : -1, sy = i < 2 ? -1 : 1;
      const Vec3d p{x + sx * half_length, y + sy * half_width, 0};
      corners[static_cast<std::size_t>(i)] = transposed_times(view.axes, p - view.eye);
    }
    draw_rectangle(corners, color, light);
  };
  // The point of the ground below the eye, or in the middle of a parallel picture.
  const Vec3d middle = projection.parallel ? view.eye - (view.eye.z / view.axes.z.z) * view.axes.z : view.eye;
  rectangle(middle.x, middle.y, floor_reach, floor_reach, floor_color);
  const Markings* markings = render_scene_.markings();
  if (markings) rectangle(0, 0, markings->half_length, markings->half_width, grass);
}

/// Draws the ground seen level: all below its edge, behind everything.
void GlDrawing::draw_earth(const sensors::Perspective& view, const Light& light) {
  // -z of the world is mostly y of the picture, or else x.
  const Vec3d down = transposed_times(view.axes, Vec3d{0, 0, -1});
  const Vec3d deep = (1 / std::hypot(down.x, down.y)) * Vec3d{down.x, down.y, 0}, along{deep.y, -deep.x, 0};
  const Vec3d edge = Vec3d{0, 0, floor_reach} + view.eye.z * deep;
  const Vec3d side = floor_reach * along, below = floor_reach * deep;
  draw_rectangle({edge - side + below, edge + side + below, edge - side, edge + side}, floor_color, light);
}

/// Draws a rectangle. `corners` [m] optical frame, in the order of a strip.
void GlDrawing::draw_rectangle(const std::array<Vec3d, 4>& corners, const Color& color, const Light& light) {
  GlProgram& program = objects_->lit->ground;
  program.use();
  glBindVertexArray(*objects_->ground_array);
  glBindBuffer(GL_ARRAY_BUFFER, *objects_->ground_buffer);
  std::array<Float3, 4> places;
  std::ranges::transform(corners, places.begin(), [](const Vec3d& corner) { return floats(corner); });
  glBufferData(GL_ARRAY_BUFFER, sizeof(places), places.data(), GL_STREAM_DRAW);
  attribute(0, 3, GL_FLOAT, sizeof(Float3), 0, false);
  set_ground_color(program, color, light);
  glUniform1ui(program.uniform("what"), sensors::label_ground);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GlDrawing::draw_strokes(const Projection& projection, const sensors::Layers& layers, const Light& light,
                             GlTarget& to) {
  const sensors::Perspective& view = projection.window;
  GlProgram& program = objects_->lit->stroke;
  program.use();
  set(program, "to_optical", matrix_of(transpose(view.axes), transposed_times(view.axes, -1.0 * view.eye)));
  set(program, "pixel", std::max((view.right - view.left) / view.width, (view.bottom - view.top) / view.height));
  // Not at the height of the ground, where a stroke would vanish and its filter divide by zero.
  Vec3d eye_place{view.eye.x, view.eye.y, std::max(view.eye.z, 0.01)};
  if (projection.parallel) {
    eye_place = -view.axes.z;
    // Straight from above, any direction points away from the eye.
    if (std::hypot(eye_place.x, eye_place.y) < 0.002) eye_place.x = 0.002;
  }
  const Float3 eye = floats(eye_place);
  glUniform4f(program.uniform("eye"), eye[0], eye[1], eye[2], projection.parallel ? 0.0F : 1.0F);
  set_ground_color(program, paint, light);
  glUniform1ui(program.uniform("what"), sensors::label_line);
  glBindVertexArray(*objects_->strokes.array);
  const auto draw = [&](double least) {
    set(program, "least", least);
    glDrawArrays(GL_TRIANGLES, 0, objects_->strokes.count);
  };
  glDisable(GL_CULL_FACE);  // the rectangles of a stroke have no common orientation
  if (layers.color) {
    to.draw_layers({true, false, false});
    glEnablei(GL_BLEND, 0);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw(0);
    glDisablei(GL_BLEND, 0);
  }
  if (layers.labels) {
    to.draw_layers({false, false, true});
    draw(0.5);
  }
  to.draw_layers(layers);
  glEnable(GL_CULL_FACE);
}

/// Draws the shadow map: the lamp looks along its light, in parallel, at all that casts shadows.
void GlDrawing::draw_shadows(const sensors::Perspective& view, const RendererOptions& options, double ahead) {
  const Light& light = options.light;
  if (!objects_->shadows) {
    objects_->shadows.emplace(options.shadow_side);
    objects_->shadowed.emplace(shadow_source);
  }
  ShadowMap& map = *objects_->shadows;
  const LampView lamp = lamp_view(render_scene_, light.toward, ahead);
  map.texel = 2 * std::max(lamp.half_width, lamp.half_height) / map.side;
  const GlMatrix clip = clip_of(lamp);
  // From optical axes to those of the lamp, then to its picture, 0 to 1.
  const Mat3d turn = transpose(lamp.axes) * view.axes;
  const Vec3d shift = transposed_times(lamp.axes, view.eye - lamp.eye);
  map.to_lamp = half_and_half() * (clip * matrix_of(turn, shift));
  list_.fill_all(render_scene_, lamp.eye, lamp.axes, ahead, catalog_);
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
}

}  // namespace murosimf::render
