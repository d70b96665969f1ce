/// shaders.h - the programs that the graphics device runs, in GLSL.
///
/// All places are in the optical frame of the view (x right, y down, z forward), so single precision is enough however
/// far from the world's origin the camera is.
#pragma once

#include <string_view>

namespace murosimf::render {

/// Stands before every shader: what light does (light.h).
extern const std::string_view light_source;
/// Stands before fragment shaders: how much of the lamp's light comes to a place. Software drivers work out both sides
/// of a branch, so there is one for each.
extern const std::string_view shadow_source, no_shadow_source;

/// Pieces: unit solids, scaled, turned and moved by instance.
extern const std::string_view solid_vertex, solid_fragment;
/// The same for the lamp's view: nothing but depth.
extern const std::string_view shade_fragment;
/// The ground: plain rectangles.
extern const std::string_view ground_vertex, ground_fragment;
/// Strokes painted on the ground. A pixel shows as much of a stroke as the box filter of its footprint covers.
extern const std::string_view stroke_vertex, stroke_fragment;

}  // namespace murosimf::render
