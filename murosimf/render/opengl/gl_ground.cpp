// The ground of a view: floor, field and strokes.
#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/opengl/gl_matrix.h"
#include "murosimf/render/opengl/gl_objects.h"
#include "murosimf/render/opengl/gl_uniforms.h"

namespace murosimf::render {
namespace {

/// A corner of a rectangle: optical frame, and on the ground.
struct GroundCorner {
  Float3 place;
  std::array<float, 2> where;
};

/// Sets the displayed color of the ground, with and without the lamp that casts shadows.
void set_ground_color(GlProgram& program, const Color& color, const Light& light) {
  set(program, "in_light", floats(shown_in(color, brightness_upwards(light, true))));
  set(program, "in_shade", floats(shown_in(color, brightness_upwards(light, false))));
}

}  // namespace

/// Draws the ground. Floor, field and lines lie in one plane, so their order decides, not the depth.
void GlDrawing::draw_ground(const Projection& projection, const sensors::Layers& layers, const Light& light,
                            GlTarget& to) {
  const sensors::Perspective& view = projection.window;
  const double downwards = -view.axes.z.z;
  const bool is_cut = projection.parallel && std::abs(downwards) <= level_sine;
  if (!is_cut && !(projection.parallel ? downwards > 0 : view.eye.z > 0)) return;
  if (projection.parallel) glEnable(GL_DEPTH_CLAMP);  // the depths are those of the pieces; the ground reaches farther
  glDepthFunc(GL_ALWAYS);
  if (is_cut) {
    draw_earth(view, light);
  } else {
    draw_areas(projection, layers, light, to);
    glDepthMask(GL_FALSE);
    if (layers.color || layers.labels) draw_strokes(projection, layers, light, to);
    glDepthMask(GL_TRUE);
  }
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_CLAMP);
}

/// Draws floor and field.
void GlDrawing::draw_areas(const Projection& projection, const sensors::Layers& layers, const Light& light,
                           GlTarget& to) {
  const sensors::Perspective& view = projection.window;
  PatternPrograms* patterns = objects_->patterns;
  const auto rectangle = [&](double x, double y, double half_length, double half_width, const Color& color,
                             GlProgram& program) {
    std::array<Vec3d, 4> places;
    for (int i = 0; i < 4; ++i) {
      const double sx = i == 1 || i == 3 ? 1 : -1, sy = i < 2 ? -1 : 1;
      const Vec3d p{x + sx * half_length, y + sy * half_width, 0};
      places[static_cast<std::size_t>(i)] = p;
    }
    draw_rectangle(places, view, color, light, program);
  };
  // The point of the ground below the eye, or in the middle of a parallel picture.
  const Vec3d middle = projection.parallel ? view.eye - (view.eye.z / view.axes.z.z) * view.axes.z : view.eye;
  rectangle(middle.x, middle.y, floor_reach, floor_reach, light.surroundings.floor, objects_->lit->ground);
  const Markings* markings = render_scene_.markings();
  if (patterns) {
    // Once more with its pattern, where the field does not cover it: patterns cost much where the processor draws.
    to.draw_layers({true, false, false});
    glDepthMask(GL_FALSE);
    const double length = markings ? markings->half_length : 0, width = markings ? markings->half_width : 0;
    for (const double side : {-0.5, 0.5}) {
      rectangle(side * (floor_reach + length), 0, 0.5 * (floor_reach - length), floor_reach, light.surroundings.floor,
                patterns->floor);
      rectangle(0, side * (floor_reach + width), length, 0.5 * (floor_reach - width), light.surroundings.floor,
                patterns->floor);
    }
    glDepthMask(GL_TRUE);
    to.draw_layers(layers);
  }
  if (!markings) return;
  rectangle(0, 0, markings->half_length, markings->half_width, light.field.grass,
            patterns ? patterns->lawn : objects_->lit->ground);
}

/// Draws the ground seen level: all below its edge, behind everything.
void GlDrawing::draw_earth(const sensors::Perspective& view, const Light& light) {
  // -z of the world is mostly y of the picture, or else x.
  const Vec3d down = transposed_times(view.axes, Vec3d{0, 0, -1});
  const Vec3d deep = (1 / std::hypot(down.x, down.y)) * Vec3d{down.x, down.y, 0}, along{deep.y, -deep.x, 0};
  const Vec3d edge = Vec3d{0, 0, floor_reach} + view.eye.z * deep;
  const Vec3d side = floor_reach * along, below = floor_reach * deep;
  std::array<Vec3d, 4> places{edge - side + below, edge + side + below, edge - side, edge + side};
  for (Vec3d& place : places) place = view.eye + view.axes * place;
  draw_rectangle(places, view, light.surroundings.floor, light, objects_->lit->ground);
}

/// Draws a rectangle. `corners` [m] world, in the order of a strip.
void GlDrawing::draw_rectangle(const std::array<Vec3d, 4>& corners, const sensors::Perspective& view,
                               const Color& color, const Light& light, GlProgram& program) {
  program.use();
  glBindVertexArray(*objects_->ground_array);
  glBindBuffer(GL_ARRAY_BUFFER, *objects_->ground_buffer);
  std::array<GroundCorner, 4> places{};
  std::ranges::transform(corners, places.begin(), [&](const Vec3d& corner) {
    return GroundCorner{floats(transposed_times(view.axes, corner - view.eye)),
                        {static_cast<float>(corner.x), static_cast<float>(corner.y)}};
  });
  glBufferData(GL_ARRAY_BUFFER, sizeof(places), places.data(), GL_STREAM_DRAW);
  attribute(0, 3, GL_FLOAT, sizeof(GroundCorner), offsetof(GroundCorner, place), false);
  attribute(1, 2, GL_FLOAT, sizeof(GroundCorner), offsetof(GroundCorner, where), false);
  set_ground_color(program, color, light);
  glUniform1ui(program.uniform("what"), sensors::label_ground);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void GlDrawing::draw_strokes(const Projection& projection, const sensors::Layers& layers, const Light& light,
                             GlTarget& to) {
  glDisable(GL_CULL_FACE);  // the rectangles of a stroke have no common orientation
  glBindVertexArray(*objects_->strokes.array);
  if (layers.color) {
    to.draw_layers({true, false, false});
    glEnablei(GL_BLEND, 0);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw_strokes_by(objects_->patterns ? objects_->patterns->painted : objects_->lit->stroke, projection, light, 0);
    glDisablei(GL_BLEND, 0);
  }
  if (layers.labels) {
    to.draw_layers({false, false, true});
    draw_strokes_by(objects_->lit->stroke, projection, light, 0.5);
  }
  to.draw_layers(layers);
  glEnable(GL_CULL_FACE);
}

/// `least`: cover below which nothing is drawn.
void GlDrawing::draw_strokes_by(GlProgram& program, const Projection& projection, const Light& light, double least) {
  const sensors::Perspective& view = projection.window;
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
  set_ground_color(program, light.field.paint, light);
  glUniform1ui(program.uniform("what"), sensors::label_line);
  set(program, "least", least);
  glDrawArrays(GL_TRIANGLES, 0, objects_->strokes.count);
}

}  // namespace murosimf::render
