/// gl_programs.h - all programs of a context.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <string_view>

#include "murosimf/render/look_patterns.h"
#include "murosimf/render/opengl/gl_handles.h"
#include "murosimf/render/opengl/shaders.h"

namespace murosimf::render {

/// The programs that use the light, for one kind of shadows.
struct LitPrograms {
  explicit LitPrograms(std::string_view shadows)
      : solid({light_source, solid_vertex}, {light_source, shadows, solid_fragment}),
        ground({light_source, ground_vertex}, {light_source, shadows, ground_fragment}),
        stroke({light_source, stroke_vertex}, {light_source, shadows, stroke_fragment}) {}
  GlProgram solid, ground, stroke;
  [[nodiscard]] std::array<GlProgram*, 3> all() { return {&solid, &ground, &stroke}; }
};

/// Pieces that show a picture, likewise.
struct PicturedPrograms {
  explicit PicturedPrograms(std::string_view shadows)
      : solid({light_source, with_picture, solid_vertex}, {light_source, shadows, with_picture, solid_fragment}) {}
  GlProgram solid;
};

/// With patterns.
struct PatternPrograms {
  PatternPrograms(std::string_view shadows, std::string_view pile)
      : ball({light_source, solid_vertex}, {light_source, look_patterns, pile, shadows, ball_fragment}),
        lawn({light_source, ground_vertex}, {light_source, look_patterns, pile, shadows, lawn_fragment}),
        floor({light_source, ground_vertex}, {light_source, look_patterns, pile, shadows, floor_fragment}),
        painted({light_source, stroke_vertex}, {light_source, look_patterns, pile, shadows, painted_fragment}) {}
  GlProgram ball, lawn, floor, painted;
  int light = -1;  // RendererOptions::light_number whose numbers are set
  [[nodiscard]] std::array<GlProgram*, 4> all() { return {&ball, &lawn, &floor, &painted}; }
};

/// What is only looked at.
struct SceneryPrograms {
  GlProgram contact{{light_source, contact_vertex}, {contact_fragment}};
  GlProgram wall{{light_source, surface_vertex}, {look_patterns, quick_pile, wall_fragment}};
  GlProgram ceiling{{light_source, surface_vertex}, {look_patterns, quick_pile, ceiling_fragment}};
  GlProgram net{{light_source, surface_vertex}, {look_patterns, quick_pile, net_fragment}};
  GlProgram sky{{sky_vertex}, {look_patterns, quick_pile, sky_fragment}};
  int light = -1;
  [[nodiscard]] std::array<GlProgram*, 5> all() { return {&contact, &wall, &ceiling, &net, &sky}; }
};

}  // namespace murosimf::render
