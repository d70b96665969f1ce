/// shaders.h - the programs of the graphics device, in GLSL.
///
/// All places are in the optical frame of the view (x right, y down, z forward), so that single precision suffices at any distance of the
/// camera from the world's origin.
#pragma once

#include <string_view>

namespace murosimf::render {

/// Precedes every shader: the equation of light (light.h).
extern const std::string_view light_source;
/// Precedes fragment shaders: the share of the lamp's light that reaches a place. Software drivers execute both sides
/// of a branch, so there is one source for each.
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
