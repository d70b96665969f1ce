/// gl_objects.h - everything that a context draws with.
///
/// Only for the .cpp files of this folder: it brings OpenGL in.
#pragma once

#include <array>
#include <list>
#include <optional>
#include <string_view>
#include <vector>

#include "murosimf/render/look.h"
#include "murosimf/render/opengl/gl_drawing.h"
#include "murosimf/render/opengl/gl_meshes.h"
#include "murosimf/render/opengl/gl_pictures.h"
#include "murosimf/render/opengl/gl_programs.h"
#include "murosimf/render/opengl/gl_scenery.h"
#include "murosimf/render/opengl/gl_shadow_map.h"
#include "murosimf/render/opengl/gl_strokes.h"

namespace murosimf::render {

/// One set of programs for each kind of shadows and, if `More` says so, of pile; made when first used.
template <class Programs, class... More>
struct ByShadow {
  Programs& of(bool shaded, bool fine, const More&... more) {
    std::optional<Programs>& wanted = all[(shaded ? 2 : 0) + (fine ? 1 : 0)];
    if (!wanted) wanted.emplace(!shaded ? no_shadow_source : fine ? soft_shadow_source : shadow_source, more...);
    return *wanted;
  }
  std::array<std::optional<Programs>, 4> all;
};

struct GlDrawing::Objects {
  ByShadow<LitPrograms> lit_programs;
  ByShadow<PicturedPrograms> pictured_programs;
  ByShadow<PatternPrograms, std::string_view> pattern_programs;
  LitPrograms* lit = nullptr;            // the programs of this picture
  PicturedPrograms* pictured = nullptr;  // null: no piece shows a picture
  PatternPrograms* patterns = nullptr;   // null: without patterns
  GlProgram shade{{light_source, solid_vertex}, {shade_fragment}};
  std::optional<SceneryPrograms> scenery;  // made when first used, as all below
  std::vector<LookNumber> numbers;         // of the light
  int light = -1;                          // RendererOptions::light_number of the numbers, and of the surfaces
  GlTexture pile;
  SurfaceBuffers walls, ceiling, nets;
  WholePicture whole;
  ContactBuffers contacts;
  std::vector<ContactCorner> contact_corners;
  MeshBuffers meshes;
  PictureTextures pictures;
  StrokeBuffers strokes;
  GlVertexArray ground_array;
  GlBuffer ground_buffer;
  std::optional<ShadowMap> shadows;
  std::list<GlTarget> targets;  // most recently used first
};

}  // namespace murosimf::render
