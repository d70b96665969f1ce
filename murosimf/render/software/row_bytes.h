/// row_bytes.h - colors of a row as bytes of a picture.
#pragma once

#include <span>

#include "murosimf/imaging/image.h"
#include "murosimf/render/software/ground_shading.h"

namespace murosimf::render::software {

/// Rounds to the nearest. Groups of pixels that are all left out by their numbers stay as they are.
void write_bytes(const RowColors& colors, const std::int32_t* numbers, std::span<imaging::Rgb> pixels);
/// Lays a color of that opacity over a pixel.
void lay_over(const Float3& color, float alpha, imaging::Rgb& pixel);

}  // namespace murosimf::render::software
