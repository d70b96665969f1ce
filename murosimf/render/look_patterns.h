/// look_patterns.h - the patterns of materials as functions in GLSL, in what OpenGL 3.3 and WebGL 2 have in common: one text for all renderers.
#pragma once

#include <string_view>

namespace murosimf::render {

/// Declares the uniforms of look_numbers(). Lengths in m, colors as they are shown (sRGB). `f` is the
/// footprint of a pixel: patterns are means over it (box filter), so that they do not alias.
extern const std::string_view look_patterns;
/// One of these follows: pile by the texture `pile` of look.h, or by numbers mixed in place, which costs a software driver a tenth of that.
/// Source: an arithmetic hash of the number of a cell, as usual in shaders; its mean over a pixel is taken as 0 as cells get small.
extern const std::string_view fine_pile, quick_pile;

}  // namespace murosimf::render
