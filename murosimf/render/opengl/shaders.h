/// shaders.h - the programs of the graphics device, in GLSL.
///
/// All places are in the optical frame of the view (x right, y down, z forward), so that single precision suffices at any distance of the
/// camera from the world's origin. Programs with patterns have those of look_patterns.h before them.
#pragma once

#include <string_view>

namespace murosimf::render {

/// Precedes every shader: the equation of light (light.h). Source of the polynomial: a fit to sRGB, within a quarter of 1/255.
extern const std::string_view light_source;
/// Precedes fragment shaders: the share of the lamp's light that reaches a place. Software drivers execute both sides
/// of a branch, so there is one source for each.
extern const std::string_view shadow_source, soft_shadow_source, no_shadow_source;

/// Pieces: unit solids, scaled, turned and moved by instance.
extern const std::string_view solid_vertex, solid_fragment;
/// Precedes both of these for pieces that show a picture.
extern const std::string_view with_picture;
/// Balls with panels, with patterns.
extern const std::string_view ball_fragment;
/// The same for the lamp's view: nothing but depth.
extern const std::string_view shade_fragment;
/// The ground: plain rectangles; with patterns the field and the floor around it.
extern const std::string_view ground_vertex, ground_fragment, lawn_fragment, floor_fragment;
/// Strokes painted on the ground. A pixel shows as much of a stroke as the box filter of its footprint covers. With patterns their edges
/// are ragged inwards; such ones have colors only.
extern const std::string_view stroke_vertex, stroke_fragment, painted_fragment;

// Only looked at: colors alone, with patterns but for contacts.
/// Shadows on the ground below what is close to it.
extern const std::string_view contact_vertex, contact_fragment;
/// Surfaces of look.h.
extern const std::string_view surface_vertex, wall_fragment, ceiling_fragment, net_fragment;
/// The sky behind everything.
extern const std::string_view sky_vertex, sky_fragment;

}  // namespace murosimf::render
